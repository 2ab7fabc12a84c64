# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The scenes of three.py: the stage of tools/make_light_shapes.py under lights of openltc_light and EXT_lights_area."""

import json
import math

import make_light_shapes
from demo_scene import glb
from demo_scene.parts import facing


def light(shape, position, target, nits, color=(1.0, 0.9, 0.75), **more):
    brightness = {} if {"flux_lumens", "intensity_candela"} & set(more) else {"luminance_nits": nits}
    extras = dict({"type": shape, "color": list(color)}, **brightness, **more)
    return (position, facing(position, target), {"extras": {"openltc_light": extras}})


def star(points, outer, inner):
    return [[(inner if k % 2 else outer) * math.cos(math.pi * (0.5 + k / points)),
             (inner if k % 2 else outer) * math.sin(math.pi * (0.5 + k / points))] for k in range(2 * points)]


k_above, k_middle = (-0.5, 1.3, 0.7), (0.1, 0.1, -0.1)
k_ring = [[-0.5, -0.4], [0.55, -0.4], [0.55, 0.4], [0.1, 0.1], [-0.5, 0.4]]
k_hole = [[-0.35, -0.25], [-0.35, -0.05], [0.2, -0.05], [0.2, -0.25]]
k_scenes = {
    "rect": [light("rect", k_above, k_middle, 3, width=0.9, height=0.5)],
    "polygon": [light("polygon", k_above, k_middle, 3, points=k_ring, holes=[k_hole])],
    "ellipse": [light("ellipse", (0.3, 0.3, 0.1), k_middle, 3, radius_x=0.5, radius_y=0.2, two_sided=True),
                light("disk", k_above, k_middle, 3, (0.4, 0.6, 1.0), radius=0.2)],
    "sphere": [light("sphere", k_above, k_middle, 0, radius=0.15, flux_lumens=3)],
    **{"tube_" + caps: [light("tube", k_above, k_middle, 0, length=0.6, radius=0.08, caps=caps, **{quantity: value})]
       for caps, quantity, value in (("round", "intensity_candela", 0.3), ("flat", "intensity_candela", 0.3),
                                     ("none", "flux_lumens", 3))},
    "picture": [light("rect", k_above, k_middle, 4, (1.0, 1.0, 1.0), width=0.9, height=0.5, texture="picture.png"),
                light("disk", (0.8, 0.4, 0.4), k_middle, 4, radius=0.3, two_sided=True, texture="picture.png")],
    # Other forms of the file; scales of nodes, of which the largest counts.
    "gltf": [(k_above, facing(k_above, k_middle), {"scale": [1, 2, 1], "extensions": {"EXT_lights_area": {"light": 0}}}),
             ((0.9, 0.8, 0.2), facing((0.9, 0.8, 0.2), k_middle), {"extensions": {"EXT_lights_area": {"light": 1}}}),
             ((0.0, 0.6, 0.5), facing((0, 0, 0), (1, 0, 0)), {"scale": [1.5, 1.5, 1.5], "extras": {"openltc_light": json.dumps(
                 {"type": "sphere", "radius": 0.05, "intensity_candela": 0.1, "exposure": 1})}}),
             ((-0.9, 0.9, 0.1), facing((-0.9, 0.9, 0.1), k_middle), {"scale": [0.5, 0.5, 0.5], "extras": {
                 "openltc_light": "rect", "openltc_width": 0.8, "openltc_height": 0.4,
                 "openltc_flux_lumens": 1, "openltc_two_sided": True, "openltc_color": [0.4, 0.6, 1]}}),
             # Left out by both: a size is missing.
             ((0.3, 0.5, 0.3), facing((0, 0, 0), (0, -1, 0)), {"extras": {"openltc_light": {
                 "type": "sphere", "luminance_nits": 100}}})],
    "line": [light("line", k_above, k_middle, 0, length=0.8, intensity_candela=1.0),
             light("line", (0.6, 0.4, 0.3), k_middle, 0, (0.4, 0.6, 1.0), length=0.5, flux_lumens=3)],
    # Through the floor and each other, of two sides, of lumens; more elements than a row of the texture.
    "many": [light("polygon", (-0.9, 0.5, 0.2), (0.3, 0.1, -0.2), 2, points=star(5, 0.4, 0.18), two_sided=True),
             light("rect", (0.9, 0.1, -0.3), (-0.2, 0.3, 0.1), 3, (0.4, 0.7, 1.0), width=0.3, height=0.7),
             light("rect", (0.2, 1.4, 0.4), (0.2, 0.0, 0.3), 0, (1.0, 0.5, 0.4), width=0.2, height=0.2,
                   flux_lumens=0.8, two_sided=True)]
            + [light("polygon", (0.3 * k - 0.9, 1.0, -0.6), (0.3 * k - 0.9, 0.0, 0.0), 1,
                     (1.0, 0.3 + 0.1 * k, 0.2), points=star(17, 0.12, 0.06)) for k in range(7)],
    # More than a driver would take one by one, of each round shape; they cross the floor and each other.
    "round": [light(shape, (0.3 * (k % 6) - 0.8, (0.25, 0.5)[k // 6] + 0.3 * row, 0.2 + 0.25 * row - 0.4 * (k // 6)), k_middle, 3,
                    ((1.0, 0.9, 0.75), (0.4, 0.6, 1.0), (1.0, 0.5, 0.3))[(k + row) % 3], **sizes)
              for row, (shape, sizes) in enumerate((("disk", {"radius": 0.08}), ("sphere", {"radius": 0.05}),
                                                    ("tube", {"length": 0.2, "radius": 0.02})))
              for k in range(12)],
}
k_ext_lights = [{"type": "rect", "size": 0.25, "intensity": 4, "rect": {"aspect": 2}, "color": [1, 0.9, 0.75]},
                {"type": "disk", "size": 0.3, "intensity": 5}]
k_scenes["physical"] = k_scenes["coat"] = k_scenes["rect"]


def physical(material, drawn):
    material["extensions"] = {"KHR_materials_ior": {"ior": 1.9}, "KHR_materials_specular": {
        "specularFactor": 0.7, "specularColorFactor": [1.0, 0.6, 0.3]}}


def coat(material, drawn):
    """A clear coat on black, which reflects nothing, is what a black dielectric is."""
    surface = material["pbrMetallicRoughness"]
    surface.update(baseColorFactor=[0, 0, 0, 1], metallicFactor=0)
    if drawn:
        material["extensions"] = {"KHR_materials_specular": {"specularFactor": 0}, "KHR_materials_clearcoat": {
            "clearcoatFactor": 1, "clearcoatRoughnessFactor": surface["roughnessFactor"]}}


k_materials = {"physical": physical, "coat": coat}


def write_picture(path):
    """Of four colours, each brighter to its own side, in a square that is not as many pixels as a texture has."""
    def pixel(x, y):
        color = ((240, 60, 20), (30, 200, 40), (20, 40, 230), (220, 220, 200))[2 * (y > 0.6) + (x > 0.4)]
        return bytes(int(c * (0.3 + 0.7 * x * (1 - 0.5 * y))) for c in color)

    columns, rows = 50, 38
    with open(path, "wb") as stream:
        stream.write(glb.png(columns, rows, 3, (b"".join(pixel(x / columns, y / rows) for x in range(columns))
                                                for y in range(rows))))


def write_scene(name, lights, path, drawn):
    """A scene: as the page draws it, or as openltc render does."""
    def add(room):
        for material in room.file.document["materials"] if name in k_materials else []:
            k_materials[name](material, drawn)
        for k, (position, rotation, members) in enumerate(lights):
            room.node("light %d" % k, position, rotation=rotation, **members)
        if name == "gltf":
            room.file.document["extensions"] = {"EXT_lights_area": {"lights": k_ext_lights}}
            room.file.document["extensionsUsed"] = ["EXT_lights_area"]

    with open(path, "wb") as stream:
        stream.write(make_light_shapes.make(add))


def mirrored(lights):
    """The first light, its x turned over."""
    (x, y, z), (qx, qy, qz, qw), members = lights[0]
    return [((-x, y, z), (qx, -qy, -qz, qw), members)] + lights[1:]
