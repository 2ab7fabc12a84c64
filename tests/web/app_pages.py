# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The pages of web/app for tests: the viewer, which needs nothing of WebAssembly, and how large it is; the laboratory,
with the fitter that `make web` has made."""

import gzip
import os
import shutil
import sys

k_here = os.path.dirname(os.path.abspath(__file__))
k_web = os.path.join(os.path.dirname(os.path.dirname(k_here)), "web")
sys.path.append(os.path.join(os.path.dirname(k_web), "tools", "npm"))
import npm_packages
from engines import run, skip


k_fitter = os.path.join(os.path.dirname(k_web), "out", "web", "openltc")


def build_laboratory(openltc, work):
    """Returns the folder of its page, below `work`; skips where there is no fitter in WebAssembly."""
    node = shutil.which("node")
    if not node:
        skip("node not found (package nodejs)")
    if not os.path.exists(os.path.join(k_fitter, "openltc.wasm")):
        skip("the fitter in WebAssembly is not there (%s); make web makes it" % k_fitter)
    run(node, os.path.join(k_web, "app", "build.mjs"), openltc, k_fitter, os.path.join(work, "app"))
    return os.path.join(work, "app")


def build_viewer(openltc, work):
    """Returns the folder of its page, below `work`; skips where npm's packages cannot be had."""
    out = os.path.join(work, "web")
    os.makedirs(out, exist_ok=True)
    why = npm_packages.install(k_here, out)
    if why:
        skip(why)
    node = shutil.which("node")
    run(node, os.path.join(k_web, "three", "build.mjs"), openltc, out + "/openltc-three")
    run(node, os.path.join(k_web, "app", "build_viewer.mjs"), out)
    return out + "/app"


def size_of(app):
    """Bytes by gzip: of what the page brings, and of what only some scenes need."""
    page, more = 0, 0
    for folder, _, names in os.walk(app):
        for name in names:
            path = os.path.join(folder, name)
            inside = os.path.relpath(path, app)
            if not (inside.startswith(("viewer", "decoders")) or inside == "style.css") or name.endswith(".txt"):
                continue
            with open(path, "rb") as stream:
                size = len(gzip.compress(stream.read(), 9))
            if inside.startswith("decoders"):
                more += size
            else:
                page += size
    return page, more
