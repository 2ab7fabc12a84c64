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

k_side = 512  # points along each side of bench_batch's floor
k_import = "import time; t = time.perf_counter(); import openltc, numpy; openltc.fit; print(time.perf_counter() - t)"


def seconds(call, clock=time.perf_counter):
    begin = clock()
    call()
    return clock() - begin


def batch_api(folder, lights, threads):
    """Seconds of a call of shade_batch. One thread: processor time, which does not depend on what else runs."""
    done = subprocess.run([os.path.join(folder, "bench_batch"), "--benchmark_format=json", "--benchmark_filter="
                           f"^batch/side:{k_side}/lights:{lights}/threads:{threads}/"],
                          capture_output=True, text=True, check=True)
    found, = json.loads(done.stdout)["benchmarks"]
    return found["cpu_time" if threads == 1 else "real_time"] * {"ns": 1e-9, "us": 1e-6, "ms": 1e-3}[found["time_unit"]]


def arrays(openltc, np, lights, threads):
    """Seconds of openltc.shade of the same points and rectangles, as many calls as Google Benchmark makes: those of
    half a second."""
    x, z = np.meshgrid(np.arange(k_side) / k_side * 4 - 2, np.arange(k_side) / k_side * 4 - 2)
    positions = np.stack([x, 0 * x, z], -1).reshape(-1, 3).astype(np.float32)
    normals = np.tile(np.float32([0, 1, 0]), (len(positions), 1))
    views = (np.array([0, 1.5, 4]) - positions).astype(np.float32)
    out = np.empty_like(positions)
    lamps = [openltc.Rectangle((k * 0.3 - 1, 1, 0), (0.1, 0, 0), (0, 0, 0.4), 1.0) for k in range(lights)]

    def shade():
        openltc.shade(positions, normals, views, openltc.Material(), lamps, threads=threads, out=out)

    shade()  # Google Benchmark counts none of its first calls either
    calls = max(1, round(0.5 / seconds(shade)))
    return seconds(lambda: [shade() for _ in range(calls)], time.process_time if threads == 1 else time.perf_counter) / calls


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

    for threads, lights in ((1, 1), (1, 8), (0, 1), (0, 8)):
        pairs = [(batch_api(arguments.bin, lights, threads), arrays(openltc, np, lights, threads))
                 for _ in range(arguments.rounds)]
        c, p = (1e9 * statistics.median(v) / k_side**2 / lights for v in zip(*pairs))
        ratios = [p / c for c, p in pairs]
        print(f"{k_side**2} points by {lights} rectangle{'s' * (lights > 1)}, {'one thread' if threads else 'all cores'}: "
              f"C++ {c:.1f} ns a point and light, Python {p:.1f}: {statistics.median(ratios):.2f} "
              f"({min(ratios):.2f} to {max(ratios):.2f})")


if __name__ == "__main__":
    main()
