# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Physically based area lights by linearly transformed cosines.

Fit a BRDF, shade arrays of points, render scenes. docs/python.md tells it in order; every function
says the shapes and units of its arrays. Everywhere: world space in metres, directions away from the
surface, colours linear Rec.709, radiance in nits (cd/m2).

>>> import openltc
>>> openltc.__version__
'0.1.0'
"""

import importlib

TYPE_CHECKING = False  # but for editors and type checkers, which see here what is loaded when it is asked for
if TYPE_CHECKING:
    from . import cluster, lights, plot
    from ._brdf import Brdf
    from ._fit import Fit, Report, brdfs, engines, fit, layouts
    from ._lobes import Lobes
    from ._material import Material
    from ._openltc import Camera, Error
    from ._picture import Comparison, Picture, compare, read
    from ._scene import Scene
    from ._shade import eval, pdf, sample, shade, shade_parts
    from .lights import Directional, Disk, Ellipse, Line, Point, Polygon, Rectangle, Sphere, Spot, Tube

    __version__: str

_places = {
    "fit": "_fit",
    "Fit": "_fit",
    "Report": "_fit",
    "brdfs": "_fit",
    "engines": "_fit",
    "layouts": "_fit",
    "Brdf": "_brdf",
    "Lobes": "_lobes",
    "shade": "_shade",
    "shade_parts": "_shade",
    "eval": "_shade",
    "pdf": "_shade",
    "sample": "_shade",
    "Material": "_material",
    "Scene": "_scene",
    "Picture": "_picture",
    "Comparison": "_picture",
    "compare": "_picture",
    "read": "_picture",
    "Rectangle": "lights",
    "Polygon": "lights",
    "Disk": "lights",
    "Ellipse": "lights",
    "Sphere": "lights",
    "Tube": "lights",
    "Line": "lights",
    "Point": "lights",
    "Spot": "lights",
    "Directional": "lights",
}
_modules = ("cluster", "lights", "plot")

_lower = ("Error", "Camera", "__version__")

__all__ = [*_places, *_modules, *_lower]


def _load(name):
    """Loads what is asked for when it is: `import openltc` alone takes a few milliseconds."""
    if name in _places:
        value = getattr(importlib.import_module(f"{__name__}.{_places[name]}"), name)
    elif name in _modules:
        value = importlib.import_module(f"{__name__}.{name}")
    elif name in _lower:
        value = getattr(importlib.import_module(f"{__name__}._openltc"), name)
    else:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    globals()[name] = value
    return value


if not TYPE_CHECKING:
    __getattr__ = _load


def __dir__():
    return sorted(__all__)
