# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Fitting lobes to a BRDF: a name, a measured file, or a function over arrays."""

from __future__ import annotations

import html as _html
import json
import os
from typing import Any, Callable

import numpy as np

from . import _openltc
from ._arguments import path as path_of, text, whole
from ._progress import reporter


def brdfs() -> list[dict[str, str]]:
    """The BRDFs that are known by name, each with name, variant, source and parameter.

    >>> [b["name"] for b in openltc.brdfs()][:3]
    ['ggx', 'ggx-separable', 'ggx-ms']
    """
    return _openltc.brdfs()


def engines() -> list[dict[str, Any]]:
    """The engines that tables can be made for: name, title, layout, size, precision, files, place.

    >>> sorted(e["name"] for e in openltc.engines())[0]
    'babylon'
    """
    return _openltc.engines()


def layouts() -> list[str]:
    """The layouts of tables by name.

    >>> openltc.layouts()
    ['native', 'ltc_code', 'unity', 'godot', 'o3de']
    """
    return _openltc.layouts()


def _arrays_of(library):
    """How a NumPy array becomes one of that library."""
    if library == "numpy":
        return lambda array: array
    if library == "torch":
        import torch

        return torch.from_dlpack
    if library == "jax":
        import jax.numpy

        return jax.numpy.asarray
    raise ValueError(f"arrays={library!r}: choose numpy, torch or jax")


def _over_arrays(function, library):
    """The caller's function, held to what is asked of it."""
    convert = _arrays_of(library)

    def call(wo, wi, roughness):
        values = function(convert(wo), convert(wi), roughness)
        if type(values) is not np.ndarray:
            if values is None:
                raise TypeError("the BRDF returned None; an array of one value for each direction is wanted")
            from ._arrays import as_numpy

            values = as_numpy(values, "the value of the BRDF")
        if values.shape != (len(wi),):
            raise ValueError(f"the BRDF returned the shape {values.shape} for {len(wi)} directions; "
                             f"({len(wi)},) is wanted")
        if values.dtype != np.float64 or not values.flags.c_contiguous:
            if values.dtype.kind == "c":
                raise TypeError("the BRDF returned complex numbers; return their real part")
            if values.dtype.kind not in "fiub":
                raise TypeError(f"the BRDF returned {values.dtype}; numbers are wanted")
            values = np.ascontiguousarray(values, np.float64)
        return values

    return call


def fit(brdf: str | os.PathLike[str] | Callable[..., Any] = "ggx", size: int | None = None,
        objective: str = "balanced", form: str = "table", layout: str = "native", *,
        engine: str | None = None, precision: str = "float32", degree: int = 4, refine: str = "auto",
        clip_aware: bool = False, name: str | None = None, narrow: bool = True,
        has_roughness: bool = True, arrays: str = "numpy",
        progress: bool | Callable[[float], Any] = False) -> Fit:
    """Fits lobes to a BRDF. Runs on all cores; other threads of Python go on; Ctrl-C stops it.

    brdf       a name (openltc.brdfs()), the path of a measured material (MERL, .binary), or a
               function f(wo, wi, roughness) over arrays: wo and wi are (N, 3) float64, unit, away
               from the surface, z along its normal, both above it; roughness is one float, 0..1.
               It returns (N,) numbers: the BRDF in 1/steradian, without the cosine, isotropic,
               finite and not negative. It is called in the thread that called fit.
    size       nodes per axis of a table, 2..512; 64 unless given, 32 of two lobes
    objective  what is minimised: balanced, tv, l2, l3 or "TV,L2,L3", three weights
    form       table, polynomial, two-lobe, two-lobe-polynomial
    layout     whose look-up reads the table: openltc.layouts()
    engine     make the table that this engine ships: openltc.engines(); it chooses size, layout,
               precision
    precision  float32 or float16: of the numbers that are stored
    degree     of the polynomials, 3..6
    refine     auto, on, off: all nodes once more, jointly
    clip_aware for other layouts than native: for a renderer that clips lights at the horizon
    name       of a function, in files and messages; its __name__ unless given
    narrow     of a function: its lobe becomes a mirror as roughness vanishes (alpha is factored
               out); False for diffuse reflection and sheen
    has_roughness  of a function: False where it ignores roughness, for a table of one column
    arrays     what a function takes: numpy, torch or jax arrays (jax in double precision:
               jax_enable_x64). What it returns may be of any of them, on the CPU
    progress   True: a bar (of tqdm where it is installed); or a function of the share done, 0..1

    Raises openltc.Error with what the tool would say; what the function raises goes through.

    >>> lobes = openltc.fit("ggx", size=8)
    >>> lobes.arrays[0].shape
    (8, 8, 4)
    >>> def lambert(wo, wi, roughness):
    ...     return np.full(len(wi), 1 / np.pi)
    >>> openltc.fit(lambert, size=8, narrow=False, has_roughness=False).metadata["brdf"]
    'lambert'
    """
    if callable(brdf):
        given = _over_arrays(brdf, arrays)
        name = name or getattr(brdf, "__name__", type(brdf).__name__)
    elif isinstance(brdf, (str, bytes, os.PathLike)):
        given = path_of(brdf, "brdf")
        name = name or given
    else:
        raise TypeError(f"brdf: a name, the path of a file, or a function is wanted, not {type(brdf).__name__}")
    size = None if size is None else whole(size, "size")
    words = dict(name=name, objective=objective, form=form, layout=layout, precision=precision, refine=refine)
    for word, value in words.items():
        text(value, word)
    if engine is not None:
        text(engine, "engine")
    with reporter(progress, f"fitting {name}") as report:
        return Fit(_openltc.fit(given, narrow=bool(narrow), has_roughness=bool(has_roughness), size=size,
                                degree=whole(degree, "degree"), engine=engine, clip_aware=bool(clip_aware),
                                progress=report, **words))


