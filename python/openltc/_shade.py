# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Arrays of surface points: light without noise, and what samples and references need."""

from __future__ import annotations

import math

import numpy as np

from . import _openltc
from ._arguments import whole
from ._arrays import as_numpy, as_vectors
from ._lobes import Lobes
from ._material import Material, rows
from .lights import light_list

# Points that are worked on between two looks at Ctrl-C: what is copied at a time, too.
_part = 1 << 20


def _part_of(pairs, lights):
    """Points of so many pairs of a point and a light, which take a fraction of a second."""
    return max(min(_part, pairs // max(len(lights), 1)), 1 << 12)


class _Points:
    """Points in parts, as the library reads them. Arrays of float32 whose last axis lies side by side
    are read where they are."""

    def __init__(self, positions, normals, views, material, geometric_normals=None, position_errors=None):
        arrays = {"positions": positions, "normals": normals, "views": views}
        if geometric_normals is not None:
            arrays["geometric_normals"] = geometric_normals
        given = {name: as_numpy(array, name) for name, array in arrays.items()}
        for name, array in given.items():
            if array.ndim == 0 or array.shape[-1] != 3:
                raise ValueError(f"{name}: the shape is {array.shape}; (..., 3) is wanted")
        self.shape = max((a.shape[:-1] for a in given.values()), key=lambda s: (len(s) > 0, math.prod(s), len(s)))
        self.count = math.prod(self.shape)
        for name, array in given.items():
            if array.shape[:-1] not in (self.shape, ()):
                raise ValueError(f"{name}: the shape is {array.shape}; {(*self.shape, 3)} is wanted, as of "
                                 "the others, or (3,) for all")
        self._vectors = {name: array.reshape(-1, 3) for name, array in given.items()}
        self._errors = None
        if position_errors is not None:
            errors = as_numpy(position_errors, "position_errors")
            if errors.shape not in (self.shape, ()):
                raise ValueError(f"position_errors: the shape is {errors.shape}; {self.shape} is wanted")
            self._errors = errors.reshape(-1)
        material = Material() if material is None else material
        if not isinstance(material, Material):
            raise TypeError(f"material: openltc.Material is wanted, not {type(material).__name__}")
        self._columns = material._columns(self.shape)

    def share_memory_with(self, out):
        """Whether writing there may change a point that is still to be read."""
        arrays = [*self._vectors.values(), *self._columns, *([] if self._errors is None else [self._errors])]
        return any(np.may_share_memory(array, out) for array in arrays)

    def parts(self, size=_part):
        """(begin, end, points) one after the other."""
        for begin in range(0, self.count, size):
            end = min(begin + size, self.count)
            cut = {name: as_vectors(array if len(array) == 1 else array[begin:end], name)[0]
                   for name, array in self._vectors.items()}
            errors = self._errors
            if errors is not None:
                errors = errors if len(errors) == 1 else errors[begin:end]
                errors = np.ascontiguousarray(errors, np.float32)
            yield begin, end, _openltc.points(cut["positions"], cut["normals"], cut["views"],
                                              rows(self._columns, begin, end),
                                              cut.get("geometric_normals"), errors)


def _lobes_of(lobes):
    return (lobes if isinstance(lobes, Lobes) else Lobes(lobes))._lower


def _output(points, out):
    if out is None:
        return np.empty((points.count, 3), np.float32)
    wanted = (*points.shape, 3)
    if not isinstance(out, np.ndarray) or out.shape != wanted or out.dtype != np.float32 \
            or not out.flags.c_contiguous or not out.flags.writeable:
        raise ValueError(f"out: a writeable float32 array of shape {wanted}, in C order, is wanted")
    if points.share_memory_with(out):
        raise ValueError("out: it lies in the memory of another argument; give an array of its own")
    return out.reshape(-1, 3)


def shade(positions, normals, views, material=None, lights=(), *, lobes="table",
          geometric_normals=None, position_errors=None, threads: int = 0, out=None) -> np.ndarray:
    """Radiance that each point reflects to its viewer, of all lights together, without shadow, in
    closed form: (..., 3) float32, in the unit of the lights' radiance (nits).

    positions  (..., 3) metres, world space
    normals    (..., 3) of shading, on the viewer's side; of any length but 0
    views      (..., 3) from the point to the eye; of any length but 0
    material   openltc.Material, whose fields may be arrays too
    lights     one or several of openltc.lights
    lobes      table, polynomial, two-lobe (half the error, half as long again), a Fit or openltc.Lobes
    geometric_normals  (..., 3) of the triangles, either side: what lies behind them is hidden
    position_errors    (...,) metres by which positions may be wrong, as of a depth buffer
    threads    at most; 0 = all cores. The result does not depend on it
    out        (..., 3) float32, C order: where the result goes

    Any of the first three may be one vector, (3,), for all points. float32 arrays whose last axis is
    contiguous are read where they lie; others are converted a million points at a time. Points that
    are not finite, or have no normal or view, are black. Other threads of Python go on meanwhile.

    >>> lamp = openltc.Rectangle((0, 1, 0), (.5, 0, 0), (0, 0, .5), radiance_nits=100)
    >>> openltc.shade([[0, 0, 0]], [0, 1, 0], [[0, 1, 1]], openltc.Material(roughness=0.3), lamp).shape
    (1, 3)
    """
    points = _Points(positions, normals, views, material, geometric_normals, position_errors)
    listed, lower, radiance = light_list(lights), _lobes_of(lobes), _output(points, out)
    threads = whole(threads, "threads", 0)
    for begin, end, part in points.parts(_part_of(1 << 22, listed)):
        _openltc.shade(lower, listed, part, threads, radiance[begin:end])
    return radiance.reshape(*points.shape, 3) if out is None else out


def shade_parts(positions, normals, views, material=None, lights=(), *, lobes="table",
                geometric_normals=None, position_errors=None, threads: int = 0):
    """As `shade`, diffuse and specular apart, (..., 3) each, without lanes: for shadows multiply each
    with a ratio of its own."""
    points = _Points(positions, normals, views, material, geometric_normals, position_errors)
    listed, lower = light_list(lights), _lobes_of(lobes)
    diffuse, specular = _output(points, None), _output(points, None)
    threads = whole(threads, "threads", 0)
    for begin, end, part in points.parts(_part_of(1 << 18, listed)):
        _openltc.shade_parts(lower, listed, part, threads, diffuse[begin:end], specular[begin:end])
    return diffuse.reshape(*points.shape, 3), specular.reshape(*points.shape, 3)


def _surface(normals, views, material):
    return _Points(np.zeros(3, np.float32), normals, views, material)


def _directions(directions, points):
    rows_, shape = as_vectors(directions, "directions")
    if shape != points.shape:
        raise ValueError(f"directions: the shape is {(*shape, 3)}; {(*points.shape, 3)} is wanted, as of "
                         "the normals and views")
    return np.ascontiguousarray(rows_)


def eval(normals, views, material, directions, *, lobes="table") -> np.ndarray:
    """BRDF of a material times the cosine, (..., 3) in 1/steradian: of the microfacets themselves and
    the diffuse part, not of the fitted lobe, in `directions` (..., 3), unit, away from the surface.
    normals and views as of `shade`; at least one of them has a row for each direction."""
    return _eval(normals, views, material, directions, lobes)[0]


def pdf(normals, views, material, directions, *, lobes="table") -> np.ndarray:
    """Density (...,) per steradian with which `sample` draws each direction."""
    return _eval(normals, views, material, directions, lobes)[1]


def _eval(normals, views, material, directions, lobes):
    points = _surface(normals, _full(views, directions), material)
    given, lower = _directions(directions, points), _lobes_of(lobes)
    values, pdfs = np.empty((points.count, 3), np.float32), np.empty(points.count, np.float32)
    for begin, end, part in points.parts():
        values[begin:end], pdfs[begin:end] = _openltc.eval_surface(lower, part, given[begin:end])
    return values.reshape(*points.shape, 3), pdfs.reshape(points.shape)


def _full(views, like):
    """One view for all, as many as there are directions."""
    views, like = as_numpy(views, "views"), as_numpy(like, "directions")
    return np.broadcast_to(views, (*like.shape[:-1], 3)) if views.shape == (3,) else views


def sample(normals, views, material, u, *, lobes="table"):
    """Directions (..., 3) drawn from the BRDF by random numbers u (..., 2) in [0, 1); with them its
    value times the cosine (..., 3), the density per steradian (...,), and whether the sample counts
    (...,): where not, nothing comes from there, and it counts as 0."""
    u = np.ascontiguousarray(as_numpy(u, "u"), np.float32)
    if u.ndim < 1 or u.shape[-1] != 2:
        raise ValueError(f"u: the shape is {u.shape}; (..., 2) is wanted")
    points = _surface(normals, _full(views, u), material)
    if u.shape[:-1] != points.shape:
        raise ValueError(f"u: the shape is {u.shape}; {(*points.shape, 2)} is wanted, as of the normals and views")
    flat, lower = u.reshape(-1, 2), _lobes_of(lobes)
    raw = np.empty((points.count, 8), np.float32)
    for begin, end, part in points.parts():
        raw[begin:end] = _openltc.sample_surface(lower, part, flat[begin:end])
    return (raw[:, 0:3].reshape(*points.shape, 3), raw[:, 3:6].reshape(*points.shape, 3),
            raw[:, 6].reshape(points.shape), (raw[:, 7] != 0).reshape(points.shape))
