# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Herringbone parquet: base colour, normal and metallic-roughness textures that tile.

The pattern. On a grid of square cells (i, j) let k = (i - j) mod 2n. Cells with k < n belong to a
plank along i, n cells long; the others to a plank along j. The pattern repeats after 2n cells in
both directions. Every plank has its own tone, gloss, grain and a slight tilt: the tilt is what
makes a reflection jump from plank to plank, as it does on a real floor.
"""

import math

k_plank_cells = 4                  # length of a plank in widths of a plank
k_period_cells = 2 * k_plank_cells # one texture
k_size = 512                       # pixels along an edge of a texture


def random_of(*integers):
    """A number in [0, 1) that depends on the integers only (a multiplicative hash, 32 bits)."""
    state = 0x9E3779B9
    for i in integers:
        state = ((state ^ (i & 0xFFFFFFFF)) * 0x85EBCA6B) & 0xFFFFFFFF
        state ^= state >> 15
    state = (state * 0xC2B2AE35) & 0xFFFFFFFF
    return (state ^ (state >> 16)) / 4294967296.0


k_lattice = [random_of(i) for i in range(4096)]


def noise(x, y):
    """Smooth value noise in [0, 1], one feature per unit."""
    i, j = math.floor(x), math.floor(y)
    u, v = x - i, y - j
    u, v = u * u * (3 - 2 * u), v * v * (3 - 2 * v)
    a = k_lattice[(i * 61 + j * 977) & 4095]
    b = k_lattice[((i + 1) * 61 + j * 977) & 4095]
    c = k_lattice[(i * 61 + (j + 1) * 977) & 4095]
    d = k_lattice[((i + 1) * 61 + (j + 1) * 977) & 4095]
    return (a + (b - a) * u) * (1 - v) + (c + (d - c) * u) * v


def plank_at(x, y):
    """(plank's identity, along 0..n, across 0..1, True when it lies along x) at a point in cells."""
    i, j = math.floor(x), math.floor(y)
    k = (i - j) % k_period_cells
    if k < k_plank_cells:
        identity = (0, (i - k) % k_period_cells, j % k_period_cells)
        return identity, x - i + k, y - j, True
    k -= k_plank_cells
    # Along j the plank's first cell is the one with the largest k.
    k = k_plank_cells - 1 - k
    identity = (1, i % k_period_cells, (j - k) % k_period_cells)
    return identity, y - j + k, x - i, False


def smoothstep(lower, upper, x):
    t = min(max((x - lower) / (upper - lower), 0.0), 1.0)
    return t * t * (3 - 2 * t)


def wood_at(x, y):
    """(height in plank widths, linear rgb, roughness, slope along x, slope along y)."""
    identity, along, across, is_along_x = plank_at(x, y)
    tone, gloss = random_of(1, *identity), random_of(2, *identity)
    tilt_across = (random_of(3, *identity) - 0.5) * 0.030
    tilt_along = (random_of(4, *identity) - 0.5) * 0.012
    start = 37.0 * random_of(5, *identity)

    # Growth rings, cut lengthwise: bands along the plank that wander slowly.
    wander = noise(start + along * 0.55, start + across * 1.3)
    ring = 0.5 + 0.5 * math.sin(2 * math.pi * (across * 1.6 + 3.4 * wander + start))
    fibre = noise(start + along * 5.0, across * 46.0 + 3 * start)
    pore = smoothstep(0.70, 0.95, noise(along * 2.3 + 5 * start, across * 30.0 + 7 * start))
    blotch = noise(start + along * 0.9, 2 * start + across)

    # The edge is rounded off into a narrow joint.
    edge = min(across, 1 - across, along, k_plank_cells - along)
    joint = 1 - smoothstep(0.004, 0.022, edge)
    bevel = 1 - smoothstep(0.0, 0.045, edge)

    height = -0.010 * bevel * bevel - 0.010 * joint + 0.0006 * fibre - 0.0022 * pore + 0.0012 * ring
    shade = (0.55 + 0.75 * tone) * (0.74 + 0.34 * ring) * (0.86 + 0.28 * fibre) * (1 - 0.45 * pore)
    shade *= (0.85 + 0.3 * blotch) * (1 - 0.8 * joint)
    warmth = 0.5 + 0.35 * (tone - 0.5) + 0.3 * (ring - 0.5)
    rgb = (shade * 0.215, shade * (0.118 + 0.014 * (1 - warmth)),
           shade * (0.061 + 0.022 * (1 - warmth)))
    roughness = 0.10 + 0.10 * gloss + 0.05 * blotch + 0.04 * fibre + 0.14 * pore + 0.35 * joint
    slopes = (tilt_along, tilt_across) if is_along_x else (tilt_across, tilt_along)
    return height, rgb, roughness, slopes[0], slopes[1]


def to_srgb_byte(linear):
    linear = min(max(linear, 0.0), 1.0)
    coded = 12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055
    return int(coded * 255 + 0.5)


def to_byte(x):
    return int(min(max(x, 0.0), 1.0) * 255 + 0.5)


def make_textures():
    """Three lists of rows of RGB bytes: base colour, normal, metallic-roughness (G = roughness)."""
    size, cells_per_pixel = k_size, k_period_cells / k_size
    wood = [[wood_at((i + 0.5) * cells_per_pixel, (j + 0.5) * cells_per_pixel)
             for i in range(size)] for j in range(size)]
    colors, normals, roughnesses = [], [], []
    for j in range(size):
        above, row, below = wood[j - 1], wood[j], wood[(j + 1) % size]
        color, normal, roughness = bytearray(), bytearray(), bytearray()
        for i in range(size):
            _, rgb, rough, slope_x, slope_y = row[i]
            dx = (row[(i + 1) % size][0] - row[i - 1][0]) / (2 * cells_per_pixel) + slope_x
            dy = (below[i][0] - above[i][0]) / (2 * cells_per_pixel) + slope_y
            scale = 1 / math.sqrt(dx * dx + dy * dy + 1)
            color += bytes(to_srgb_byte(c) for c in rgb)
            # Rows run down the picture, the normal map's y runs up.
            normal += bytes((to_byte(0.5 - 0.5 * dx * scale), to_byte(0.5 + 0.5 * dy * scale),
                             to_byte(0.5 + 0.5 * scale)))
            roughness += bytes((255, to_byte(rough), 0))
        colors.append(bytes(color))
        normals.append(bytes(normal))
        roughnesses.append(bytes(roughness))
    return colors, normals, roughnesses
