# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Cases of a quad for shaders that are timed: a metal floor, 6 m wide, of roughness 0.4, and a quad of 2 m by
1.6 m. Layout of a case: shader_case.h."""

import array
import math

k_normal, k_albedo, k_f0, k_roughness = (0.0, 0.0, 1.0), 0.5, 1.0, 0.4
k_eye = (0.0, -6.0, 2.0)
k_columns, k_rows, k_row_step = 80, 40, 5  # tiles of 8 x 8 points, of which every fifth row is taken

# Middle of the quad and its half sides; it faces down, or from behind to the eye.
k_places = {
    "above": ((0.0, 0.0, 2.0), (1.0, 0.0, 0.0), (0.0, -0.8, 0.0)),
    "upright": ((0.0, 2.0, 1.2), (1.0, 0.0, 0.0), (0.0, 0.0, 0.8)),
    "cut by the floor": ((0.0, 2.0, 0.3), (1.0, 0.0, 0.0), (0.0, 0.0, 0.8)),
}


def points():
    """Points of the floor, those of a tile of 8 x 8 one after the other, as a group of lanes has them."""
    width, height = 8 * k_columns - 1, 8 * k_rows - 1
    for row in range(0, k_rows, k_row_step):
        for column in range(k_columns):
            for i in range(64):
                yield -3.0 + 6.0 * (8 * column + i % 8) / width, -3.0 + 6.0 * (8 * row + i // 8) / height


def write_cases(place, path):
    """Returns how many there are."""
    cases = array.array("f")
    center, half_u, half_v = k_places[place]
    for x, y in points():
        eye = (k_eye[0] - x, k_eye[1] - y, k_eye[2])
        length = math.sqrt(sum(t * t for t in eye))
        cases.extend((x, y, 0.0, k_roughness, *k_normal, k_albedo, *(t / length for t in eye), k_f0,
                      0.0, 0.0, 1.0, 0.0, *center, 0.0, *half_u, 0.0, *half_v, 0.0))
    with open(path, "wb") as stream:
        cases.tofile(stream)
    return len(cases) // 28


def read_light(path):
    """The light of each case, its red part."""
    values = array.array("f")
    with open(path, "rb") as stream:
        values.frombytes(stream.read())
    return values[0::4]
