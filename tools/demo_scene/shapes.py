# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The demo scene's shapes, as (positions, normals, triangles): counter-clockwise, unit normals."""

import math


def icosphere(level):
    """The unit sphere: an icosahedron, each triangle split into four `level` times."""
    golden = (1 + math.sqrt(5)) / 2
    points = [(-1, golden, 0), (1, golden, 0), (-1, -golden, 0), (1, -golden, 0),
              (0, -1, golden), (0, 1, golden), (0, -1, -golden), (0, 1, -golden),
              (golden, 0, -1), (golden, 0, 1), (-golden, 0, -1), (-golden, 0, 1)]
    points = [normalize(p) for p in points]
    triangles = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11),
                 (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
                 (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9),
                 (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(level):
        middle_of = {}

        def middle(i, j):
            key = (min(i, j), max(i, j))
            if key not in middle_of:
                middle_of[key] = len(points)
                points.append(normalize([a + b for a, b in zip(points[i], points[j])]))
            return middle_of[key]

        split = []
        for a, b, c in triangles:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            split += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        triangles = split
    return points, list(points), triangles


def normalize(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(x / length for x in v)


def flat(outline, triangles):
    """A flat polygon in the plane z = 0 that faces -Z, the way glTF's own lights shine.

    The outline is given counter-clockwise as seen by whom the light shines on, x to his right.
    """
    positions = [(-x, y, 0.0) for x, y in outline]
    return positions, [(0.0, 0.0, -1.0)] * len(positions), triangles


def rectangle(width, height):
    w, h = width / 2, height / 2
    return flat([(-w, -h), (w, -h), (w, h), (-w, h)], [(0, 1, 2), (0, 2, 3)])


def l_shape(width, height, stroke):
    """An L, its corner at the lower left, centred on its bounding box."""
    w, h = width / 2, height / 2
    outline = [(-w, -h), (w, -h), (w, -h + stroke), (-w + stroke, -h + stroke),
               (-w + stroke, h), (-w, h)]
    return flat(outline, [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)])


def hexagon_ring(outer_radius, inner_radius):
    """A hexagon standing on a corner, with a hexagonal hole."""
    angles = [math.radians(60 * k + 30) for k in range(6)]
    outline = [(r * math.cos(a), r * math.sin(a)) for r in (outer_radius, inner_radius)
               for a in angles]
    triangles = []
    for k in range(6):
        n = (k + 1) % 6
        triangles += [(k, n, 6 + k), (n, 6 + n, 6 + k)]
    return flat(outline, triangles)


def cove(half_width, front_z, radius, height, steps):
    """A wall along x that grows out of the floor at z = front_z in a quarter circle."""
    profile = []  # (z, y, normal z, normal y)
    for k in range(steps + 1):
        angle = math.radians(90 * k / steps)
        s, c = math.sin(angle), math.cos(angle)
        profile.append((front_z - radius * s, radius * (1 - c), s, c))
    profile.append((front_z - radius, height, 1.0, 0.0))
    positions, normals, triangles = [], [], []
    for z, y, nz, ny in profile:
        for x in (-half_width, half_width):
            positions.append((x, y, z))
            normals.append(normalize((0.0, ny, nz)))
    for k in range(len(profile) - 1):
        a, b, c, d = 2 * k, 2 * k + 1, 2 * k + 2, 2 * k + 3
        triangles += [(a, b, d), (a, d, c)]
    return positions, normals, triangles
