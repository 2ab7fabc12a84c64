# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Materials of points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ._arrays import as_numpy


@dataclass
class Material:
    """glTF 2.0 with KHR_materials_specular and KHR_materials_ior. Each field is one value for all
    points, or an array of one for each: (...,), colours (..., 3). Values outside of their range are
    clamped, NaN counts as 0."""

    base_color: Any = (1.0, 1.0, 1.0)
    """Linear Rec.709, 0..1: diffuse albedo, or the reflectance of a metal."""
    metallic: Any = 0.0
    """0..1."""
    roughness: Any = 1.0
    """Perceptual, 0..1; alpha = roughness²."""
    specular: Any = 1.0
    """Strength of a dielectric's reflection, 0..1."""
    specular_color: Any = (1.0, 1.0, 1.0)
    """Its tint at normal incidence; above 1 is possible."""
    ior: Any = 1.5
    """At least 1; or 0, which reflects all."""

    def _columns(self, shape):
        """Each field as a view of (N, k) or (1, k) floats, N being the points of `shape`."""
        fields = []
        for name, width in (("base_color", 3), ("metallic", 1), ("roughness", 1), ("specular", 1),
                            ("specular_color", 3), ("ior", 1)):
            value = as_numpy(getattr(self, name), name)
            wanted = (*shape, 3) if width == 3 else shape
            if value.shape == ((3,) if width == 3 else ()):
                value = value.reshape(1, width)
            elif width == 3 and value.shape == ():
                value = np.broadcast_to(value, (1, 3))
            elif value.shape == wanted:
                value = value.reshape(-1, width)
            else:
                raise ValueError(f"{name}: the shape is {value.shape}; one value or {wanted} is wanted")
            fields.append(value)
        return fields


def rows(columns, begin, end):
    """What the library reads of points begin..end: (1, 10) or (end - begin, 10) float32."""
    count = 1 if all(len(c) == 1 for c in columns) else end - begin
    result = np.empty((count, 10), np.float32)
    at = 0
    for column in columns:
        width = column.shape[1]
        result[:, at:at + width] = column if len(column) == 1 else column[begin:end]
        at += width
    return result
