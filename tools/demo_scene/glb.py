# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Writes a binary glTF 2.0 file: accessors, PNG images and the container.

Source: Khronos Group, glTF 2.0 Specification, 2021, sections 3.6 (accessors), 4 (GLB).
Every accessor has a buffer view of its own, aligned to four bytes, and carries min and max of the
values as they are stored, so a strict validator finds nothing to say.
"""

import json
import struct
import zlib

k_float, k_uint16 = 5126, 5123
k_array_buffer, k_element_array_buffer = 34962, 34963


def png(width, height, channels, rows):
    """The bytes of an 8-bit PNG; rows yields height rows of width * channels bytes."""
    raw = bytearray()
    for row in rows:
        left = bytes(channels) + row[:-channels]
        raw.append(1)  # filter "Sub": smooth textures become small numbers
        raw += bytes((a - b) & 255 for a, b in zip(row, left))

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    header = struct.pack(">IIBBBBB", width, height, 8, {1: 0, 3: 2, 4: 6}[channels], 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
            + chunk(b"IDAT", zlib.compress(bytes(raw), 9)) + chunk(b"IEND", b""))


class Glb:
    """Collects the glTF document and its one buffer; the lists are the document's own."""

    def __init__(self, asset):
        self.binary = bytearray()
        self.document = {"asset": asset}

    def add(self, kind, item):
        """Appends to a top-level array, e.g. add("nodes", {...}), and returns the index."""
        items = self.document.setdefault(kind, [])
        items.append(item)
        return len(items) - 1

    def view(self, data, target=None):
        self.binary += bytes(-len(self.binary) % 4)
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        if target:
            view["target"] = target
        self.binary += data
        return self.add("bufferViews", view)

    def vectors(self, values, kind):
        """Tuples of numbers as a float accessor of type `kind`, e.g. "VEC3"."""
        size = len(values[0])
        data = b"".join(struct.pack("<%df" % size, *value) for value in values)
        stored = list(struct.iter_unpack("<%df" % size, data))
        return self.add("accessors", {
            "bufferView": self.view(data, k_array_buffer), "componentType": k_float,
            "count": len(values), "type": kind,
            "min": [min(column) for column in zip(*stored)],
            "max": [max(column) for column in zip(*stored)]})

    def indices(self, triangles):
        flat = [i for triangle in triangles for i in triangle]
        return self.add("accessors", {
            "bufferView": self.view(struct.pack("<%dH" % len(flat), *flat), k_element_array_buffer),
            "componentType": k_uint16, "count": len(flat), "type": "SCALAR",
            "min": [min(flat)], "max": [max(flat)]})

    def texture(self, name, png_bytes):
        """A repeating, trilinearly filtered texture from the bytes of a PNG."""
        if "samplers" not in self.document:
            self.add("samplers", {"magFilter": 9729, "minFilter": 9987,
                                  "wrapS": 10497, "wrapT": 10497})
        image = self.add("images", {"name": name, "mimeType": "image/png",
                                    "bufferView": self.view(png_bytes)})
        return self.add("textures", {"name": name, "sampler": 0, "source": image})

    def to_bytes(self):
        self.binary += bytes(-len(self.binary) % 4)
        document = dict(self.document, buffers=[{"byteLength": len(self.binary)}])
        text = json.dumps(document, separators=(",", ":"), ensure_ascii=True).encode()
        text += b" " * (-len(text) % 4)
        length = 12 + 8 + len(text) + 8 + len(self.binary)
        return (struct.pack("<4sII", b"glTF", 2, length)
                + struct.pack("<I4s", len(text), b"JSON") + text
                + struct.pack("<I4s", len(self.binary), b"BIN\0") + bytes(self.binary))
