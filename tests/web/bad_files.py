# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Files that the viewer refuses."""

import json
import os
import struct


def glb_of(document):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    return struct.pack("<4sIIII", b"glTF", 2, 20 + len(text), len(text), 0x4E4F534A) + text


def bad_files(work):
    """Files that are none, each with a word of what is said of it."""
    files = {"words.glb": (b"These are words.", "no glTF file"),
             "needs.glb": (glb_of({"asset": {"version": "2.0"}, "extensionsRequired": ["EXT_no_such"]}), "EXT_no_such"),
             "old.glb": (struct.pack("<4sII", b"glTF", 1, 12), "version 1"),
             "beside.glb": (glb_of({"asset": {"version": "2.0"}, "buffers": [{"uri": "beside.bin", "byteLength": 4}]}), "beside.bin")}
    with open(os.path.join(work, "rect.glb"), "rb") as stream:
        files["cut.glb"] = (stream.read()[:3000], "cut off")
    for name, (data, _) in files.items():
        with open(os.path.join(work, name), "wb") as stream:
            stream.write(data)
    with open(os.path.join(work, "large.glb"), "wb") as stream:
        stream.truncate(300 << 20) # of no block of the disk
    return [(os.path.join(work, name), word) for name, (_, word) in files.items()] + [(work + "/large.glb", "too large")]
