#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Makes tests/image/flip_reference.h: what the FLIP authors' own program says about small pictures
that the test makes for itself.

    python3 -m venv /tmp/flip && /tmp/flip/bin/pip install flip-evaluator==1.7 numpy
    /tmp/flip/bin/python tools/make_flip_reference.py > tests/image/flip_reference.h

The pictures are made here and, by the same arithmetic, in tests/image/flip_pairs.cpp. The package
flip-evaluator (BSD-3-Clause) is the authors' C++ code behind a Python interface; none of it is part
of this project.
"""

import importlib.metadata

import flip_evaluator
import numpy as np

WIDTH, HEIGHT = 96, 64


def random(seed):
    """Values in [0, 1) of shape (HEIGHT, WIDTH, 3) by an integer hash of their place."""
    n = np.arange(HEIGHT * WIDTH * 3, dtype=np.uint64)
    h = (n * 2654435761 + seed * 974711) & 0xFFFFFFFF
    for shift, factor in ((16, 0x7FEB352D), (15, 0x846CA68B)):
        h = ((h ^ (h >> shift)) * factor) & 0xFFFFFFFF
    h ^= h >> 16
    return ((h >> 8) / 2.0**24).reshape(HEIGHT, WIDTH, 3)


Y, X, C = np.meshgrid(np.arange(HEIGHT), np.arange(WIDTH), np.arange(3), indexing="ij")
U, V = (X + 0.5) / WIDTH, (Y + 0.5) / HEIGHT


def gradient():
    return np.where(C == 0, U, np.where(C == 1, V, 1 - 0.5 * U - 0.5 * V))


def checker(shift):
    return np.where(((X + shift) // 12 + Y // 12) % 2 == 0, 0.8, 0.25 - 0.05 * C)


def glow():
    """Six decades of radiance, with a light."""
    light = ((X - 60) ** 2 + (Y - 20) ** 2 < 64) * (200.0 - 50.0 * C)
    return 10.0 ** (4 * U - 3) * (0.5 + 0.25 * C * V) + light


def dark():
    """More than half of it black."""
    return np.where(X < 30, 2.0 * V + 0.1 * C, 0.0)


# name, dynamic range, test picture, reference picture, pixels per degree
PAIRS = [
    ("noise", "LDR", np.clip(gradient() + 0.2 * (random(1) - 0.5), 0, 1), gradient(), 67),
    ("shifted edges", "LDR", checker(1), checker(0), 67),
    ("swapped colours", "LDR", np.roll(gradient(), 1, axis=2), gradient(), 67),
    ("black and white", "LDR", 0 * U, 0 * U + 1, 67),
    ("far noise", "LDR", random(2), random(3), 100),
    ("near noise", "LDR", random(2), random(3), 25.5),
    ("hdr noise", "HDR", glow() * (0.8 + 0.4 * random(4)), glow(), 67),
    ("hdr brighter", "HDR", 1.1 * glow(), glow(), 67),
    ("hdr black", "HDR", dark() * 1.2, dark(), 67),
    ("hdr half black", "HDR", dark() * 1.2 + 0.01, dark() + 0.001, 67),
]
PIXELS = [(0, 0), (95, 63), (48, 32), (60, 20), (11, 12), (70, 50)]


def main():
    version = importlib.metadata.version("flip-evaluator")
    print("// Copyright (c) 2026 The OpenLTC authors")
    print("// SPDX-License-Identifier: MIT")
    print("//")
    print(f"// Made by tools/make_flip_reference.py with flip-evaluator {version}; do not edit.")
    print("// clang-format off")
    print()
    print("#pragma once\n")
    print("namespace openltc::image::test {\n")
    print("struct FlipReference {")
    print("  const char* name;")
    print("  bool hdr;")
    print("  float pixels_per_degree;")
    print("  double mean, start_exposure, stop_exposure;")
    print("  int exposure_count;")
    print(f"  float pixels[{len(PIXELS)}]; // at k_flip_pixels")
    print("};\n")
    places = ", ".join(f"{{{x}, {y}}}" for x, y in PIXELS)
    print(f"inline constexpr int k_flip_pixels[{len(PIXELS)}][2] = {{{places}}};\n")
    print("inline constexpr FlipReference k_flip_references[] = {")
    for name, kind, test, reference, ppd in PAIRS:
        flip_map, mean, used = flip_evaluator.evaluate(
            reference.astype(np.float32), test.astype(np.float32), kind, inputsRGB=True,
            applyMagma=False, parameters={"ppd": float(ppd)})
        flip_map = np.asarray(flip_map).reshape(HEIGHT, WIDTH)
        mean = float(np.mean(flip_map, dtype=np.float64))  # the program's own sum is in single precision
        values = ", ".join(f"{flip_map[y, x]:.6f}f" for x, y in PIXELS)
        hdr = kind == "HDR"
        start, stop, count = (
            (used["startExposure"], used["stopExposure"], used["numExposures"]) if hdr else (0, 0, 0))
        print(f'    {{"{name}", {str(hdr).lower()}, {float(ppd)}f, {mean:.7f}, {start:.5f}, {stop:.5f},'
              f" {count},\n     {{{values}}}}},")
    print("};\n")
    print("} // namespace openltc::image::test")


main()
