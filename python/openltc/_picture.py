# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Pictures: arrays of radiance, files, and how far two are from each other."""

from __future__ import annotations

import os
import tempfile
from typing import Any

import numpy as np

from . import _openltc
from ._arguments import path as path_of, real, text
from ._arrays import as_numpy


class Picture(np.ndarray):
    """(height, width, 3) float32, linear Rec.709, nits, and what belongs to it: an array like any other,
    which a notebook shows. What is computed from it is a plain array.

    layers      more arrays of the same size by name: `stderr`, the standard error of the reference
    info        kernel, seconds, warnings, light_error_nits
    """

    layers: dict[str, np.ndarray]
    info: dict[str, Any]

    def __new__(cls, radiance, made=None):
        self = np.asarray(radiance).view(cls)
        made = dict(made or {})
        self.layers = {name: made.pop(name) for name in ("stderr",) if name in made}
        self.info = made
        return self

    def __array_finalize__(self, source):
        self.layers, self.info = {}, {}

    def __array_wrap__(self, array, context=None, return_scalar=False):
        return np.asarray(array)[()] if array.ndim == 0 else array.view(np.ndarray)

    def save(self, path: str | os.PathLike[str], *, ev100: float | None = None, half: bool = False) -> None:
        """Writes .exr and .hdr, scene-linear, with `stderr`; or .png, exposed by `ev100`, or to suit the
        picture, and tone-mapped. half: 16-bit floats."""
        path = path_of(path)
        if os.path.splitext(path)[1].lower() not in (".exr", ".hdr", ".png"):
            raise _openltc.Error(f"{path}: a picture is written as .exr, .hdr or .png")
        ev100 = None if ev100 is None else real(ev100, "ev100")
        _openltc.write_picture(path, _plain(self), self.layers.get("stderr"), ev100, half)

    def _repr_png_(self):
        if self.ndim != 3 or self.shape[2] != 3 or self.size == 0:
            return None
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "picture.png")
            self.save(path)
            with open(path, "rb") as file:
                return file.read()


class Comparison(dict):
    """Figures by name: mean_relative, rmse, psnr, flip and so on, as `openltc compare --json` has them.
    `flip_map` is (height, width), 0..1."""

    flip_map: np.ndarray | None = None


def _plain(array):
    array = as_numpy(array, "the picture")
    if array.ndim != 3:
        raise ValueError(f"the picture: the shape is {array.shape}; (height, width, channels) is wanted")
    return np.ascontiguousarray(array, np.float32).view(np.ndarray)


def read(path: str | os.PathLike[str], layer: str = "") -> np.ndarray:
    """Reads .exr, .hdr, scene-linear, or .png, .jpg, .webp, decoded from sRGB to linear light; `layer` of
    an .exr. (height, width, channels) float32."""
    return _openltc.read_picture(path_of(path), text(layer, "layer"))


def compare(a, b, *, scene_linear: bool | None = None, ev100: float | None = None, flip: bool = True) -> Comparison:
    """How far picture `a` is from the reference `b`: arrays (height, width, 3), or paths. Both are
    radiance (HDR-FLIP over all exposures, or as displayed at `ev100`) unless scene_linear is False, or
    the files are .png, .jpg or .webp; then LDR-FLIP. Pixels that are not finite are left out and counted.

    >>> grey = np.full((16, 16, 3), 0.5, np.float32)
    >>> result = openltc.compare(grey * 1.1, grey)
    >>> round(result["mean_relative"], 3)
    0.099
    """
    if scene_linear is None:
        display = (".png", ".jpg", ".jpeg", ".webp")
        scene_linear = not any(isinstance(p, (str, os.PathLike)) and os.fspath(p).lower().endswith(display)
                               for p in (a, b))
    ev100 = None if ev100 is None else real(ev100, "ev100")
    test, reference = (read(p) if isinstance(p, (str, os.PathLike)) else p for p in (a, b))
    figures, flip_map = _openltc.compare(_plain(test)[..., :3], _plain(reference)[..., :3], bool(scene_linear), ev100, bool(flip))
    result = Comparison(figures)
    result.flip_map = None if flip_map is None else flip_map[..., 0]
    return result
