#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Frames by two worker processes beside one, by turns in one run, and what a task costs the scheduler.

    cluster.py [--rounds N] [--frames N] [--width N] [--tasks N] [--defaults]

Beside it the same for the bare tool, two of it at once and one: what the cores give just now. Only the cluster
that is measured is there, of workers as docs/python.md has them: an idle one takes time too, --defaults shows how
much. Wants the package on PYTHONPATH and Dask; `make bench-python` sets all of it."""

import argparse
import contextlib
import os
import statistics
import subprocess
import sys
import tempfile
import time

import dask
import distributed
import openltc
import psutil
from openltc import _many, _tool

k_here = os.path.dirname(os.path.abspath(__file__))
sys.path.append(os.path.join(k_here, "..", "..", "tests", "python"))
from moving_scene import write_moving_scene  # noqa: E402


k_others = 0.03
# What docs/python.md says of machines of few cores.
k_settings = {"distributed.worker.profile.enabled": False, "distributed.admin.tick.interval": "1s"}


@contextlib.contextmanager
def workers(count, settings):
    """A client of that many worker processes of one thread, which have imported openltc."""
    with dask.config.set(settings), \
            distributed.LocalCluster(n_workers=count, threads_per_worker=1, dashboard_address=None,
                                     silence_logs=50) as cluster, distributed.Client(cluster) as client:
        client.run(_many.threads_here, {})
        yield client


def nothing(task, *, threads):
    return task


def own_time():
    """Processor time of this process and all that it started, those that have ended too."""
    processes = [psutil.Process(), *psutil.Process().children(recursive=True)]
    return sum(sum(process.cpu_times()[:4]) for process in processes)


def busy_time():
    times = psutil.cpu_times()
    return sum(times) - times.idle - times.iowait - times.guest - times.guest_nice


def measure(call):
    """Seconds of a call, and the share of the machine that others took meanwhile."""
    begin, own, busy = time.perf_counter(), own_time(), busy_time()
    call()
    wall, own, busy = time.perf_counter() - begin, own_time() - own, busy_time() - busy
    return wall, max(0.0, busy - own) / wall / psutil.cpu_count()


def measure_idle(call, patience):
    """The same, begun when others take next to nothing, or after so many seconds."""
    until = time.monotonic() + patience
    while measure(lambda: time.sleep(1))[1] > k_others and time.monotonic() < until:
        pass
    return measure(call)


def idle(settings, duration=4):
    """What a cluster of two workers with nothing to do takes of a core: workers, scheduler and caller."""
    with workers(2, settings):
        begin = own_time()
        time.sleep(duration)
        return (own_time() - begin) / duration


def show(rounds, frames, size):
    """`rounds`: by "worker" and "process" the seconds of one and of two."""
    print(f"{frames} frames of {size}, one thread each")
    for kind, pairs in rounds.items():
        one, two = (statistics.median(values) for values in zip(*pairs))
        ratios = [one / two for one, two in pairs]
        print(f"one {kind} {one:.2f} s, two {two:.2f} s: {statistics.median(ratios):.2f} times "
              f"({min(ratios):.2f} to {max(ratios):.2f}, {len(pairs)} rounds)")
    if len(rounds) == 2:
        a, b = (statistics.median(one for one, _ in rounds[kind]) for kind in ("worker", "process"))
        print(f"a worker's frame beside the bare tool's: {(a - b) / frames:+.3f} s")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--frames", type=int, default=12)
    parser.add_argument("--width", type=int, default=320, help="of a frame, 16 to 9")
    parser.add_argument("--tasks", type=int, default=2000)
    parser.add_argument("--patience", type=float, default=5, help="seconds to wait for an idle machine, each time")
    parser.add_argument("--defaults", action="store_true", help="workers with Dask's own settings")
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
    settings = {} if arguments.defaults else k_settings
    rounds, disturbed = {}, 0

    def by_workers(n):
        with workers(n, settings) as client:
            return measure_idle(lambda: openltc.cluster.render_sequence(
                scene, range(arguments.frames), place(), client=client, **options), arguments.patience)

    def by_processes(n):
        return measure_idle(lambda: bare(n), arguments.patience)

    for turn_of in range(arguments.rounds):
        for kind, by in (("worker", by_workers), ("process", by_processes)):
            pair = [by(n) for n in ((1, 2) if turn_of % 2 == 0 else (2, 1))][::1 if turn_of % 2 == 0 else -1]
            (one, others), (two, more) = pair
            print(f"{kind}: one {one:.2f} s, two {two:.2f} s, {one / two:.2f} times; others took {others:.1%} and "
                  f"{more:.1%} of the machine", flush=True)
            if max(others, more) > k_others:
                disturbed += 1
            else:
                rounds.setdefault(kind, []).append((one, two))
    if disturbed:
        print(f"{disturbed} pairs are not counted: others took more than {k_others:.0%} of the machine")
    if rounds:
        show(rounds, arguments.frames, f"{width} x {height}")
    # The scheduler and the caller are this process: its own time does not depend on what else runs.
    for n in (1, 2) if arguments.tasks else ():
        tasks = {k: k for k in range(arguments.tasks)}
        with workers(n, settings) as client:
            begin, cpu = time.perf_counter(), time.process_time()
            _many.run(tasks, nothing, {}, client, False, "", "task")
            wall, cpu = time.perf_counter() - begin, time.process_time() - cpu
        print(f"{arguments.tasks} tasks that do nothing, {n} of one thread: {1e3 * wall / arguments.tasks:.2f} ms each, "
              f"{1e3 * cpu / arguments.tasks:.2f} ms of processor time in scheduler and caller")
    if arguments.tasks:
        print(f"two workers with nothing to do: {idle(k_settings):.1%} of a core, with Dask's own settings {idle({}):.1%}")
    print(f"load after: {os.getloadavg()[0]:.1f}")


if __name__ == "__main__":
    main()