class Fit:
    """Lobes that were fitted: what openltc.fit returns."""

    def __init__(self, lower):
        self._lower = lower

    @property
    def arrays(self) -> list[np.ndarray]:
        """What is stored, float32. A table: its textures, each (rows, columns, channels), a row for
        each view angle, a column for each roughness. A polynomial: its terms, (terms, 8), and (terms,
        4) of the second lobe where there is one. docs/fitting.md says what the channels are."""
        return self._lower.arrays()

    @property
    def metadata(self) -> dict[str, Any]:
        """What the files say of themselves: brdf, variant, objective, horizon, command, tool_version,
        mean_tv and max_tv, the mean and largest total variation, 0..1, for roughness 0.06 to 1."""
        self._lower.measure(False, None)
        return self._lower.metadata()

    @property
    def notes(self) -> str:
        """What there is to say of the lobes besides: proofs, warnings, sizes; lines, or empty."""
        return self._lower.notes()

    @property
    def seconds(self) -> float:
        """Time that the fit took, s."""
        return self._lower.seconds

    @property
    def report(self) -> Report:
        """Every figure of the error, measured when it is first asked for. Of a function of the
        caller's the random rectangles are left out, which would take it too many calls."""
        self._lower.measure(True, None)
        return Report(self._lower.text(), self._lower.json(), self._lower.html())

    def save(self, path: str | os.PathLike[str]) -> list[str]:
        """Writes the lobes; the container by extension, as `openltc fit -o`: .json .dds .ktx2 .exr
        .npy .h .glsl .hlsl .wgsl .js. Of engine= `path` is a folder. Returns the paths that were
        written: all of them, or none where something fails."""
        return self._lower.save(path_of(path), None)

    def to_texture(self, engine: str | None = None, layout: str = "native", precision: str = "float32",
                   size: int | None = None) -> list[np.ndarray]:
        """The table as an engine reads it: its textures, each (rows, columns, channels), float32, or
        float16 where the engine stores halves.

        Packed, and where size or axes differ resampled, from the nodes that were fitted; fit with
        engine= for what that engine's look-up does between them.

        >>> [t.shape for t in openltc.fit("ggx", size=8).to_texture(layout="ltc_code")]
        [(8, 8, 4), (8, 8, 4)]
        """
        textures = self._lower.textures(engine, layout, precision, size)
        if engine is not None:
            precision = next(e["precision"] for e in engines() if e["name"] == engine)
        return [t.astype(np.float16) if precision == "float16" else t for t in textures]

    def __repr__(self):
        shapes = ", ".join(str(a.shape) for a in self.arrays)
        return f"<openltc.Fit of {self._lower.brdf}: {shapes}>"

    def _repr_html_(self):
        return self.report._repr_html_()


class Report:
    """The error of fitted lobes: `str` gives the tool's short table, a notebook shows the page."""

    def __init__(self, text, data, html):
        self.text: str = text
        self.data: dict[str, Any] = json.loads(data)
        self.html: str = html

    def __str__(self):
        return self.text

    def __repr__(self):
        return self.text

    def _repr_html_(self):
        return ('<iframe style="width:100%;height:640px;border:0" sandbox="allow-scripts" '
                f'srcdoc="{_html.escape(self.html)}"></iframe>')
