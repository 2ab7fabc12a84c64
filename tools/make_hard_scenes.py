#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Makes scenes/hard/*.glb, the scenes on which one lobe is at its worst.

    tools/make_hard_scenes.py [FOLDER]

floor_LIGHT_ROUGHNESS   a long metal floor, seen by a low camera at 65 degrees from its normal (the
                        picture's lower edge) to 88.5 (its upper edge, near the horizon)
rims                    a row of metal spheres before a panel that only their rims reflect
lamps_MATERIAL          small bright lamps over a floor
low_LIGHT               lamps that nearly or half lie in a glossy black floor

The camera sees the lights nowhere: every lit pixel shows what a surface reflects. The environment is
black. Metres, +Y up, the camera looks along -Z. The same bytes on every run.
"""

import math
import os
import sys

from demo_scene import glb, shapes
from demo_scene.parts import add_mesh, facing

k_root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
k_nits = 1000
k_across = [0.0, 0.0, 0.0, 1.0]            # a tube along X, as openltc_light has it


def turned_about_y(degrees):
    half = math.radians(degrees) / 2
    return [0.0, math.sin(half), 0.0, math.cos(half)]


class HardScene:
    def __init__(self, subject):
        self.file = glb.Glb({"version": "2.0", "generator": "OpenLTC tools/make_hard_scenes.py",
                             "copyright": "OpenLTC, MIT",
                             "extras": {"units": "metres, nits, candela", "subject": subject}})
        self.nodes = []

    def node(self, name, translation, **rest):
        item = dict({"name": name, "translation": [round(x, 4) for x in translation]}, **rest)
        self.nodes.append(self.file.add("nodes", item))

    def material(self, name, color, metallic, roughness):
        return self.file.add("materials", {"name": name, "pbrMetallicRoughness": {
            "baseColorFactor": [color] * 3 + [1], "metallicFactor": metallic, "roughnessFactor": roughness}})

    def floor(self, material, half_width, front, back):
        positions = [(-half_width, 0.0, front), (half_width, 0.0, front),
                     (half_width, 0.0, back), (-half_width, 0.0, back)]
        shape = (positions, [(0.0, 1.0, 0.0)] * 4, [(0, 1, 2), (0, 2, 3)])
        self.node("floor", (0, 0, 0), mesh=add_mesh(self.file, "floor", shape, material))

    def light(self, name, translation, light, rotation=None):
        if "intensity_candela" not in light:
            light = dict({"luminance_nits": k_nits}, **light)
        self.node(name, translation, extras={"openltc_light": light}, rotation=rotation or k_across)

    def camera(self, position, rotation, fov_degrees):
        camera = self.file.add("cameras", {"name": "camera", "type": "perspective", "perspective": {
            "yfov": math.radians(fov_degrees), "aspectRatio": 16 / 9, "znear": 0.01}})
        self.node("camera", position, camera=camera, rotation=rotation)

    def to_bytes(self):
        self.file.add("scenes", {"name": "hard", "nodes": self.nodes})
        self.file.document["scene"] = 0
        return self.file.to_bytes()


def star(points, outer_radius, inner_radius):
    return [[round((inner_radius if k % 2 else outer_radius) * f(math.pi / 2 + math.pi * k / points), 4)
             for f in (math.cos, math.sin)] for k in range(2 * points)]


def metal_floor(roughness, name, translation, light, rotation=None):
    scene = HardScene("a metal floor up to the horizon")
    scene.floor(scene.material("metal, roughness %.2f" % roughness, 1.0, 1, roughness), 40.0, 10.0, -80.0)
    scene.light(name, translation, light, rotation)
    # From 65 degrees off the floor's normal to 88.5.
    half = math.radians(-13.25) / 2
    scene.camera((0.0, 1.2, 0.0), [math.sin(half), 0.0, 0.0, math.cos(half)], 23.5)
    return scene


def under_sphere(roughness):
    return metal_floor(roughness, "sphere", (0.3, 0.6, -6.0), {"type": "sphere", "radius": 0.35})


def under_star(roughness):
    return metal_floor(roughness, "star", (-0.4, 0.95, -8.0), {
        "type": "polygon", "points": star(5, 0.85, 0.40), "holes": [star(5, 0.45, 0.21)],
        "two_sided": True}, turned_about_y(155))


def under_tube(roughness):
    return metal_floor(roughness, "tube", (0.0, 0.5, -7.0), {
        "type": "tube", "length": 3.0, "radius": 0.05, "caps": "round"}, turned_about_y(55))


def before_end_wall(roughness):
    return metal_floor(roughness, "panel at the end", (0.0, 2.5, -22.0), {
        "type": "rect", "width": 12.0, "height": 4.6}, turned_about_y(180))


def beside_wall(roughness):
    return metal_floor(roughness, "panel along the floor", (-3.5, 1.6, -15.0), {
        "type": "rect", "width": 24.0, "height": 3.0}, turned_about_y(-90))


def rims():
    scene = HardScene("rims of metal spheres")
    positions, normals, triangles = shapes.icosphere(5)
    attributes = {"POSITION": scene.file.vectors(positions, "VEC3"),
                  "NORMAL": scene.file.vectors(normals, "VEC3")}
    indices = scene.file.indices(triangles)
    for k, roughness in enumerate((0.2, 0.35, 0.5, 0.7)):
        name = "metal, roughness %.2f" % roughness
        mesh = scene.file.add("meshes", {"name": name, "primitives": [{
            "attributes": attributes, "indices": indices,
            "material": scene.material(name, 1.0, 1, roughness)}]})
        scene.node(name, ((k - 1.5) * 1.05, 0.5, 0.0), mesh=mesh, scale=[0.5] * 3)
    at = (0.0, 3.2, -5.0)
    scene.light("panel", at, {"type": "rect", "width": 6.0, "height": 2.0}, facing(at, (0.0, 0.5, 0.0)))
    scene.camera((0.0, 0.5, 9.0), facing((0.0, 0.5, 9.0), (0.0, 0.5, 0.0)), 15.0)
    return scene


def lamps(color, metallic, roughness):
    scene = HardScene("small bright lamps")
    scene.floor(scene.material("floor", color, metallic, roughness), 20.0, 5.0, -30.0)
    bright = {"luminance_nits": 100 * k_nits}
    scene.light("ball", (-0.7, 0.35, -2.2), dict(bright, type="sphere", radius=0.02))
    scene.light("square", (0.6, 0.5, -2.8), dict(bright, type="rect", width=0.05, height=0.05, two_sided=True),
                turned_about_y(150))
    scene.light("rod", (0.1, 0.25, -4.2), dict(bright, type="tube", length=0.12, radius=0.008, caps="flat"),
                turned_about_y(30))
    scene.light("disk", (-1.4, 0.9, -5.2), dict(bright, type="disk", radius=0.04),
                facing((-1.4, 0.9, -5.2), (-0.6, 0.0, -3.0)))
    scene.camera((0.0, 1.1, 0.0), facing((0.0, 1.1, 0.0), (0.0, 0.0, -3.3)), 24.0)
    return scene


def low(name, translation, light):
    scene = HardScene("a lamp that nearly lies in the floor")
    scene.floor(scene.material("black lacquer, roughness 0.3", 0.0, 0, 0.3), 10.0, 5.0, -10.0)
    scene.light(name, translation, light, turned_about_y(20))
    scene.camera((0.0, 0.5, 1.6), facing((0.0, 0.5, 1.6), (0.0, 0.0, 0.0)), 30.0)
    return scene


def low_line(height):
    return low("line", (0.0, height, 0.0), {"type": "line", "length": 1.0, "intensity_candela": 100})


def low_tube(height):
    return low("tube", (0.0, height, 0.0), {"type": "tube", "length": 0.8, "radius": 0.1, "caps": "round"})


k_scenes = {
    "floor_sphere_20": lambda: under_sphere(0.2),
    "floor_sphere_45": lambda: under_sphere(0.45),
    "floor_star_35": lambda: under_star(0.35),
    "floor_star_60": lambda: under_star(0.6),
    "floor_tube_20": lambda: under_tube(0.2),
    "floor_tube_45": lambda: under_tube(0.45),
    "floor_end_wall_35": lambda: before_end_wall(0.35),
    "floor_side_wall_60": lambda: beside_wall(0.6),
    "rims": rims,
    "lamps_metal": lambda: lamps(1.0, 1, 0.5),
    "lamps_dielectric": lambda: lamps(0.2, 0, 0.3),
    "low_line_10mm": lambda: low_line(0.01),
    "low_line_1mm": lambda: low_line(0.001),
    "low_line_0mm": lambda: low_line(0.0),
    "low_tube_half_sunk": lambda: low_tube(0.0),
}


def main():
    if len(sys.argv) > 2:
        sys.exit("usage: tools/make_hard_scenes.py [FOLDER]")
    folder = sys.argv[1] if len(sys.argv) == 2 else os.path.join(k_root, "scenes", "hard")
    try:
        os.makedirs(folder, exist_ok=True)
        for name, make in k_scenes.items():
            with open(os.path.join(folder, name + ".glb"), "wb") as stream:
                stream.write(make().to_bytes())
    except OSError as error:
        sys.exit("%s: cannot be written: %s" % (error.filename, error.strerror))


if __name__ == "__main__":
    main()
