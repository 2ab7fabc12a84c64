#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Makes the worst case of one lobe: a metal floor, seen at a grazing angle, behind it a rectangle light.

    tools/make_metal_floor.py OUTPUT.glb ROUGHNESS DEGREES ASIDE

The camera looks at the middle of the floor, DEGREES from its normal, through a narrow lens, so that
the angle is nearly the same all over the picture; the light stands where the mirror image is, and ASIDE metres to the right of that.
"""

import math
import sys

from demo_scene import glb
from demo_scene.parts import add_mesh, facing

k_half_width = 30.0          # metres, of the floor
k_distance = 4.0             # of the camera and of the light from the middle
k_fov_degrees = 6.0          # of the picture's height
k_light = (1.6, 1.0)         # width and height, metres
k_light_nits = 1000


def make(roughness, degrees, aside):
    file = glb.Glb({"version": "2.0", "generator": "tools/make_metal_floor.py"})
    metal = file.add("materials", {"name": "metal", "pbrMetallicRoughness": {
        "baseColorFactor": [0.9, 0.9, 0.9, 1], "metallicFactor": 1, "roughnessFactor": roughness}})
    positions = [(-k_half_width, 0.0, k_half_width), (k_half_width, 0.0, k_half_width),
                 (k_half_width, 0.0, -k_half_width), (-k_half_width, 0.0, -k_half_width)]
    floor = add_mesh(file, "floor", (positions, [(0.0, 1.0, 0.0)] * 4, [(0, 1, 2), (0, 2, 3)]), metal)
    angle = math.radians(degrees)
    eye = (0.0, k_distance * math.cos(angle), k_distance * math.sin(angle))
    light = (aside, eye[1] + k_light[1] / 2, -eye[2])
    file.add("cameras", {"type": "perspective", "perspective": {
        "yfov": math.radians(k_fov_degrees), "znear": 0.01}})
    file.add("nodes", {"name": "floor", "mesh": floor})
    file.add("nodes", {"name": "camera", "camera": 0, "translation": list(eye),
                       "rotation": list(facing(eye, (0.0, 0.0, 0.0)))})
    file.add("nodes", {"name": "light", "translation": list(light),
                       "rotation": list(facing(light, (light[0], light[1], 0.0))),
                       "extras": {"openltc_light": {"type": "rect", "width": k_light[0], "height": k_light[1],
                                                    "luminance_nits": k_light_nits}}})
    file.add("scenes", {"nodes": [0, 1, 2]})
    file.document["scene"] = 0
    return file.to_bytes()


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    with open(sys.argv[1], "wb") as stream:
        stream.write(make(float(sys.argv[2]), float(sys.argv[3]), float(sys.argv[4])))


main()
