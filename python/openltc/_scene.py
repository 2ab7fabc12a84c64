# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Scenes of glTF files, and pictures of them."""

from __future__ import annotations

import math
import operator
import os
from typing import Any

from . import _openltc, lights as _lights
from ._arguments import parts, path as path_of, real, text, whole
from ._picture import Picture
from ._progress import reporter


class Scene:
    """What a glTF file holds, ready to render. Its lists are the caller's to change: lights may be
    added and removed, those of openltc.lights too; fields of lights, cameras and materials set.

    >>> scene = openltc.Scene.load("scenes/demo.glb")
    >>> len(scene.lights), len(scene.cameras)
    (5, 1)
    >>> scene.render(width=32, height=18, samples=1, shadow_samples=0).shape
    (18, 32, 3)
    """

    def __init__(self, lower):
        self._lower = lower
        self.lights: list[Any] = lower.lights()
        """Lights in nits, candela and lux, world space, metres. A material's emission is not here
        again: that a surface glows and that it lights are two things after loading."""
        self.cameras: list[Any] = lower.cameras()
        """Cameras: position, right, up, forward, fov_y_rad and so on."""
        self.materials: list[Any] = lower.materials()
        """Materials: base_color (4), metallic, roughness, emission_nits and so on; textures multiply
        them. As many as there are, in the file's order."""

    @classmethod
    def load(cls, path: str | os.PathLike[str], *, time_seconds: float | None = None, animation: str = "",
             recognise_shapes: bool = False, allow_outside: bool = False) -> Scene:
        """Reads a .glb or .gltf and what it refers to in its own folder (allow_outside: elsewhere as
        well). An animated file is posed at time_seconds of `animation`, a name or number. With
        recognise_shapes emissive meshes that are spheres, disks and cylinders become such lights."""
        time_seconds = None if time_seconds is None else real(time_seconds, "time_seconds")
        return cls(_openltc.load_scene(path_of(path), time_seconds, str(animation), bool(recognise_shapes),
                                       bool(allow_outside)))

    def scale_lights(self, factor: float) -> None:
        """Multiplies the light of all lights, whatever their unit."""
        for light in parts(self.lights, "lights", "lights"):
            for name in ("radiance_nits", "intensity_candela_per_metre", "intensity_candela_or_lux",
                         "intensity_candela", "illuminance_lux"):
                value = getattr(light, name, None)
                if value is not None:
                    setattr(light, name, tuple(factor * v for v in _lights._color(value, name)))

    @property
    def warnings(self) -> list[str]:
        """What could not be read and was spared."""
        return self._lower.warnings

    @property
    def bounds(self) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
        """Two corners, each (x, y, z) in metres."""
        return self._lower.bounds

    @property
    def triangle_count(self) -> int:
        """Triangles of all meshes."""
        return self._lower.triangle_count

    @property
    def animations(self) -> list[tuple[str, float]]:
        """Name and duration in seconds of each."""
        return self._lower.animations

    def camera(self, which: str = "", aspect: float = 16 / 9) -> _openltc.Camera:
        """The camera that `render` would take: of that name or number; "auto" frames the subject; ""
        is the file's first, or the framed one."""
        return self._lower.choose_camera(_camera_named(which), real(aspect, "aspect"))

    def render(self, width: int = 1280, height: int = 720, *, integrator: str = "ltc",
               samples: int | None = None, shadow_samples: int = 16, camera: Any = "",
               lights: str = "auto", lobes: str = "auto", specular: str = "auto",
               filter: str = "blackman-harris", light_error: float = 0.003, background_nits=None,
               seed: int = 0, threads: int = 0, window: tuple[int, int, int, int] | None = None,
               progress=False) -> Picture:
        """A picture of the scene, (height, width, 3) float32, linear Rec.709 in nits.

        integrator  ltc, the closed form; or reference, unbiased, with the layer `stderr`
        samples     camera samples per pixel: 8, of the reference 256, unless given
        shadow_samples  rays per pixel and light; 0 = no shadows
        camera      a name or number of the file's, "auto", or an openltc.Camera
        lights      auto, scene, studio, both: whose lights; auto adds a studio rig where there are none
        lobes       auto, table, polynomial, two-lobe
        specular    auto, lobe, ratio, exact, adaptive
        filter      blackman-harris or none
        light_error what the choice of lights may err by, of what points reflect
        background_nits  a number or (r, g, b) where a ray meets nothing
        window      (x0, y0, x1, y1): these pixels of the picture alone, with the values that they have in
                    it; multiples of 16, or the picture's edge
        progress    True, or a function of the share done

        The same numbers as `openltc render` with the same options. Other threads of Python go on
        meanwhile; Ctrl-C stops it.
        """
        reference = integrator == "reference"
        if background_nits is not None:
            background_nits = _lights._color(background_nits, "background_nits")
            if not all(math.isfinite(v) and v >= 0 for v in background_nits):
                raise ValueError("background_nits: finite numbers of 0 or more are wanted")
        if window is not None:
            try:
                window = tuple(whole(v, "window") for v in window)
            except TypeError:
                window = ()
            if len(window) != 4:
                raise ValueError("window: four whole numbers are wanted, (x0, y0, x1, y1)")
        words = dict(integrator=integrator, lights=lights, lobes=lobes, specular=specular, filter=filter)
        options = dict(width=whole(width, "width"), height=whole(height, "height"),
                       samples=whole(samples, "samples") if samples is not None else 256 if reference else 8,
                       shadow_samples=whole(shadow_samples, "shadow_samples"),
                       camera=camera if isinstance(camera, _openltc.Camera) else _camera_named(camera),
                       light_error=real(light_error, "light_error"), background_nits=background_nits,
                       seed=whole(seed, "seed", 0, 2**32 - 1), threads=whole(threads, "threads", 0), window=window,
                       **{name: text(word, name) for name, word in words.items()})
        own_lights = [_of_scene(light) for light in parts(self.lights, "lights", "lights of the scene or of openltc.lights")]
        materials = parts(self.materials, "materials", "materials of the scene")
        if not all(isinstance(one, _openltc.SceneMaterial) for one in materials):
            raise TypeError("materials: a material of the scene is wanted")
        with reporter(progress, "rendering") as report:
            made = self._lower.render(own_lights, materials, options, report)
        return Picture(made.pop("radiance"), made)


def _camera_named(which):
    """The library's name of a camera: what frames the subject is `auto` here and `frame` in the tool."""
    if isinstance(which, str):
        return "frame" if which == "auto" else which
    try:
        return str(operator.index(which))
    except TypeError:
        raise TypeError(f"camera={which!r}: a name, a number or an openltc.Camera is wanted") from None


def _of_scene(light):
    """A light of openltc.lights as scenes have them; one of a scene as it is."""
    return light._to_scene() if hasattr(light, "_to_scene") else light
