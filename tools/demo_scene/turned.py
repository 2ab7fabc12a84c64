# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Turned and flat shapes for scenes/lights.glb, as (positions, normals, triangles).

Round things are turned around the X axis, along which openltc_light's tubes lie too. A profile is a
list of (x, radius, normal along x, normal along the radius), from the end at -X to that at +X.
"""

import math

from demo_scene import shapes


def turned(profiles, segments):
    """Surfaces of revolution; smooth along each profile, with an edge from one to the next."""
    positions, normals, triangles = [], [], []
    for profile in profiles:
        first = len(positions)
        for x, radius, nx, nr in profile:
            for k in range(segments):
                angle = 2 * math.pi * k / segments
                c, s = math.cos(angle), math.sin(angle)
                positions.append((x, radius * c, radius * s))
                normals.append(shapes.normalize((nx, nr * c, nr * s)))
        for row in range(len(profile) - 1):
            for k in range(segments):
                a, b = first + row * segments + k, first + row * segments + (k + 1) % segments
                c, d = a + segments, b + segments
                if profile[row + 1][1] > 0:
                    triangles.append((a, d, c))
                if profile[row][1] > 0:
                    triangles.append((a, b, d))
    return positions, normals, triangles


def side(length, radius):
    return [(-length / 2, radius, 0, 1), (length / 2, radius, 0, 1)]


def cylinder(length, radius, segments=96):
    h = length / 2
    return turned([[(-h, 0, -1, 0), (-h, radius, -1, 0)], side(length, radius),
                   [(h, radius, 1, 0), (h, 0, 1, 0)]], segments)


def open_tube(length, radius, segments=96):
    return turned([side(length, radius)], segments)


def capsule(length, radius, segments=64, steps=16):
    """Of this length without its round ends."""
    profile = []
    for end, start in ((-1, 180), (1, 90)):
        for k in range(steps + 1):
            angle = math.radians(start - 90 * k / steps)
            c, s = math.cos(angle), math.sin(angle)
            s = 0 if k == (0 if end < 0 else steps) else s
            profile.append((end * length / 2 + radius * c, radius * s, c, s))
    return turned([profile], segments)


def curve(points, steps=8):
    """A smooth profile through points (x, radius): Catmull and Rom's spline, and its normals."""
    profile = []
    for i in range(len(points) - 1):
        p = [points[max(i - 1, 0)], points[i], points[i + 1], points[min(i + 2, len(points) - 1)]]
        for k in range(steps + (i == len(points) - 2)):
            t = k / steps
            value = [0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t
                            + (3 * b - a - 3 * c + d) * t ** 3) for a, b, c, d in zip(*p)]
            slope = [0.5 * ((c - a) + 2 * (2 * a - 5 * b + 4 * c - d) * t
                            + 3 * (3 * b - a - 3 * c + d) * t * t) for a, b, c, d in zip(*p)]
            profile.append((value[0], max(value[1], 0.0), -slope[1], slope[0]))
    return profile


def ellipse(radius_x, radius_y, segments=128):
    """Flat, in the plane z = 0, facing -Z."""
    rim = [(radius_x * math.cos(2 * math.pi * k / segments),
            radius_y * math.sin(2 * math.pi * k / segments)) for k in range(segments)]
    return shapes.flat([(0.0, 0.0)] + rim,
                       [(0, 1 + k, 1 + (k + 1) % segments) for k in range(segments)])


def star(points, outer_radius, inner_radius, hole):
    """A star with a hole of its own form, `hole` times as large; flat, facing -Z."""
    count = 2 * points
    outline = []
    for scale in (1.0, hole):
        for k in range(count):
            angle = math.pi / 2 + 2 * math.pi * k / count
            r = scale * (inner_radius if k % 2 else outer_radius)
            outline.append((r * math.cos(angle), r * math.sin(angle)))
    triangles = []
    for k in range(count):
        n = (k + 1) % count
        triangles += [(k, n, count + k), (n, count + n, count + k)]
    return shapes.flat(outline, triangles)


def box(width, height, depth):
    """Centred on the origin."""
    half = (width / 2, height / 2, depth / 2)
    positions, normals, triangles = [], [], []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for sign in (-1.0, 1.0):
            first = len(positions)
            for su, sv in ((-1, -1), (sign, -sign), (1, 1), (-sign, sign)):
                p = [0.0, 0.0, 0.0]
                p[axis], p[u], p[v] = sign * half[axis], su * half[u], sv * half[v]
                positions.append(tuple(p))
                n = [0.0, 0.0, 0.0]
                n[axis] = sign
                normals.append(tuple(n))
            triangles += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
    return positions, normals, triangles
