#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Makes scenes/lights.glb: every shape of light in one picture.

    tools/make_lights_scene.py [-o FILE]

A showroom of five bays. On the wall, from the left: a disk, an ellipse, a window with a picture, a
star with a hole, and a rectangle. Before them a sphere, an open tube, a tube with flat ends, a
capsule and a thin line. Among the props a pendant (a point) and the pool of a spot with a range;
below the window a luminaire with a photometric file, lights.ies beside the scene; overhead a ceiling
panel that the camera does not see, and a faint directional light. The floor goes from glossy
(roughness 0.06, at the left) to satin (0.5). Metres, +Y up, the camera looks along -Z. The same bytes
on every run.

Each light that has a shape is a mesh for the camera and a light of its own: openltc_light in the
node's extras, EXT_lights_area, or, for the star and the window, the emissive mesh itself. Luminances
are a few times that of white paper here, as in the demo scene, so that colours survive the tone map.
"""

import math

from demo_scene import glb, parts, shapes, stained_glass, turned
from demo_scene.parts import add_mesh, facing

k_pitch = 1.75                             # from bay to bay
k_floor_roughness = [0.06, 0.13, 0.22, 0.34, 0.5]
k_wall_z, k_wall_light_z, k_lamp_z = -1.6, -1.22, -0.6
k_wall_light_y = 2.36
k_upright = [0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5)]  # turns +X to +Y

k_candle, k_tungsten, k_warm = [1.0, 0.48, 0.16], [1.0, 0.54, 0.20], [1.0, 0.72, 0.42]
k_noon, k_sky = [1.0, 0.90, 0.78], [0.30, 0.56, 1.0]
k_rose, k_neon = [1.0, 0.24, 0.34], [1.0, 0.20, 0.035]


def bay(index):
    return (index - 2) * k_pitch


def lamp_x(index):
    """The lamps stand nearer to the camera than the wall, and a little closer together."""
    return 0.92 * bay(index)


class Showroom:
    def __init__(self):
        self.file = glb.Glb({"version": "2.0", "generator": "OpenLTC tools/make_lights_scene.py",
                             "copyright": "OpenLTC, MIT",
                             "extras": {"units": "metres, nits, candela, lux",
                                        "subject": "every shape of light"}})
        self.nodes = []
        self.materials = {}
        self.ball = None

    def node(self, name, translation, **rest):
        item = dict({"name": name, "translation": [round(x, 4) for x in translation]}, **rest)
        self.nodes.append(self.file.add("nodes", item))

    def material(self, name, color, metallic, roughness):
        if name not in self.materials:
            self.materials[name] = self.file.add("materials", {
                "name": name, "pbrMetallicRoughness": {
                    "baseColorFactor": color + [1], "metallicFactor": metallic,
                    "roughnessFactor": roughness}})
        return self.materials[name]

    def brass(self):
        return self.material("brass", [0.91, 0.70, 0.36], 1, 0.28)

    def iron(self):
        return self.material("blackened steel", [0.10, 0.10, 0.105], 1, 0.38)

    def stone(self):
        return self.material("dark stone", [0.075, 0.072, 0.07], 0, 0.3)

    def thing(self, name, shape, material, translation, **rest):
        self.node(name, translation, mesh=add_mesh(self.file, name, shape, material), **rest)

    def glow(self, name, color, luminance_nits, two_sided=False, texture=None):
        item = {"name": name, "emissiveFactor": color,
                "pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1], "metallicFactor": 0},
                "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": luminance_nits}}}
        if two_sided:
            item["doubleSided"] = True
        if texture is not None:
            item["emissiveTexture"] = {"index": texture}
        return self.file.add("materials", item)

    def lamp(self, name, shape, color, luminance_nits, translation, light, rotation=None):
        """A glowing mesh whose light is what `light` says: openltc_light without its brightness."""
        light = dict(light, color=color)
        if not {"flux_lumens", "intensity_candela"} & set(light):
            light["luminance_nits"] = luminance_nits
        rest = {"rotation": rotation} if rotation else {}
        self.thing(name, shape, self.glow(name, color, luminance_nits,
                                          light.get("two_sided", False)),
                   translation, extras={"openltc_light": light}, **rest)

    def sphere_prop(self, name, color, metallic, roughness, radius, x, z, y=None):
        if self.ball is None:
            positions, normals, triangles = shapes.icosphere(5)
            self.ball = {"attributes": {"POSITION": self.file.vectors(positions, "VEC3"),
                                        "NORMAL": self.file.vectors(normals, "VEC3")},
                         "indices": self.file.indices(triangles)}
        mesh = self.file.add("meshes", {"name": name, "primitives": [
            dict(self.ball, material=self.material(name, color, metallic, roughness))]})
        self.node(name, (x, radius if y is None else y, z), mesh=mesh, scale=[radius] * 3)

    def pedestal(self, name, x, z, height, radius):
        h = height / 2
        profile = [[(-h, radius, 0, 1), (h - 0.012, radius, 0, 1)],
                   [(h - 0.012, radius, 1, 1), (h, radius - 0.012, 1, 1)],
                   [(h, radius - 0.012, 1, 0), (h, 0, 1, 0)]]
        self.thing(name, turned.turned(profile, 96), self.stone(), (x, h, z), rotation=k_upright)


def add_room(room):
    half = 2.5 * k_pitch
    for k, roughness in enumerate(k_floor_roughness):
        stone = room.material("floor, roughness %.2f" % roughness, [0.19, 0.175, 0.16], 0, roughness)
        x, front, depth = bay(k), 9.0, 9.0 - k_wall_z
        w = (k_pitch - 0.03) / 2
        if k in (0, 4):  # the outer strips run on beyond the picture
            x, w = math.copysign(half + 2.0 - (2.0 + k_pitch - 0.03) / 2, x), (2.0 + k_pitch - 0.03) / 2
        corners = [(-w, 0.0, depth / 2), (w, 0.0, depth / 2), (w, 0.0, -depth / 2), (-w, 0.0, -depth / 2)]
        room.thing("floor %d" % (k + 1), (corners, [(0.0, 1.0, 0.0)] * 4, [(0, 1, 2), (0, 2, 3)]),
                   stone, (x, 0, front - depth / 2))
        if k > 0:
            room.thing("inlay %d" % k, turned.box(0.03, 0.02, depth), room.brass(),
                       (bay(k) - k_pitch / 2, -0.0085, front - depth / 2))
            room.thing("fin %d" % k, turned.box(0.10, 3.9, 0.36), room.material(
                "smoked oak", [0.13, 0.088, 0.06], 0, 0.4), (bay(k) - k_pitch / 2, 1.95, k_wall_z + 0.18))
    wall = room.material("plaster", [0.30, 0.295, 0.29], 0, 0.85)
    room.thing("wall", turned.box(2 * half + 4, 3.9, 0.1), wall, (0, 1.95, k_wall_z - 0.05))
    room.thing("skirting", turned.box(2 * half + 4, 0.12, 0.05), room.iron(), (0, 0.06, k_wall_z + 0.025))


def add_wall_lights(room):
    y, z = k_wall_light_y, k_wall_light_z
    front = facing((0, y, z), (0, y - 0.35, z + 2))
    room.lamp("disk", turned.ellipse(0.47, 0.47), k_tungsten, 3200, (bay(0), y, z),
              {"type": "disk", "radius": 0.47, "two_sided": True}, front)
    room.lamp("ellipse", turned.ellipse(0.60, 0.36), k_rose, 3600, (bay(1), y, z),
              {"type": "ellipse", "radius_x": 0.60, "radius_y": 0.36, "two_sided": True}, front)

    size = stained_glass.k_size
    texture = room.file.texture("rose window", glb.png(size, size, 3, stained_glass.rows()))
    glass = room.glow("window", [1.0, 1.0, 1.0], 3000, True, texture)
    positions, normals, triangles = shapes.rectangle(1.24, 1.24)
    # Seen by whom it shines on, +X of the node is to the left; pictures have their top at v = 0.
    mesh = add_mesh(room.file, "window", (positions, normals, triangles), glass,
                    tex_coords=[(0.5 - px / 1.24, 0.5 - py / 1.24) for px, py, _ in positions])
    room.node("window", (bay(2), y, z), mesh=mesh, rotation=front)
    for name, width, height, dx, dy in (("left", 0.05, 1.34, -0.645, 0), ("right", 0.05, 1.34, 0.645, 0),
                                        ("top", 1.24, 0.05, 0, 0.645), ("bottom", 1.24, 0.05, 0, -0.645)):
        turn = front
        cos_pitch, sin_pitch = math.cos(math.atan2(0.35, 2)), math.sin(math.atan2(0.35, 2))
        room.thing("window frame, " + name, turned.box(width, height, 0.05), room.iron(),
                   (bay(2) + dx, y + dy * cos_pitch, z + dy * sin_pitch), rotation=turn)

    star = room.glow("star", k_sky, 3600, True)
    room.thing("star", turned.star(5, 0.66, 0.34, 0.52), star, (bay(3), y - 0.03, z), rotation=front)

    panel = room.glow("panel", k_noon, 2500)
    room.thing("panel", shapes.rectangle(0.72, 1.10), panel, (bay(4), y, z), rotation=front,
               extras={"openltc_emits_light": False, "openltc_surface_deviation": 0.01},
               extensions={"EXT_lights_area": {"light": 0}})


def add_lamps(room):
    # An opal globe on a pedestal.
    room.pedestal("pedestal of the sphere", lamp_x(0), k_lamp_z, 0.62, 0.19)
    room.thing("cup", turned.cylinder(0.05, 0.09), room.brass(), (lamp_x(0), 0.645, k_lamp_z), rotation=k_upright)
    room.lamp("sphere", shapes_scaled(shapes.icosphere(4), 0.25), k_warm, 2600, (lamp_x(0), 0.905, k_lamp_z),
              {"type": "sphere", "radius": 0.25})

    # A drum without ends, dark inside, on a stand.
    x = lamp_x(1)
    room.thing("stand foot", turned.cylinder(0.03, 0.19), room.brass(), (x, 0.015, k_lamp_z), rotation=k_upright)
    room.thing("stand", turned.cylinder(0.62, 0.014, 32), room.brass(), (x, 0.34, k_lamp_z), rotation=k_upright)
    room.lamp("open tube", turned.open_tube(0.46, 0.25), k_tungsten, 2300, (x, 0.86, k_lamp_z),
              {"type": "tube", "length": 0.46, "radius": 0.25, "caps": "none"}, k_upright)
    lining = turned.turned([[(0.229, 0.244, 0, -1), (-0.229, 0.244, 0, -1)]], 96)
    room.thing("lining", lining, room.iron(), (x, 0.86, k_lamp_z), rotation=k_upright)

    # A thick rod with flat ends on two blocks, one end towards the camera.
    turn = math.radians(-32)
    rod = [0.0, math.sin(turn / 2), 0.0, math.cos(turn / 2)]
    for t in (-0.28, 0.28):
        room.thing("block %s" % ("left" if t < 0 else "right"), turned.box(0.07, 0.16, 0.28), room.iron(),
                   (lamp_x(2) + t * math.cos(turn), 0.08, k_lamp_z - t * math.sin(turn)), rotation=rod)
    room.lamp("flat tube", turned.cylinder(0.92, 0.13), k_noon, 2100, (lamp_x(2), 0.29, k_lamp_z),
              {"type": "tube", "length": 0.92, "radius": 0.13, "caps": "flat"}, rod)

    # A leaning capsule in a foot.
    lean = math.radians(90 + 14)
    tilt = [0.0, 0.0, math.sin(lean / 2), math.cos(lean / 2)]
    x, foot = lamp_x(3), 0.10
    room.thing("foot of the capsule", turned.cylinder(foot, 0.16), room.stone(), (x + 0.14, foot / 2, k_lamp_z),
               rotation=k_upright)
    length, radius = 0.95, 0.085
    middle = 0.5 * length + 0.07
    room.lamp("capsule", turned.capsule(length, radius), k_sky, 3000,
              (x + 0.14 + math.cos(lean) * middle, foot + math.sin(lean) * middle, k_lamp_z),
              {"type": "tube", "length": length, "radius": radius, "caps": "round"}, tilt)

    # A thin line between two posts. A line has an intensity across it: luminance times its area.
    x, length, radius, luminance = lamp_x(4) - 0.05, 1.15, 0.014, 7000
    for side in (-1, 1):
        at = x + side * (length / 2 + 0.02)
        room.thing("post %s" % ("left" if side < 0 else "right"), turned.cylinder(0.86, 0.018, 48),
                   room.brass(), (at, 0.43, k_lamp_z), rotation=k_upright)
        room.thing("foot %s" % ("left" if side < 0 else "right"), turned.cylinder(0.02, 0.10),
                   room.brass(), (at, 0.01, k_lamp_z), rotation=k_upright)
    room.lamp("line", turned.cylinder(length, radius, 32), k_neon, luminance, (x, 0.80, k_lamp_z),
              {"type": "line", "length": length, "intensity_candela": 2 * radius * length * luminance})


def shapes_scaled(shape, factor):
    positions, normals, triangles = shape
    return [tuple(factor * x for x in p) for p in positions], normals, triangles


def add_props(room):
    silver, silver_gold = [0.97, 0.96, 0.94], [1.0, 0.77, 0.34]
    room.sphere_prop("polished silver", silver, 1, 0.06, 0.27, lamp_x(0) + 0.52, 0.35)
    room.sphere_prop("teal lacquer", [0.01, 0.20, 0.24], 0, 0.10, 0.19, lamp_x(0) - 0.12, 0.95)
    room.sphere_prop("satin copper", [0.96, 0.60, 0.48], 1, 0.30, 0.24, lamp_x(1) - 0.26, 0.75)
    room.sphere_prop("ivory", [0.72, 0.66, 0.55], 0, 0.35, 0.15, lamp_x(1) + 0.36, 0.60)
    room.sphere_prop("brushed gold", silver_gold, 1, 0.2, 0.22, lamp_x(2) - 0.52, 0.80)
    room.sphere_prop("ruby lacquer", [0.50, 0.02, 0.03], 0, 0.08, 0.17, lamp_x(2) + 0.50, 0.80)
    room.sphere_prop("blue lacquer", [0.02, 0.08, 0.42], 0, 0.15, 0.23, lamp_x(3) - 0.34, 0.70)
    room.sphere_prop("satin steel", [0.72, 0.72, 0.73], 1, 0.4, 0.18, lamp_x(3) + 0.40, 0.50)
    vase = turned.curve([(0.0, 0.11), (0.07, 0.18), (0.20, 0.22), (0.35, 0.16), (0.47, 0.07),
                         (0.55, 0.058), (0.60, 0.09)])
    room.thing("vase", turned.turned([vase], 96),
               room.material("celadon", [0.20, 0.44, 0.34], 0, 0.16), (lamp_x(4) + 0.08, 0.0, 0.5),
               rotation=k_upright)
    room.sphere_prop("matt chrome", [0.80, 0.80, 0.82], 1, 0.5, 0.15, lamp_x(4) - 0.40, 0.90)


def add_other_lights(room):
    lights = {"KHR_lights_punctual": {"light": 0}}
    spot = (lamp_x(4) - 0.9, 3.6, 2.1)
    room.node("spot", spot, rotation=facing(spot, (lamp_x(4) + 0.08, 0.25, 0.5)), extensions=lights)
    washer = (bay(2), 1.655, k_wall_z + 0.20)
    room.node("luminaire", (washer[0], washer[1] - 0.04, washer[2]),
              rotation=[-math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5)], extras={"openltc_light": {
                  "type": "point", "ies": "lights.ies", "color": k_warm, "intensity_candela": 3200}})
    room.thing("housing", turned.cylinder(0.07, 0.035, 48), room.brass(), washer, rotation=k_upright)
    sun = (-3.0, 5.0, 6.0)
    room.node("directional", sun, rotation=facing(sun, (0, 0, 0)),
              extensions={"KHR_lights_punctual": {"light": 1}})
    # A pendant: its light is a point below the dome.
    at = (lamp_x(1) + 0.80, 1.30, 0.3)
    room.node("point", (at[0], at[1] - 0.01, at[2]), extras={"openltc_light": {
        "type": "point", "color": k_candle, "intensity_candela": 420, "range": 12}})
    outside = turned.curve([(-0.03, 0.14), (0.0, 0.135), (0.06, 0.10), (0.09, 0.04), (0.10, 0.0)])
    inside = [(x, radius, -nx, -nr) for x, radius, nx, nr in reversed(
        turned.curve([(-0.03, 0.134), (0.0, 0.13), (0.055, 0.095), (0.083, 0.036), (0.09, 0.0)]))]
    room.thing("dome", turned.turned([outside], 64), room.brass(), at, rotation=k_upright)
    room.thing("lining of the dome", turned.turned([inside], 64), room.iron(), at, rotation=k_upright)
    room.thing("cable", turned.cylinder(3.0, 0.0025, 16), room.iron(), (at[0], at[1] + 1.6, at[2]),
               rotation=k_upright)
    ceiling = (0.0, 4.7, 3.2)
    room.node("ceiling panel", ceiling, rotation=facing(ceiling, (0, 0.4, 0.2)),
              extensions={"EXT_lights_area": {"light": 1}})
    room.file.document["extensions"] = {
        "EXT_lights_area": {"lights": [
            {"name": "panel", "type": "rect", "color": k_noon, "intensity": 2500, "size": 1.10,
             "rect": {"aspect": 0.72 / 1.10}},
            {"name": "ceiling panel", "type": "rect", "color": [0.93, 0.96, 1.0], "intensity": 1500,
             "size": 2.2, "rect": {"aspect": 4.4}}]},
        "KHR_lights_punctual": {"lights": [
            {"name": "spot", "type": "spot", "color": k_noon, "intensity": 20000, "range": 9.0,
             "spot": {"innerConeAngle": math.radians(5), "outerConeAngle": math.radians(11)}},
            {"name": "directional", "type": "directional", "color": [0.85, 0.92, 1.0],
             "intensity": 260}]}}


def add_camera(room):
    camera = room.file.add("cameras", {"name": "camera", "type": "perspective", "perspective": {
        "yfov": math.radians(21.4), "aspectRatio": 16 / 9, "znear": 0.1, "zfar": 100}})
    position, target = (0.0, 1.66, 11.6), (0.0, 0.97, 0.0)
    room.node("camera", position, camera=camera, rotation=facing(position, target))


def make():
    room = Showroom()
    for add in (add_room, add_wall_lights, add_lamps, add_props, add_other_lights, add_camera):
        add(room)
    room.file.add("scenes", {"name": "lights", "nodes": room.nodes})
    room.file.document["scene"] = 0
    room.file.document["extensionsUsed"] = ["EXT_lights_area", "KHR_lights_punctual",
                                            "KHR_materials_emissive_strength"]
    return room.file.to_bytes()


if __name__ == "__main__":
    parts.main(make, "Makes the scene of every shape of light.", "lights.glb")
