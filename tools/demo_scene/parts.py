# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""What the scripts that make scenes share: meshes, directions, and the file at the end."""

import argparse
import math
import os
import sys

from demo_scene import shapes


def add_mesh(file, name, shape, material, tangents=None, tex_coords=None):
    positions, normals, triangles = shape
    attributes = {"POSITION": file.vectors(positions, "VEC3"),
                  "NORMAL": file.vectors(normals, "VEC3")}
    if tangents:
        attributes["TANGENT"] = file.vectors(tangents, "VEC4")
    if tex_coords:
        attributes["TEXCOORD_0"] = file.vectors(tex_coords, "VEC2")
    return file.add("meshes", {"name": name, "primitives": [
        {"attributes": attributes, "indices": file.indices(triangles), "material": material}]})


def facing(position, target):
    """The rotation (x, y, z, w) that turns local -Z from position to target, without roll."""
    forward = shapes.normalize([t - p for p, t in zip(position, target)])
    yaw = math.atan2(-forward[0], -forward[2])
    pitch = math.asin(forward[1])
    cy, sy, cp, sp = math.cos(yaw / 2), math.sin(yaw / 2), math.cos(pitch / 2), math.sin(pitch / 2)
    return [cy * sp, sy * cp, -sy * sp, cy * cp]


def main(make, description, default_name):
    """The command line of a script whose make() returns the bytes of a scene."""
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("-o", "--output", default=os.path.join(root, "scenes", default_name))
    output = parser.parse_args().output
    data = make()
    try:
        with open(output + ".part", "wb") as stream:
            stream.write(data)
        os.replace(output + ".part", output)
    except OSError as error:
        sys.exit("%s: cannot be written: %s" % (output, error.strerror))
    print("%s: %.2f MB" % (output, len(data) / 1e6))
