# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Lobes as shading reads them, and their densities over arrays."""

from __future__ import annotations

import numpy as np

from . import _openltc
from ._arrays import as_numbers, as_numpy, as_vectors
from ._fit import Fit

_built_in = ("table", "polynomial", "two-lobe")


class Lobes:
    """The fitted BRDF that surfaces are shaded with: those that come with the library, `table`,
    `polynomial` or `two-lobe`, or those of a Fit.

    >>> lobes = openltc.Lobes("table")
    >>> m, amplitude = lobes.matrix(roughness=[0.5], cos_theta=[1.0])
    >>> m.shape, amplitude.shape
    ((1, 3, 3), (1, 2))
    """

    def __init__(self, source: str | Fit = "table"):
        if isinstance(source, Fit):
            self._lower = _openltc.lobes_of_fit(source._lower)
        elif source in _built_in:
            self._lower = _openltc.built_in_lobes(_built_in.index(source))
        else:
            raise ValueError(f"lobes={source!r}: choose table, polynomial, two-lobe, or give a Fit")

    def _at(self, roughness, cos_theta):
        roughness, cos_theta = np.broadcast_arrays(np.asarray(roughness, float), np.asarray(cos_theta, float))
        first, second, rest = self._lower.at(as_numbers(roughness, "roughness")[0],
                                             as_numbers(cos_theta, "cos_theta")[0])
        return roughness.shape, first, second, rest

    def matrix(self, roughness, cos_theta):
        """M⁻¹ (..., 3, 3) and the amplitudes n1, n5 (..., 2) at each roughness, 0..1, and cosine of
        the view angle, 0..1: reflectance is F0 n1 + (F90 - F0) n5. Of two lobes those of the first."""
        shape, first, _, rest = self._at(roughness, cos_theta)
        return first.reshape(*shape, 3, 3), rest[:, :2].reshape(*shape, 2)

    def eval(self, roughness, cos_theta, wi):
        """Density (...,) of the lobe, 1/steradian, its integral over the sphere being 1, in the
        directions wi (..., 3), unit, in shading space, where wo = (sin theta, 0, cos theta); of two
        lobes of both. It is also the density of `sample`."""
        wi, shape = as_vectors(wi, "wi", np.float64)
        roughness, cos_theta = (np.broadcast_to(np.asarray(v, float), shape) for v in (roughness, cos_theta))
        _, first, second, rest = self._at(roughness, cos_theta)
        w = rest[:, 2]
        return ((1 - w) * _density(first, wi) + w * _density(second, wi)).reshape(shape)

    pdf = eval

    def sample(self, roughness, cos_theta, u):
        """Directions (..., 3) drawn from the lobe by random numbers u (..., 2) in [0, 1)."""
        u = as_numpy(u, "u").astype(float)
        if u.ndim < 1 or u.shape[-1] != 2:
            raise ValueError(f"u: the shape is {u.shape}; (..., 2) is wanted")
        if not ((u >= 0) & (u < 1)).all():
            raise _openltc.Error("u: numbers within [0, 1) are wanted")
        shape = u.shape[:-1]
        roughness, cos_theta = (np.broadcast_to(np.asarray(v, float), shape) for v in (roughness, cos_theta))
        _, first, second, rest = self._at(roughness, cos_theta)
        u = u.reshape(-1, 2)
        w = rest[:, 2]
        take_second = u[:, 0] < w
        u0 = np.where(take_second, u[:, 0] / np.where(w > 0, w, 1), (u[:, 0] - w) / np.where(w < 1, 1 - w, 1))
        r, phi = np.sqrt(u0), 2 * np.pi * u[:, 1]
        cosine = np.stack([r * np.cos(phi), r * np.sin(phi), np.sqrt(1 - u0)], -1)
        m = np.linalg.inv(np.where(take_second[:, None, None], second, first))
        wi = np.einsum("nij,nj->ni", m, cosine)
        return (wi / np.linalg.norm(wi, axis=-1, keepdims=True)).reshape(*shape, 3)


def _density(m, wi):
    """D(wi) = D_cosine(M⁻¹ wi / |M⁻¹ wi|) det M⁻¹ / |M⁻¹ wi|³ (Heitz and others 2016, equation 2)."""
    o = np.einsum("nij,nj->ni", m, wi)
    length = np.linalg.norm(o, axis=-1)
    above = o[:, 2] > 0  # nor where a direction is not finite
    return np.divide(o[:, 2] * np.linalg.det(m), np.pi * length**4, out=np.zeros(len(o)), where=above)
