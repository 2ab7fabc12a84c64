#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Makes scenes/engines.glb, which the programs of this folder show: a quad and a star over a floor.

    docs/examples/engines/make_scene.py [-o FILE]

A warm panel and a cool star lean over a dark, glossy floor. The same numbers stand in each of the examples;
tests/engines compares their pictures with that of `openltc render`. Metres, +Y up. The same bytes on every run.
"""

import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "tools"))
from demo_scene import glb
from demo_scene.parts import add_mesh, facing, main

k_eye, k_target = (0.0, 1.8, 6.0), (0.0, 0.2, 0.0)
k_fov_degrees = 34.0                 # of the picture's height
k_aspect = 16 / 9

k_floor = ((0.4, 0.4, 0.4), 0.4, 0.2)   # base colour, metallic, roughness
k_floor_half = 12.0               # as far as light is seen

# Centre and half axes; both shine along half_u x half_v. The star's outline is in units of its half axes.
k_quad = ((-1.25, 0.85, -0.4), (0.6, 0.0, -0.4), (0.12, 0.7, 0.18))
k_quad_nits = (6.0, 2.1, 0.5)
k_star = ((1.2, 0.95, -0.5), (0.85, -0.15, 0.3), (0.15, 0.85, 0.0))
k_star_nits = (0.7, 2.0, 6.0)
k_star_inner = 0.45


def star_outline():
    """Ten points from the upper tip on, counter-clockwise."""
    return [((1.0 if k % 2 == 0 else k_star_inner) * math.cos(math.radians(90 + 36 * k)),
             (1.0 if k % 2 == 0 else k_star_inner) * math.sin(math.radians(90 + 36 * k))) for k in range(10)]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def flat(frame, outline, triangles):
    """An outline in a frame of centre and half axes."""
    center, u, v = frame
    n = cross(u, v)
    length = math.sqrt(sum(x * x for x in n))
    points = [tuple(c + x * a + y * b for c, a, b in zip(center, u, v)) for x, y in outline]
    return points, [tuple(x / length for x in n)] * len(points), triangles


def glow(file, name, nits):
    most = max(nits)
    return file.add("materials", {
        "name": name, "emissiveFactor": [x / most for x in nits],
        "pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1], "metallicFactor": 0},
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": most},
                       "KHR_materials_specular": {"specularFactor": 0}}})  # a lamp does not show the other


def make():
    file = glb.Glb({"version": "2.0", "generator": "OpenLTC make_scene.py", "copyright": "OpenLTC, MIT"})
    file.document["extensionsUsed"] = ["KHR_materials_emissive_strength", "KHR_materials_specular"]
    color, metallic, roughness = k_floor
    stone = file.add("materials", {"name": "floor", "pbrMetallicRoughness": {
        "baseColorFactor": list(color) + [1], "metallicFactor": metallic, "roughnessFactor": roughness}})
    square = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    split = [(0, 1, 2), (0, 2, 3)]
    # A tip between two inner corners is a triangle; the inner corners are a pentagon.
    tips = [(k, (k + 1) % 10, (k + 9) % 10) for k in range(0, 10, 2)] + [(1, 3, 5), (1, 5, 7), (1, 7, 9)]
    floor = ((0, 0, 0), (k_floor_half, 0, 0), (0, 0, -k_floor_half))
    parts = [("floor", flat(floor, square, split), stone),
             ("panel", flat(k_quad, square, split), glow(file, "panel", k_quad_nits)),
             ("star", flat(k_star, star_outline(), tips), glow(file, "star", k_star_nits))]
    for name, shape, material in parts:
        file.add("nodes", {"name": name, "mesh": add_mesh(file, name, shape, material)})
    file.add("cameras", {"type": "perspective", "perspective": {
        "yfov": math.radians(k_fov_degrees), "aspectRatio": k_aspect, "znear": 0.01}})
    file.add("nodes", {"name": "camera", "camera": 0, "translation": list(k_eye),
                       "rotation": facing(k_eye, k_target)})
    file.add("scenes", {"nodes": list(range(4))})
    file.document["scene"] = 0
    return file.to_bytes()


if __name__ == "__main__":
    main(make, __doc__.splitlines()[0], "engines.glb")
