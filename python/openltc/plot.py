# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Figures that explain the method, as SVG that a notebook shows: those of `openltc plot`, with its options
as arguments. What is a file there may be a Fit here where that is said.
"""

from __future__ import annotations

import os
import subprocess
import tempfile

from . import _openltc
from ._fit import Fit


class Figure:
    """A figure: `svg` is its text; `save` writes it; a notebook shows it."""

    def __init__(self, svg: str):
        self.svg = svg

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes it as .svg."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.svg)

    def _repr_svg_(self):
        return self.svg


def _of_tool(name, arguments, positional=()):
    tool = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bin", "openltc")
    command = [tool, "plot", name, *map(str, positional)]
    for key, value in arguments.items():
        if value is None or value is False:
            continue
        option = "--" + key.replace("_", "-")
        if value is True:
            command.append(option)
        elif key in ("norm", "sweep") and not isinstance(value, str):
            for item in value:
                command += [option, str(item)]
        else:
            command += [option, value if isinstance(value, str) else
                        ",".join(map(str, value)) if hasattr(value, "__iter__") else str(value)]
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "figure.svg")
        done = subprocess.run([*command, "--quiet", "-o", path], capture_output=True, text=True)
        if done.returncode != 0:
            raise _openltc.Error(done.stderr.strip().removeprefix("openltc: ") or f"openltc plot {name} failed")
        with open(path, encoding="utf-8") as file:
            return Figure(file.read())


def error(lobes: Fit | None = None, *, norms=(), **options) -> Figure:
    """Heat maps of the error of lobes over roughness and view angle: of a Fit, or with the options of
    `openltc plot error` (table=, against=, brdf=, ...). norms: tv, l2, peak and so on, a row each."""
    if lobes is not None:
        return Figure(_openltc.error_figure(lobes._lower, list(norms)))
    return _of_tool("error", {"norm": list(norms) or None, **options})


def fit(lobes: Fit | None = None, *, theta=(), roughness=(), **options) -> Figure:
    """BRDF, lobe and difference side by side: of a Fit, or with the options of `openltc plot fit`. theta
    in degrees, a row each; roughness 0..1, a column each."""
    if lobes is not None:
        return Figure(_openltc.fit_figure(lobes._lower, list(theta), list(roughness)))
    return _of_tool("fit", {"theta": list(theta) or None, "roughness": list(roughness) or None, **options})


def polygon(**options) -> Figure:
    """One integral in two spaces: `openltc plot polygon` (brdf=, theta=, roughness=, matrix=, points=)."""
    return _of_tool("polygon", options)


def lobes(**options) -> Figure:
    """What matrices make of a cosine: `openltc plot lobes` (matrix=, ...)."""
    return _of_tool("lobes", options)


def point(**options) -> Figure:
    """One point light, exact and by lobes: `openltc plot point` (theta=, roughness=, ...)."""
    return _of_tool("point", options)


def photometry(path: str | os.PathLike[str], **options) -> Figure:
    """The polar diagram of a photometric file: `openltc plot photometry`."""
    return _of_tool("photometry", options, [os.fspath(path)])
