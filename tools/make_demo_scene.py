#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Makes scenes/demo.glb, the scene of the README's picture.

    tools/make_demo_scene.py [-o FILE]

Two rows of spheres, silver behind and coloured dielectric in front, go from mirror (roughness 0, at
the left) to rough (1, at the right), on a parquet floor before a plain studio wall. Five lights:
a rectangle, an L and a hexagonal ring as emissive meshes, one EXT_lights_area rectangle and one
point light. Metres, +Y up, the camera looks along -Z. The same bytes on every run.

How it is lit. Light is direct only, so a mirror shows the lights and is black elsewhere: the soft
box above and before them is large, and the emissive shapes hang above the spheres, not behind them,
where only the rims would mirror them. Every visible light is a few times as bright as white paper
here, no more: brighter ones would lose their colour and their smooth edges in the tone map.
"""

import math

from demo_scene import glb, parquet, parts, shapes
from demo_scene.parts import add_mesh, facing

k_sphere_count = 7
k_plank_width_m = 0.13


def add_floor(file):
    colors, normals, roughnesses = parquet.make_textures()
    size = parquet.k_size

    def use(name, rows):
        scale = 1 / (parquet.k_period_cells * k_plank_width_m)
        return {"index": file.texture(name, glb.png(size, size, 3, rows)),
                "extensions": {"KHR_texture_transform": {"scale": [scale, scale]}}}

    material = file.add("materials", {
        "name": "parquet", "normalTexture": use("parquet normal", normals),
        "pbrMetallicRoughness": {
            "baseColorTexture": use("parquet colour", colors),
            "metallicRoughnessTexture": use("parquet roughness", roughnesses)}})
    # Texture coordinates are metres on the floor, turned by 45 degrees so that the herringbone
    # points away from the viewer; KHR_texture_transform scales them to the texture's period.
    x, front, back, h = 12.0, 14.0, -1.55, math.sqrt(0.5)
    corners = [(-x, 0.0, front), (x, 0.0, front), (x, 0.0, back), (-x, 0.0, back)]
    mesh = add_mesh(file, "floor", (corners, [(0.0, 1.0, 0.0)] * 4, [(0, 1, 2), (0, 2, 3)]),
                    material, [(h, 0.0, h, 1.0)] * 4,
                    [((px + pz) * h, (pz - px) * h) for px, _, pz in corners])
    return file.add("nodes", {"name": "floor", "mesh": mesh})


def add_wall(file):
    material = file.add("materials", {"name": "plaster", "pbrMetallicRoughness": {
        "baseColorFactor": [0.26, 0.34, 0.44, 1], "metallicFactor": 0, "roughnessFactor": 0.9}})
    mesh = add_mesh(file, "wall", shapes.cove(12.0, -1.55, 0.35, 8.0, 24), material)
    return file.add("nodes", {"name": "wall", "mesh": mesh})


def mix(a, b, t):
    return [p + (q - p) * t for p, q in zip(a, b)]


def add_sphere_row(file, attributes, name, color_at, metallic, radius, spacing, z):
    """Spheres from roughness 0 at the left to 1; all share one set of vertices."""
    nodes = []
    for k in range(k_sphere_count):
        roughness = k / (k_sphere_count - 1)
        label = "%s, roughness %.2f" % (name, roughness)
        material = file.add("materials", {"name": label, "pbrMetallicRoughness": {
            "baseColorFactor": [round(c, 4) for c in color_at(roughness)] + [1],
            "metallicFactor": metallic, "roughnessFactor": round(roughness, 4)}})
        mesh = file.add("meshes", {"name": label, "primitives": [dict(attributes, material=material)]})
        x = (k - (k_sphere_count - 1) / 2) * spacing
        nodes.append(file.add("nodes", {"name": label, "mesh": mesh, "scale": [radius] * 3,
                                        "translation": [round(x, 4), radius, z]}))
    return nodes


def add_spheres(file):
    positions, normals, triangles = shapes.icosphere(5)
    attributes = {"attributes": {"POSITION": file.vectors(positions, "VEC3"),
                                 "NORMAL": file.vectors(normals, "VEC3")},
                  "indices": file.indices(triangles)}
    silver = [0.98, 0.97, 0.95]
    stops = [[0.01, 0.22, 0.30], [0.02, 0.12, 0.50], [0.22, 0.07, 0.46], [0.55, 0.05, 0.25],
             [0.75, 0.15, 0.07], [0.80, 0.42, 0.05]]

    def dielectric(t):
        position = t * (len(stops) - 1)
        i = min(int(position), len(stops) - 2)
        return mix(stops[i], stops[i + 1], position - i)

    return (add_sphere_row(file, attributes, "silver", lambda _: silver, 1, 0.46, 1.10, -1.05)
            + add_sphere_row(file, attributes, "lacquer", dielectric, 0, 0.385, 0.92, 0.95))


def add_emitter(file, name, shape, color, luminance_nits, position, target):
    """An emissive mesh that shines towards target."""
    material = file.add("materials", {
        "name": name, "doubleSided": True, "emissiveFactor": color,
        "pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1], "metallicFactor": 0},
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": luminance_nits}}})
    mesh = add_mesh(file, name, shape, material)
    return file.add("nodes", {"name": name, "mesh": mesh, "translation": list(position),
                              "rotation": facing(position, target)})


def add_lights(file):
    # The shapes hang less than a metre before the wall and shine both ways, so the wall glows.
    nodes = [
        add_emitter(file, "rectangle", shapes.rectangle(1.9, 1.4), [1.0, 0.54, 0.14], 3000,
                    (-2.78, 2.04, -1.1), (-2.3, 0.7, 1.0)),
        add_emitter(file, "hexagonal ring", shapes.hexagon_ring(0.98, 0.60),
                    [0.13, 0.44, 1.0], 4300, (0.0, 2.08, -1.1), (0.0, 0.7, 1.0)),
        add_emitter(file, "L", shapes.l_shape(1.9, 1.6, 0.56), [1.0, 0.16, 0.28], 3900,
                    (2.78, 2.04, -1.1), (2.3, 0.7, 1.0)),
    ]
    # Invisible to the camera. Its lower edge is high enough that the front row hides none of
    # it from the mirrors behind.
    soft_box = (-1.0, 4.3, 3.6)
    nodes.append(file.add("nodes", {
        "name": "soft box", "translation": list(soft_box),
        "rotation": facing(soft_box, (-1.0, 0.4, 0.2)),
        "extensions": {"EXT_lights_area": {"light": 0}}}))
    # Nearly on the line of sight of the shapes, so that their hard shadows hide behind them.
    nodes.append(file.add("nodes", {
        "name": "bulb", "translation": [0.5, 3.1, 5.0],
        "extensions": {"KHR_lights_punctual": {"light": 0}}}))
    file.document["extensions"] = {
        "EXT_lights_area": {"lights": [{
            "name": "soft box", "type": "rect", "color": [1.0, 0.97, 0.93], "intensity": 2900,
            "size": 7.4, "rect": {"aspect": 1.5}}]},
        "KHR_lights_punctual": {"lights": [{
            "name": "bulb", "type": "point", "color": [1.0, 0.86, 0.68], "intensity": 10000}]}}
    return nodes


def add_camera(file):
    camera = file.add("cameras", {"name": "camera", "type": "perspective", "perspective": {
        "yfov": math.radians(23), "aspectRatio": 16 / 9, "znear": 0.1, "zfar": 100}})
    position, target = (0.0, 3.35, 10.8), (0.0, 0.79, -0.7)
    return file.add("nodes", {"name": "camera", "camera": camera, "translation": list(position),
                              "rotation": facing(position, target)})


def make():
    file = glb.Glb({"version": "2.0", "generator": "OpenLTC tools/make_demo_scene.py",
                    "copyright": "OpenLTC, MIT",
                    "extras": {"units": "metres, nits, candela",
                               "subject": "area lights on mirror to rough spheres"}})
    nodes = [add_floor(file), add_wall(file)]
    nodes += add_spheres(file) + add_lights(file) + [add_camera(file)]
    file.add("scenes", {"name": "demo", "nodes": nodes})
    file.document["scene"] = 0
    file.document["extensionsUsed"] = ["EXT_lights_area", "KHR_lights_punctual",
                                       "KHR_materials_emissive_strength", "KHR_texture_transform"]
    return file.to_bytes()


if __name__ == "__main__":
    parts.main(make, "Makes the demo scene.", "demo.glb")
