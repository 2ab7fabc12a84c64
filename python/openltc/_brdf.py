# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The library's BRDFs over arrays."""

from __future__ import annotations

import os

import numpy as np

from . import _openltc, _shade
from ._arrays import as_vectors
from ._fit import brdfs
from ._material import Material


class Brdf:
    """A BRDF by its name (openltc.brdfs()) or of a measured file, as a function over arrays.

    >>> f = openltc.Brdf("ggx")
    >>> wo = wi = [[0.0, 0.0, 1.0]]
    >>> f(wo, wi, 1.0).round(4)
    array([0.0796])
    """

    def __init__(self, name: str | os.PathLike[str]):
        self.name = os.fspath(name)
        _openltc.eval_brdf(self.name, np.empty((0, 3)), np.empty((0, 3)), np.empty(0))
        self.__name__ = self.name
        self.about: dict[str, str] = next((b for b in brdfs() if b["name"] == self.name), {})

    def parts(self, wo, wi, roughness):
        """f cos_i for F = 1, and its part weighted with (1 - wo.h)^5: f cos_i = F0 a + (F90 - F0) b.
        wo, wi (..., 3), unit, shading space, away from the surface; roughness (...,) or one number,
        0..1. Each result is (...,), 1/steradian; 0 below the surface."""
        wo, wo_shape = as_vectors(wo, "wo", np.float64)
        wi, wi_shape = as_vectors(wi, "wi", np.float64)
        shape = np.broadcast_shapes(wo_shape, wi_shape, np.shape(roughness))
        full = [np.ascontiguousarray(np.broadcast_to(a.reshape(*s, 3), (*shape, 3))).reshape(-1, 3)
                for a, s in ((wo, wo_shape), (wi, wi_shape))]
        r = np.ascontiguousarray(np.broadcast_to(np.asarray(roughness, float), shape)).reshape(-1)
        scale, bias = _openltc.eval_brdf(self.name, *full, r)
        return scale.reshape(shape), bias.reshape(shape)

    def __call__(self, wo, wi, roughness):
        """f for F = 1 in 1/steradian, without the cosine; shapes as of `parts`. What openltc.fit
        calls."""
        scale, _ = self.parts(wo, wi, roughness)
        cosine = np.asarray(wi, float)[..., 2]
        return np.divide(scale, cosine, out=np.zeros_like(scale), where=np.broadcast_to(cosine, scale.shape) > 0)

    def sample(self, wo, roughness, u):
        """Directions (..., 3) that suit any BRDF, drawn by random numbers u (..., 2) in [0, 1): in part from GGX
        of that roughness, in part from the cosine; and their densities per steradian (...,), 0 for one that
        leads below the surface and counts as 0. wo (..., 3) and roughness as of `parts`. Over u the mean of
        `parts(wo, wi, roughness)[0] / density` is the albedo."""
        wi, _, density, counts = _shade.sample(_up, wo, _between(roughness), u)
        return wi, np.where(counts, density, 0)

    def pdf(self, wo, wi, roughness):
        """Density (...,) per steradian with which `sample` draws wi."""
        return _shade.pdf(_up, wo, _between(roughness), wi)

    def __repr__(self):
        return f"openltc.Brdf({self.name!r})"


_up = np.float32([0, 0, 1])


def _between(roughness):
    """A material that both reflects and scatters, by which directions are drawn."""
    return Material(metallic=0.5, roughness=roughness)
