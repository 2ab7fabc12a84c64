#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Makes scenes whose emissive meshes have thousands of facets, or are unkind in other ways.

    tools/make_emissive_scenes.py FOLDER

neon.glb         lettering of stroked, extruded glyphs, 8,300 triangles of 0.5 nits
knot-N.glb       a glowing trefoil tube of N triangles, N = 96, 960 and 10,640, the same flux each
overlapping.glb  10,000 quads of one mesh in one plane that overlap each other
disk.glb         a fan of 40,000 triangles: a disk whose rim is finer than any eye
mask.glb         a panel of which an alphaMode MASK texture leaves a quarter

The same bytes on every run. Metres, nits, +Y up; a floor and a wall behind.
"""

import math
import os
import random
import sys

from demo_scene import glb
from demo_scene.parts import add_mesh, facing


def lerp(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def arc(cx, cy, rx, ry, from_degrees, to_degrees, count):
    """Points of an elliptic arc, both ends included."""
    for i in range(count + 1):
        angle = math.radians(from_degrees + (to_degrees - from_degrees) * i / count)
        yield (cx + rx * math.cos(angle), cy + ry * math.sin(angle))


def glyphs():
    """Paths of strokes in a box of 0.6 x 1, with whether they are closed."""
    n = 41
    upper = list(arc(0.3, 0.75, 0.24, 0.21, 20, 270, 2 * n))
    lower = list(arc(0.3, 0.29, 0.26, 0.25, 90, -160, 2 * n))
    bowl = list(arc(0.25, 0.5, 0.3, 0.46, -90, 90, 3 * n))
    return {
        "O": [(list(arc(0.3, 0.5, 0.27, 0.46, 0, 360, 4 * n))[:-1], True)],
        "C": [(list(arc(0.32, 0.5, 0.27, 0.46, 40, 320, 4 * n)), False)],
        "S": [(upper + lower[1:], False)],
        "U": [([(0.06, 0.96), (0.06, 0.4)] + list(arc(0.3, 0.3, 0.24, 0.27, 180, 360, 2 * n))
               + [(0.54, 0.4), (0.54, 0.96)], False)],
        "D": [([(0.08, 0.04)] + bowl + [(0.08, 0.96)], True)],
        "N": [([(0.06, 0.04), (0.06, 0.96), (0.54, 0.04), (0.54, 0.96)], False)],
    }


def normalized(v):
    size = math.sqrt(sum(x * x for x in v))
    return tuple(x / size for x in v)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def flat_shaded(triangles):
    """(positions, normals, triangles) with corners of their own."""
    positions, normals = [], []
    for a, b, c in triangles:
        normal = normalized(cross(sub(b, a), sub(c, a)))
        positions += [a, b, c]
        normals += [normal] * 3
    return positions, normals, [(i, i + 1, i + 2) for i in range(0, len(positions), 3)]


def stroke(path, closed, width, depth):
    """Triangles of an extruded stroke along a path in z = 0 .. depth."""
    count = len(path)
    left, right = [], []
    for i, p in enumerate(path):
        before = path[i - 1] if closed or i > 0 else None
        after = path[(i + 1) % count] if closed or i + 1 < count else None
        d0 = normalized(sub(p, before)) if before else None
        d1 = normalized(sub(after, p)) if after else None
        d0, d1 = d0 or d1, d1 or d0
        n = normalized((-d0[1] - d1[1], d0[0] + d1[0]))
        reach = 0.5 * width / max(-d0[1] * n[0] + d0[0] * n[1], 0.4)
        left.append((p[0] + n[0] * reach, p[1] + n[1] * reach))
        right.append((p[0] - n[0] * reach, p[1] - n[1] * reach))
    triangles = []

    def quad(a, b, c, d):
        triangles.extend([(a, b, c), (a, c, d)])

    def front(p):
        return (p[0], p[1], depth)

    def back(p):
        return (p[0], p[1], 0.0)

    for i in range(count if closed else count - 1):
        k = (i + 1) % count
        quad(front(right[i]), front(right[k]), front(left[k]), front(left[i]))
        quad(back(left[i]), back(left[k]), back(right[k]), back(right[i]))
        quad(front(left[i]), front(left[k]), back(left[k]), back(left[i]))
        quad(back(right[i]), back(right[k]), front(right[k]), front(right[i]))
    if not closed:
        quad(front(right[0]), front(left[0]), back(left[0]), back(right[0]))
        quad(front(left[-1]), front(right[-1]), back(right[-1]), back(left[-1]))
    return triangles


def lettering(text, height):
    triangles = []
    for place, letter in enumerate(text):
        for path, closed in glyphs().get(letter, []):
            for triangle in stroke(path, closed, 0.09, 0.08):
                triangles.append(tuple(((p[0] + 0.72 * (place - len(text) / 2)) * height,
                                        p[1] * height, p[2] * height) for p in triangle))
    return triangles


def knot(along, around):
    """A trefoil tube: 2 * along * around triangles, smooth to the eye."""
    def center(t):
        return ((math.sin(t) + 2 * math.sin(2 * t)) * 0.2, (math.cos(t) - 2 * math.cos(2 * t)) * 0.2,
                -math.sin(3 * t) * 0.2)

    rings = []
    for i in range(along):
        t = 2 * math.pi * i / along
        forward = normalized(sub(center(t + 1e-4), center(t - 1e-4)))
        side = normalized(cross(forward, (0, 0, 1)))
        up = cross(side, forward)
        c = center(t)
        rings.append([tuple(c[k] + 0.08 * (math.cos(a) * side[k] + math.sin(a) * up[k])
                            for k in range(3))
                      for a in (2 * math.pi * j / around for j in range(around))])
    triangles = []
    for i in range(along):
        for j in range(around):
            a, b = rings[i][j], rings[i][(j + 1) % around]
            d, c = rings[(i + 1) % along][j], rings[(i + 1) % along][(j + 1) % around]
            triangles += [(a, c, b), (a, d, c)]  # facing outwards
    return triangles


def area_of(triangles):
    return sum(0.5 * math.hypot(*cross(sub(b, a), sub(c, a))) for a, b, c in triangles)


def overlapping_quads(count):
    draw = random.Random(5)
    triangles = []
    for _ in range(count):
        x, y, angle = draw.uniform(-1, 1), draw.uniform(-0.6, 0.6), draw.uniform(0, math.pi)
        c, s = 0.05 * math.cos(angle), 0.05 * math.sin(angle)
        corners = [(x + c * u - s * v, y + s * u + c * v, 0.0)
                   for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        triangles += [tuple(corners[:3]), (corners[0], corners[2], corners[3])]
    return triangles


class Stage:
    """A floor, a wall, a camera and one emitter before the wall."""

    def __init__(self, subject):
        self.file = glb.Glb({"version": "2.0", "generator": "OpenLTC tools/make_emissive_scenes.py",
                             "copyright": "OpenLTC, MIT", "extras": {"subject": subject}})
        self.nodes = []

    def material(self, name, **rest):
        return self.file.add("materials", dict({"name": name}, **rest))

    def node(self, name, mesh, translation=(0, 0, 0)):
        self.nodes.append(self.file.add("nodes", {"name": name, "mesh": mesh,
                                                  "translation": list(translation)}))

    def to_bytes(self):
        paint = self.material("paint", pbrMetallicRoughness={
            "baseColorFactor": [0.7, 0.7, 0.7, 1], "metallicFactor": 0, "roughnessFactor": 0.4})

        def quad(a, b, c, d):
            return flat_shaded([(a, b, c), (a, c, d)])

        floor = quad((-5, 0, 5), (5, 0, 5), (5, 0, -1), (-5, 0, -1))
        wall = quad((-5, 0, -1), (5, 0, -1), (5, 4, -1), (-5, 4, -1))
        self.node("floor", add_mesh(self.file, "floor", floor, paint))
        self.node("wall", add_mesh(self.file, "wall", wall, paint))
        camera = self.file.add("cameras", {"type": "perspective", "perspective": {
            "yfov": 0.7, "znear": 0.05}})
        at = [0.0, 1.4, 4.2]
        self.nodes.append(self.file.add("nodes", {
            "name": "camera", "camera": camera, "translation": at,
            "rotation": [round(x, 6) for x in facing(at, (0, 0.9, -0.5))]}))
        self.file.add("scenes", {"nodes": self.nodes})
        self.file.document["scene"] = 0
        return self.file.to_bytes()

    def glow(self, nits, **rest):
        self.file.document["extensionsUsed"] = ["KHR_materials_emissive_strength"]
        return self.material("glow", emissiveFactor=[1, 1, 1], extensions={
            "KHR_materials_emissive_strength": {"emissiveStrength": nits}}, **rest)


def emitter_scene(subject, triangles, nits, at):
    stage = Stage(subject)
    stage.node(subject, add_mesh(stage.file, subject, flat_shaded(triangles), stage.glow(nits)), at)
    return stage.to_bytes()


def disk_scene(corners):
    stage = Stage("disk")
    rim = [(math.cos(2 * math.pi * i / corners), math.sin(2 * math.pi * i / corners), 0.0)
           for i in range(corners)]
    positions = [(0.0, 0.0, 0.0)] + [tuple(0.5 * x for x in p) for p in rim]
    triangles = [(0, 1 + i, 1 + (i + 1) % corners) for i in range(corners)]
    shape = (positions, [(0.0, 0.0, 1.0)] * len(positions), triangles)
    stage.node("disk", add_mesh(stage.file, "disk", shape, stage.glow(100)), (0, 1, -0.4))
    return stage.to_bytes()


def mask_scene():
    """White where a coarse pattern is open, a quarter of all."""
    stage = Stage("mask")
    size = 64

    def rows():
        for y in range(size):
            yield b"".join(bytes((255, 255, 255, 255 if x // 8 % 2 and y // 8 % 2 else 0))
                           for x in range(size))

    texture = stage.file.texture("mask", glb.png(size, size, 4, rows()))
    material = stage.glow(100, alphaMode="MASK", pbrMetallicRoughness={
        "baseColorTexture": {"index": texture}, "metallicFactor": 0})
    quad = flat_shaded([((-0.5, -0.5, 0), (0.5, -0.5, 0), (0.5, 0.5, 0)),
                        ((-0.5, -0.5, 0), (0.5, 0.5, 0), (-0.5, 0.5, 0))])
    stage.node("panel", add_mesh(stage.file, "panel", quad, material,
                                 tex_coords=[(p[0] + 0.5, 0.5 - p[1]) for p in quad[0]]),
               (0, 1, -0.4))
    return stage.to_bytes()


def scenes():
    letters = lettering("COSODUNS", 0.42)
    yield "neon.glb", lambda: emitter_scene("neon", letters, 0.5, (0.1, 0.8, -0.6))
    fine = knot(380, 14)
    power = 100 * area_of(fine)
    for along, around in ((8, 6), (48, 10), (380, 14)):
        tube = knot(along, around)
        yield ("knot-%d.glb" % len(tube),
               lambda tube=tube: emitter_scene("knot", tube, power / area_of(tube), (0, 1.1, -0.1)))
    yield "overlapping.glb", lambda: emitter_scene("overlapping", overlapping_quads(10000), 10,
                                                   (0, 1, -0.4))
    yield "disk.glb", lambda: disk_scene(40000)
    yield "mask.glb", mask_scene


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    os.makedirs(sys.argv[1], exist_ok=True)
    for name, make in scenes():
        with open(os.path.join(sys.argv[1], name), "wb") as stream:
            stream.write(make())


if __name__ == "__main__":
    main()
