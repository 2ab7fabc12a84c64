#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Frames by two worker processes beside one, by turns in one run, and what a task costs the scheduler.

    cluster.py [--rounds N] [--frames N] [--width N] [--tasks N]

Beside it the same for the bare tool, two of it at once and one: what the cores give just now. Wants the
package on PYTHONPATH and Dask; `make bench-python` sets all of it."""

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
import time

import distributed
import openltc
from openltc import _many, _tool

k_here = os.path.dirname(os.path.abspath(__file__))
sys.path.append(os.path.join(k_here, "..", "..", "tests", "python"))
from moving_scene import write_moving_scene  # noqa: E402


def nothing(task, *, threads):
    return task


def seconds(call):
    begin = time.perf_counter()
    call()
    return time.perf_counter() - begin


def show(took, frames, size):
    middle = {key: statistics.median(values) for key, values in took.items()}
    print(f"{frames} frames of {size}, one thread each: "
          + ", ".join(f"{key} {value:.2f} s" for key, value in middle.items()))
    for one, two in (("1 worker", "2 workers"), ("1 process", "2 processes")):
        ratios = [a / b for a, b in zip(took[one], took[two])]
        print(f"{two} against {one}: {statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f})")
    print(f"a worker's frame beside the bare tool's: {(middle['1 worker'] - middle['1 process']) / frames:+.3f} s")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--frames", type=int, default=12)
    parser.add_argument("--width", type=int, default=320, help="of a frame, 16 to 9")
    parser.add_argument("--tasks", type=int, default=2000)
    arguments = parser.parse_args()
    width, height = arguments.width, arguments.width * 9 // 16
    options = dict(width=width, height=height, samples=4, threads=1)
    words = ["--size", f"{width}x{height}", "--samples", "4", "--threads", "1", "--quiet"]
    folder = tempfile.TemporaryDirectory()
    scene = write_moving_scene(os.path.join(folder.name, "moving.glb"))
    turn = 0

    def place():
        nonlocal turn
        turn += 1
        os.mkdir(os.path.join(folder.name, str(turn)))
        return os.path.join(folder.name, str(turn), "f.####.exr")

    def bare(processes):
        """All frames by the tool alone, the frames dealt out beforehand."""
        output = place()
        parts = [range(k, arguments.frames, processes) for k in range(processes)]
        running = [subprocess.Popen([_tool.path(), "render", scene, *words, "-o", output, "--frames",
                                     ",".join(map(str, part))], stderr=subprocess.PIPE) for part in parts]
        for process in running:
            if process.wait():
                sys.exit(process.stderr.read().decode())

    print(f"load before: {os.getloadavg()[0]:.1f} on {len(os.sched_getaffinity(0))} cores")
    took = {key: [] for key in ("1 worker", "2 workers", "1 process", "2 processes")}
    clusters = {n: distributed.LocalCluster(n_workers=n, threads_per_worker=1, dashboard_address=None)
                for n in (1, 2)}
    clients = {n: distributed.Client(cluster) for n, cluster in clusters.items()}
    for _ in range(arguments.rounds):
        for n, client in clients.items():
            took[f"{n} worker" + "s" * (n > 1)].append(seconds(lambda: openltc.cluster.render_sequence(
                scene, range(arguments.frames), place(), client=client, **options)))
            took[f"{n} process" + "es" * (n > 1)].append(seconds(lambda: bare(n)))
    if arguments.rounds:
        show(took, arguments.frames, f"{width} x {height}")
    # The scheduler and the caller are this process: its own time does not depend on what else runs.
    for n, client in clients.items():
        tasks = {k: k for k in range(arguments.tasks)}
        begin, cpu = time.perf_counter(), time.process_time()
        _many.run(tasks, nothing, {}, client, False, "", "task")
        wall, cpu = time.perf_counter() - begin, time.process_time() - cpu
        print(f"{arguments.tasks} tasks that do nothing, {n} of one thread: {1e3 * wall / arguments.tasks:.2f} ms each, "
              f"{1e3 * cpu / arguments.tasks:.2f} ms of processor time in scheduler and caller")
    print(f"load after: {os.getloadavg()[0]:.1f}")
    for n in clients:
        clients[n].close()
        clusters[n].close()


if __name__ == "__main__":
    main()
