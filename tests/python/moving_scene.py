# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The demo scene with an animation: its camera rises by 0.5 m in 4 s, and back."""

import json
import os
import struct

k_demo = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scenes", "demo.glb")


def chunk(kind, data, filler):
    data += filler * (-len(data) % 4)
    return struct.pack("<I4s", len(data), kind) + data


def write_moving_scene(path, height=0.5, source=k_demo):
    """A .glb whose first camera's node moves; returns the path."""
    with open(source, "rb") as file:
        glb = file.read()
    json_length, = struct.unpack_from("<I", glb, 12)
    root = json.loads(glb[20:20 + json_length])
    binary_length, = struct.unpack_from("<I", glb, 20 + json_length)
    binary = bytearray(glb[28 + json_length:28 + json_length + binary_length])
    node = next(i for i, n in enumerate(root["nodes"]) if "camera" in n)
    at = root["nodes"][node].get("translation", [0, 0, 0])
    times = struct.pack("<3f", 0, 2, 4)
    places = struct.pack("<9f", *at, at[0], at[1] + height, at[2], *at)
    accessors = []
    for data, kind in ((times, "SCALAR"), (places, "VEC3")):
        binary += b"\0" * (-len(binary) % 4)
        root["bufferViews"].append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data)})
        binary += data
        accessor = {"bufferView": len(root["bufferViews"]) - 1, "componentType": 5126, "count": 3, "type": kind}
        if kind == "SCALAR":
            accessor.update(min=[0], max=[4])
        accessors.append(len(root["accessors"]))
        root["accessors"].append(accessor)
    root["buffers"][0]["byteLength"] = len(binary)
    root["animations"] = [{
        "name": "rise",
        "samplers": [{"input": accessors[0], "output": accessors[1]}],
        "channels": [{"sampler": 0, "target": {"node": node, "path": "translation"}}],
    }]
    body = chunk(b"JSON", json.dumps(root).encode(), b" ") + chunk(b"BIN\0", bytes(binary), b"\0")
    with open(path, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body)
    return path
