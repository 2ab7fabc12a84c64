#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Makes one small scene for each shape of light, for the pictures of docs/lights.md.

    tools/make_light_shapes.py FOLDER

The same stage each time: a glossy floor (roughness 0.06, 0.2 and 0.4), a wall, a silver, a lacquered and a matt
sphere, and one light behind them.
"""

import math
import os
import shutil
import sys

from demo_scene import glb, shapes, stained_glass, turned
from demo_scene.parts import add_mesh, facing
from make_lights_scene import Showroom, shapes_scaled

k_at = (0.0, 0.52, -0.2)
k_front = facing((0, 0, 0), (0, -0.12, 1.0))
k_luminance = 3000
k_color = [1.0, 0.80, 0.58]


def planar(name, shape, light):
    return lambda room: room.lamp(name, shape, k_color, k_luminance, k_at, light, k_front)


def picture(room):
    size = stained_glass.k_size
    texture = room.file.texture("rose window", glb.png(size, size, 3, stained_glass.rows()))
    shape = shapes.rectangle(0.74, 0.74)
    mesh = add_mesh(room.file, "picture", shape, room.glow("picture", [1.0] * 3, 6000, True, texture),
                    tex_coords=[(0.5 - x / 0.74, 0.5 - y / 0.74) for x, y, _ in shape[0]])
    room.node("picture", k_at, mesh=mesh, rotation=k_front)


def polygon(room):
    room.thing("polygon", turned.star(5, 0.42, 0.22, 0.5), room.glow("polygon", k_color, 3600, True), k_at,
               rotation=k_front)


def round_one(name, shape, light, luminance_nits=k_luminance, tilt_degrees=-8):
    half = math.radians(tilt_degrees) / 2
    return lambda room: room.lamp(name, shape, k_color, luminance_nits, k_at, light,
                                  [0.0, 0.0, math.sin(half), math.cos(half)])


def tube(length, radius, caps):
    return {"type": "tube", "length": length, "radius": radius, "caps": caps}


def punctual(light, position, target):
    return lambda room: room.node(light["type"], position, rotation=facing(position, target),
                                  extras={"openltc_light": dict(light, color=k_color)})


k_line_radius, k_line_luminance = 0.012, 9000
k_shapes = {
    "rectangle": planar("rectangle", shapes.rectangle(0.9, 0.56),
                        {"type": "rect", "width": 0.9, "height": 0.56, "two_sided": True}),
    "polygon": polygon,
    "picture": picture,
    "disk": planar("disk", turned.ellipse(0.34, 0.34), {"type": "disk", "radius": 0.34, "two_sided": True}),
    "ellipse": planar("ellipse", turned.ellipse(0.48, 0.25),
                      {"type": "ellipse", "radius_x": 0.48, "radius_y": 0.25, "two_sided": True}),
    "sphere": round_one("sphere", shapes_scaled(shapes.icosphere(4), 0.26),
                        {"type": "sphere", "radius": 0.26}),
    "open_tube": round_one("open tube", turned.open_tube(0.62, 0.19), tube(0.62, 0.19, "none"),
                           tilt_degrees=16),
    "flat_tube": round_one("flat tube", turned.cylinder(0.8, 0.13), tube(0.8, 0.13, "flat")),
    "capsule": round_one("capsule", turned.capsule(0.8, 0.08), tube(0.8, 0.08, "round"), 3600),
    "line": round_one("line", turned.cylinder(1.2, k_line_radius, 32),
                      {"type": "line", "length": 1.2,
                       "intensity_candela": 2 * k_line_radius * 1.2 * k_line_luminance},
                      k_line_luminance),
    # Emission that depends on the angle, for the table of errors.
    "disk_power_4": planar("narrow disk", turned.ellipse(0.34, 0.34),
                           {"type": "disk", "radius": 0.34, "two_sided": True, "cosine_power": 4}),
    "sphere_power_4": round_one("narrow sphere", shapes_scaled(shapes.icosphere(4), 0.26),
                                {"type": "sphere", "radius": 0.26, "cosine_power": 4}),
    "capsule_power_4": round_one("narrow capsule", turned.capsule(0.8, 0.08),
                                 dict(tube(0.8, 0.08, "round"), cosine_power=4), 3600),
    "point": punctual({"type": "point", "intensity_candela": 1300}, (-0.2, 1.2, 0.75), (0, 0, 0)),
    "spot": punctual({"type": "spot", "intensity_candela": 7500, "inner_cone_degrees": 14,
                      "outer_cone_degrees": 22, "range": 8}, (-0.8, 2.2, 1.6), (0.05, 0.1, 0.2)),
    "luminaire": lambda room: room.node(
        "luminaire", (0.0, 1.02, -0.62), rotation=[-math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5)],
        extras={"openltc_light": {"type": "point", "ies": "lights.ies", "color": k_color,
                                  "intensity_candela": 2600}}),
    "directional": punctual({"type": "directional", "illuminance_lux": 900}, (-1.5, 2.5, 2.0),
                            (0, 0, 0)),
}


def make(add_light):
    room = Showroom()
    for side, roughness in enumerate((0.06, 0.2, 0.4)):
        left, right = ((-4.0, -0.14), (-0.14, 0.14), (0.14, 4.0))[side]
        room.thing("floor %d" % side, (
            [(left, 0.0, 4.0), (right, 0.0, 4.0), (right, 0.0, -0.8), (left, 0.0, -0.8)],
            [(0.0, 1.0, 0.0)] * 4, [(0, 1, 2), (0, 2, 3)]),
            room.material("floor, roughness %.2f" % roughness, [0.2, 0.195, 0.19], 0, roughness), (0, 0, 0))
    room.thing("wall", turned.box(8.0, 3.0, 0.1), room.material("plaster", [0.4, 0.395, 0.39], 0, 0.85),
               (0, 1.5, -0.85))
    room.sphere_prop("silver", [0.97, 0.96, 0.94], 1, 0.15, 0.19, -0.66, 0.12)
    room.sphere_prop("lacquer", [0.01, 0.16, 0.34], 0, 0.1, 0.13, 0.44, 0.42)
    room.sphere_prop("matt", [0.6, 0.58, 0.55], 0, 0.7, 0.19, 0.74, 0.0)
    add_light(room)
    camera = room.file.add("cameras", {"name": "camera", "type": "perspective", "perspective": {
        "yfov": math.radians(26.5), "aspectRatio": 1.5, "znear": 0.1, "zfar": 100}})
    position = (0.0, 0.74, 3.3)
    room.node("camera", position, camera=camera, rotation=facing(position, (0, 0.27, 0)))
    room.file.add("scenes", {"nodes": room.nodes})
    room.file.document["scene"] = 0
    if any("emissiveFactor" in m for m in room.file.document["materials"]):
        room.file.document["extensionsUsed"] = ["KHR_materials_emissive_strength"]
    return room.file.to_bytes()


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: tools/make_light_shapes.py FOLDER")
    try:
        os.makedirs(sys.argv[1], exist_ok=True)
        shutil.copy(os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "scenes",
                                 "lights.ies"), sys.argv[1])
        for name, add_light in k_shapes.items():
            with open(os.path.join(sys.argv[1], name + ".glb"), "wb") as stream:
                stream.write(make(add_light))
    except OSError as error:
        sys.exit("%s: cannot be written: %s" % (error.filename, error.strerror))


if __name__ == "__main__":
    main()
