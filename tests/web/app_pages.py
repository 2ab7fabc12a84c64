# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The pages of web/app for tests: the viewer, which needs nothing of WebAssembly, and how large it is; the laboratory,
with the fitter that `make test` and `make web` make; their sizes. And a folder with what is imported beside three.js."""

import gzip
import os
import shutil
import sys

k_here = os.path.dirname(os.path.abspath(__file__))
k_web = os.path.join(os.path.dirname(os.path.dirname(k_here)), "web")
sys.path.append(os.path.join(os.path.dirname(k_web), "tools", "npm"))
import npm_packages
from engines import run, skip


k_fitter = os.path.join(os.path.dirname(k_web), "build", "wasm", "openltc.wasm")


def build_laboratory(openltc, work):
    """Returns the folder of its page, below `work`; skips where there is no fitter in WebAssembly."""
    node = shutil.which("node")
    if not node:
        skip("node not found (package nodejs)")
    if not os.path.exists(k_fitter):
        skip("the fitter in WebAssembly is not there (%s); make test makes it where clang-22 is" % k_fitter)
    run(node, os.path.join(k_web, "app", "build.mjs"), openltc, k_fitter, os.path.join(work, "app"))
    return os.path.join(work, "app")


def build_packages(openltc, work):
    """Returns a folder below `work` with openltc-three and node_modules; skips where npm's packages cannot be had."""
    out = os.path.join(work, "web")
    os.makedirs(out, exist_ok=True)
    why = npm_packages.install(k_here, out)
    if why:
        skip(why)
    run(shutil.which("node"), os.path.join(k_web, "three", "build.mjs"), openltc, out + "/openltc-three")
    return out


def build_viewer(openltc, work):
    """Returns the folder of its page, below `work`; skips where npm's packages cannot be had."""
    out = build_packages(openltc, work)
    run(shutil.which("node"), os.path.join(k_web, "app", "build_viewer.mjs"), out)
    return out + "/app"


def sizes(app):
    """Bytes by gzip of each file of the pages, scenes and licences apart, by its path in them."""
    found = {}
    for folder, _, names in os.walk(app):
        for name in names:
            path = os.path.join(folder, name)
            if not name.endswith((".glb", ".txt", "LICENSE")):
                with open(path, "rb") as stream:
                    found[os.path.relpath(path, app)] = len(gzip.compress(stream.read(), 9))
    return found


def size_of_viewer(app):
    """Of what the page brings, and of what only some scenes need."""
    of_page = {name: size for name, size in sizes(app).items() if name.startswith(("viewer", "decoders")) or name == "style.css"}
    more = sum(size for name, size in of_page.items() if name.startswith(("decoders", "viewer/decoders")))
    return sum(of_page.values()) - more, more


def size_of_laboratory(app):
    """Of the page, with the fitter and one of the shaders, the largest."""
    found = {name: size for name, size in sizes(app).items() if not name.startswith(("viewer", "decoders"))}
    shaders = [size for name, size in found.items() if name.startswith("shaders")]
    return sum(found.values()) - sum(shaders) + max(shaders)
