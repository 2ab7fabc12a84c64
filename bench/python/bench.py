#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The Python module beside the tool and the C++ batch API: ratios of times, each taken in one run by turns.

    bench.py --bin build/release/bin [--rounds N]

Wants the package on PYTHONPATH; `make bench-python` sets all of it."""

import argparse
import json
import os
import re
import statistics
import subprocess
import sys
import time

k_import = "import time; t = time.perf_counter(); import openltc, numpy; openltc.fit; print(time.perf_counter() - t)"


def seconds(call, clock=time.perf_counter):
    begin = clock()
    call()
    return clock() - begin


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", default="build/release/bin")
    parser.add_argument("--rounds", type=int, default=5)
    arguments = parser.parse_args()

    begin = [float(subprocess.run([sys.executable, "-c", k_import], capture_output=True, text=True, check=True).stdout)
             for _ in range(arguments.rounds)]
    print(f"import openltc with NumPy: {statistics.median(begin):.3f} s")

    import numpy as np
    import openltc
    sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tests", "python"))
    from test_fit import ggx

    tool, named, own = [], [], []
    for _ in range(arguments.rounds):
        done = subprocess.run([os.path.join(arguments.bin, "openltc"), "fit", "-o", "/tmp/bench_python.json"],
                              capture_output=True, text=True)
        tool.append(float(re.search(r"in ([0-9.]+) s", done.stderr).group(1)))
        named.append(seconds(lambda: openltc.fit("ggx")))
        own.append(seconds(lambda: openltc.fit(ggx)))
    t, n, f = (statistics.median(v) for v in (tool, named, own))
    print(f"fit of 64 x 64 nodes: tool {t:.3f} s, by name {n:.3f} s ({n / t:.2f}), of a NumPy GGX {f:.3f} s ({f / n:.2f})")

    # bench_batch's own floor and rectangles, more of its points.
    side = 512
    x, z = np.meshgrid(np.arange(side) / side * 4 - 2, np.arange(side) / side * 4 - 2)
    positions = np.stack([x, 0 * x, z], -1).reshape(-1, 3).astype(np.float32)
    normals = np.tile(np.float32([0, 1, 0]), (len(positions), 1))
    views = (np.array([0, 1.5, 4]) - positions).astype(np.float32)
    out = np.empty_like(positions)
    batch = {1: [], 8: []}
    arrays = {1: [], 8: []}
    for _ in range(arguments.rounds):
        done = subprocess.run([os.path.join(arguments.bin, "bench_batch"), "--benchmark_filter=^batch",
                               "--benchmark_format=json"], capture_output=True, text=True, check=True)
        for b in json.loads(done.stdout)["benchmarks"]:
            batch[int(b["name"].split("/")[1])].append(1e9 / b["items_per_second"])
        for count in arrays:
            lamps = [openltc.Rectangle((k * 0.3 - 1, 1, 0), (0.1, 0, 0), (0, 0, 0.4), 1.0) for k in range(count)]

            def shade():
                openltc.shade(positions, normals, views, openltc.Material(), lamps, threads=1, out=out)

            shade()  # Google Benchmark counts none of its first calls either, and processor time alone
            arrays[count].append(seconds(shade, time.process_time) * 1e9 / len(positions) / count)
    for count in batch:
        c, p = statistics.median(batch[count]), statistics.median(arrays[count])
        print(f"a point and a light, {count} rectangles, one thread: C++ {c:.1f} ns, Python {p:.1f} ns ({p / c:.2f})")


if __name__ == "__main__":
    main()
