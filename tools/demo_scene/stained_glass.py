# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""A rose window: an emission texture of coloured panes between dark lead.

Every pixel asks which pane it lies in and how far the nearest lead is; four samples a pixel smooth
the edges. Panes differ a little in tone, and each is brighter towards one side, as blown glass is.
"""

import math

from demo_scene.parquet import noise, random_of, smoothstep, to_srgb_byte

k_size = 384    # pixels along an edge
k_lead = 0.011  # half the width of the lead, the window being 2 wide

k_ruby, k_amber, k_honey = (0.86, 0.05, 0.07), (1.0, 0.46, 0.06), (1.0, 0.74, 0.26)
k_cobalt, k_sky, k_emerald = (0.05, 0.13, 0.86), (0.20, 0.56, 0.98), (0.04, 0.56, 0.26)
k_violet = (0.40, 0.11, 0.72)

# Rings of panes: from radius, to radius, panes, turned by this share of a pane, colours in turn.
k_rings = [(0.00, 0.15, 1, 0.0, [k_honey]),
           (0.15, 0.36, 8, 0.0, [k_ruby, k_amber]),
           (0.36, 0.62, 16, 0.0, [k_cobalt, k_sky]),
           (0.62, 0.80, 16, 0.5, [k_ruby, k_violet]),
           (0.80, 0.95, 32, 0.0, [k_honey, k_emerald, k_amber, k_emerald])]


def pane_at(x, y):
    """(colour, pane's identity, distance to the nearest lead) of a point within [-1, 1]^2."""
    radius, angle = math.hypot(x, y), math.atan2(y, x) / (2 * math.pi) % 1.0
    to_frame = 1.0 - max(abs(x), abs(y))
    for ring, (inner, outer, count, turn, colors) in enumerate(k_rings):
        if radius < outer:
            place = (angle * count + turn) % count
            pane = int(place)
            edges = [outer - radius]
            if inner > 0:
                edges.append(radius - inner)
            if count > 1:
                edges.append(min(place - pane, pane + 1 - place) / count * 2 * math.pi * radius)
            return colors[pane % len(colors)], (ring, pane), min(edges + [to_frame])
    # The corners: a lattice of diamonds.
    u, v = (x + y) * 4.5, (x - y) * 4.5
    i, j = math.floor(u), math.floor(v)
    edge = min(u - i, i + 1 - u, v - j, j + 1 - v) / (4.5 * math.sqrt(2))
    color = (k_cobalt, k_emerald, k_sky)[(i + 2 * j) % 3]
    return color, (9, i, j), min(edge, radius - k_rings[-1][1], to_frame)


def glass_at(x, y):
    color, identity, distance = pane_at(x, y)
    tone = 0.72 + 0.28 * random_of(1, *identity)
    tilt = 2 * math.pi * random_of(2, *identity)
    shade = 1 + 0.35 * (x * math.cos(tilt) + y * math.sin(tilt)) * random_of(3, *identity)
    bubble = 0.86 + 0.28 * noise(40 + 13 * x, 40 + 13 * y)
    light = smoothstep(k_lead - 0.003, k_lead + 0.003, distance) * tone * shade * bubble
    return [c * light for c in color]


def rows():
    for j in range(k_size):
        row = bytearray()
        for i in range(k_size):
            total = [0.0, 0.0, 0.0]
            for dy in (0.25, 0.75):
                for dx in (0.25, 0.75):
                    sample = glass_at(2 * (i + dx) / k_size - 1, 1 - 2 * (j + dy) / k_size)
                    total = [t + 0.25 * s for t, s in zip(total, sample)]
            row += bytes(to_srgb_byte(t) for t in total)
        yield row
