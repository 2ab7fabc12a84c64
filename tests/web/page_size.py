# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""How much a browser is given by the viewer."""

import gzip
import os


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
