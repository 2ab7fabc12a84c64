#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Memory that openltc.shade takes beside the arrays of its caller.

    shade_memory.py POINTS float32|float64

Normals and views are of a stride that is converted, a slice at a time. Wants the package on PYTHONPATH."""

import resource
import sys
import time

import numpy as np
import openltc


def resident():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20


def main():
    count, dtype = int(float(sys.argv[1])), np.dtype(sys.argv[2])
    positions = np.zeros((count, 3), dtype)
    positions[:, 0] = np.linspace(-2, 2, count, dtype=dtype)
    normals = np.broadcast_to(np.array([0, 1, 0], np.float32), (count, 3))
    views = np.broadcast_to(np.array([0, 1, 0.5], np.float32), (count, 3))
    out = np.ones((count, 3), np.float32)
    lamp = openltc.Rectangle(center=(0, 1, 0), half_u=(0.5, 0, 0), half_v=(0, 0, 0.5), radiance_nits=100)
    before, begin = resident(), time.perf_counter()
    openltc.shade(positions, normals, views, openltc.Material(), [lamp], out=out)
    print(f"{count} points, {dtype}: {before:.2f} GiB of arrays, {resident() - before:.2f} GiB more at most, "
          f"{time.perf_counter() - begin:.1f} s")


if __name__ == "__main__":
    main()
