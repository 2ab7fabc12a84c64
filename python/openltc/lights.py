# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Lights over arrays of points, with their units in their names.

Positions and lengths in metres, world space. A colour is three numbers, linear Rec.709, or one for
all three. What cannot be shaded is refused, with the reason, when openltc.shade takes it.

>>> lamp = openltc.Rectangle(center=(0, 1, 0), half_u=(.5, 0, 0), half_v=(0, 0, .5), radiance_nits=100)
>>> lamp.radiance_nits
100
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Sequence, Union

from . import _openltc
from ._arguments import real

Vector = Sequence[float]
Color = Union[float, Sequence[float]]


def _vector(value, name):
    try:
        numbers = tuple(float(v) for v in value)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: three numbers are wanted, not {value!r}") from None
    if len(numbers) != 3:
        raise ValueError(f"{name}: three numbers are wanted, not {len(numbers)}")
    return numbers


def _color(value, name):
    if hasattr(value, "__len__"):
        return _vector(value, name)
    return (real(value, name),) * 3


def _cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _unit(v, name):
    length = math.sqrt(sum(x * x for x in v))
    if not (length > 0 and math.isfinite(length)):
        raise ValueError(f"{name}: it has no direction")
    return [x / length for x in v]


def _emitter(light, of):
    """A light of a scene, with what the small class beside it has; light_list says what is wrong with it."""
    light_list([of])
    light.radiance_nits = _color(of.radiance_nits, "radiance_nits")
    light.two_sided = getattr(of, "two_sided", False)
    return light


def _punctual(kind, intensity, range_metres):
    light = _openltc.PunctualLight()
    light.type, light.range_metres = kind, range_metres
    light.intensity_candela_or_lux = _color(intensity, "intensity")
    return light


@dataclass
class Rectangle:
    """A rectangle or parallelogram. half_u and half_v lead from the centre to the middles of two
    neighbouring sides; it emits along half_u x half_v."""

    center: Vector
    half_u: Vector
    half_v: Vector
    radiance_nits: Color
    two_sided: bool = False

    def _add(self, to):
        to.rectangle(_vector(self.center, "center"), _vector(self.half_u, "half_u"),
                     _vector(self.half_v, "half_v"), self.two_sided,
                     _color(self.radiance_nits, "radiance_nits"))

    def _to_scene(self):
        c, u, v = (_vector(w, "rectangle") for w in (self.center, self.half_u, self.half_v))
        corners = [tuple(c[k] + a * u[k] + b * v[k] for k in range(3)) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        return Polygon(corners, self.radiance_nits, two_sided=self.two_sided)._to_scene()


@dataclass
class Polygon:
    """A planar outline of three vertices or more, convex or concave, counter-clockwise as seen from
    where it emits to; `holes` are more outlines, clockwise."""

    vertices: Sequence[Vector]
    radiance_nits: Color
    holes: Sequence[Sequence[Vector]] = field(default_factory=tuple)
    two_sided: bool = False

    def _add(self, to):
        vertices, ends = [], []
        for ring in (self.vertices, *self.holes):
            vertices += [_vector(v, "vertices") for v in ring]
            ends.append(len(vertices))
        to.polygon(vertices, ends, self.two_sided, _color(self.radiance_nits, "radiance_nits"))

    def _to_scene(self):
        light = _emitter(_openltc.PolygonLight(), self)
        vertices, ends = [], []
        for ring in (self.vertices, *self.holes):
            vertices += [_vector(v, "vertices") for v in ring]
            ends.append(len(vertices))
        light.vertices, light.ring_ends = vertices, ends
        area = [0.0, 0.0, 0.0]  # Newell's formula
        ring = vertices[:ends[0]]
        for p, q in zip(ring, ring[1:] + ring[:1]):
            for k in range(3):
                i, j = (k + 1) % 3, (k + 2) % 3
                area[k] += (p[i] - q[i]) * (p[j] + q[j])
        light.normal = _unit(area, "vertices")
        return light


@dataclass
class Ellipse:
    """A flat ellipse of perpendicular semi-axes half_u and half_v; emits along half_u x half_v."""

    center: Vector
    half_u: Vector
    half_v: Vector
    radiance_nits: Color
    two_sided: bool = False

    def _add(self, to):
        to.ellipse(_vector(self.center, "center"), _vector(self.half_u, "half_u"),
                   _vector(self.half_v, "half_v"), self.two_sided,
                   _color(self.radiance_nits, "radiance_nits"))

    def _to_scene(self):
        light = _emitter(_openltc.EllipseLight(), self)
        light.center = _vector(self.center, "center")
        light.half_u, light.half_v = _vector(self.half_u, "half_u"), _vector(self.half_v, "half_v")
        return light


@dataclass
class Disk:
    """A disk, which emits along `normal`."""

    center: Vector
    normal: Vector
    radius_metres: float
    radiance_nits: Color
    two_sided: bool = False

    def _add(self, to):
        to.disk(_vector(self.center, "center"), _vector(self.normal, "normal"), self.radius_metres,
                self.two_sided, _color(self.radiance_nits, "radiance_nits"))

    def _to_scene(self):
        n = _unit(_vector(self.normal, "normal"), "normal")
        k = min(range(3), key=lambda i: abs(n[i]))
        u = _unit(_cross([float(i == k) for i in range(3)], n), "normal")
        r = self.radius_metres
        return Ellipse(self.center, [r * x for x in u], [r * x for x in _cross(n, u)], self.radiance_nits,
                       self.two_sided)._to_scene()


@dataclass
class Sphere:
    """A sphere, which emits outwards."""

    center: Vector
    radius_metres: float
    radiance_nits: Color

    def _add(self, to):
        to.sphere(_vector(self.center, "center"), self.radius_metres,
                  _color(self.radiance_nits, "radiance_nits"))

    def _to_scene(self):
        light = _emitter(_openltc.SphereLight(), self)
        light.center, light.radius_metres = _vector(self.center, "center"), self.radius_metres
        return light


@dataclass
class Tube:
    """A round tube between the ends of its axis; caps: none, flat (a cylinder), round (a capsule)."""

    start: Vector
    end: Vector
    radius_metres: float
    radiance_nits: Color
    caps: str = "round"

    def _add(self, to):
        kinds = ("none", "flat", "round")
        if self.caps not in kinds:
            raise ValueError(f"caps={self.caps!r}: choose none, flat or round")
        to.tube(_vector(self.start, "start"), _vector(self.end, "end"), self.radius_metres,
                kinds.index(self.caps), _color(self.radiance_nits, "radiance_nits"))

    def _to_scene(self):
        light = _emitter(_openltc.TubeLight(), self)
        light.start, light.end = _vector(self.start, "start"), _vector(self.end, "end")
        light.radius_metres, light.caps = self.radius_metres, ("none", "flat", "round").index(self.caps)
        return light


@dataclass
class Line:
    """A tube without a width: a thin tube's radiance times its diameter."""

    start: Vector
    end: Vector
    intensity_candela_per_metre: Color

    def _add(self, to):
        to.line(_vector(self.start, "start"), _vector(self.end, "end"),
                _color(self.intensity_candela_per_metre, "intensity_candela_per_metre"))

    def _to_scene(self):
        light = _openltc.LineLight()
        light.start, light.end = _vector(self.start, "start"), _vector(self.end, "end")
        light.intensity_candela_per_metre = _color(self.intensity_candela_per_metre, "intensity_candela_per_metre")
        return light


@dataclass
class Point:
    """A point; range_metres: from where it has faded to nothing, 0 = never."""

    position: Vector
    intensity_candela: Color
    range_metres: float = 0.0

    def _add(self, to):
        to.point(_vector(self.position, "position"), _color(self.intensity_candela, "intensity_candela"),
                 self.range_metres)

    def _to_scene(self):
        light = _punctual("point", self.intensity_candela, self.range_metres)
        light.position = _vector(self.position, "position")
        return light


@dataclass
class Spot:
    """A spot that shines along `direction`: all of it within the inner angle of the axis, none
    outside of the outer one; 0 <= inner <= outer <= 90 degrees."""

    position: Vector
    direction: Vector
    intensity_candela: Color
    inner_angle_degrees: float = 0.0
    outer_angle_degrees: float = 45.0
    range_metres: float = 0.0

    def _add(self, to):
        if not 0 <= self.inner_angle_degrees <= self.outer_angle_degrees <= 90:
            raise ValueError("not 0 <= inner_angle_degrees <= outer_angle_degrees <= 90")
        to.spot(_vector(self.position, "position"), _vector(self.direction, "direction"),
                _color(self.intensity_candela, "intensity_candela"), self.range_metres,
                math.radians(self.inner_angle_degrees), math.radians(self.outer_angle_degrees))

    def _to_scene(self):
        light = _punctual("spot", self.intensity_candela, self.range_metres)
        light.position = _vector(self.position, "position")
        light.direction = _unit(_vector(self.direction, "direction"), "direction")
        light.cos_inner = math.cos(math.radians(self.inner_angle_degrees))
        light.cos_outer = math.cos(math.radians(self.outer_angle_degrees))
        return light


@dataclass
class Directional:
    """Light from far away that travels along `direction`; lux on a surface that faces it."""

    direction: Vector
    illuminance_lux: Color

    def _add(self, to):
        to.directional(_vector(self.direction, "direction"), _color(self.illuminance_lux, "illuminance_lux"))

    def _to_scene(self):
        light = _punctual("directional", self.illuminance_lux, 0.0)
        light.direction = _unit(_vector(self.direction, "direction"), "direction")
        return light


def light_list(lights):
    """One light or several, as the library has them; errors say which."""
    if hasattr(lights, "_add"):
        lights = [lights]
    if not hasattr(lights, "__iter__"):
        raise TypeError(f"lights: one or several lights of openltc.lights are wanted, not {type(lights).__name__}")
    result = _openltc.LightList()
    for i, light in enumerate(lights):
        if not hasattr(light, "_add"):
            raise TypeError(f"lights[{i}]: a light of openltc.lights is wanted, not {type(light).__name__}")
        try:
            light._add(result)
        except (TypeError, ValueError) as error:
            raise type(error)(f"lights[{i}], {type(light).__name__}: {error}") from None
    return result
