#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Measures what shadows by WebGPURenderer could rest on, on both of its back ends: rays to a mesh of 9,600 triangles
through the tree of three-mesh-bvh in a texture. Their lengths are compared with those of the package on the processor.

    webgpu_rays.py --web FOLDER --work DIR

FOLDER is what `make web` makes. Exit code 0: it was measured; 1: they are others, or nothing was found; 77: nothing could run, and why."""

import argparse
import os
import sys

k_here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(os.path.dirname(k_here), "parity")]
import browser
from openltc import skip

# Rays of 16,384 that meet the mesh on one side alone, at its outline, and the mean difference of the others' lengths.
k_one, k_off = 20, 1e-5


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--web", required=True)
    parser.add_argument("--work", required=True)
    arguments = parser.parse_args()
    program = browser.find()
    if not program:
        skip("chromium not found (package chromium)")
    os.makedirs(arguments.work, exist_ok=True)
    answers = browser.run(program, os.path.join(k_here, "webgpu_rays.html"), arguments.work, [],
                          root=os.path.abspath(arguments.web), timeout=400)
    failed = "done" not in answers
    for name, facts in answers.items():
        if "failed" in facts:
            print("%s: %s" % (name, facts["failed"]))
            failed = True
        elif name != "done":
            print("%s: %d rays meet the mesh, %d on one side alone, off by %.1e in the mean; %.0f ms for the first picture, "
                  "%.0f for the quickest other" % (name, facts["both"], facts["one"], facts["off"], facts["first"], facts["rest"]))
            failed |= facts["both"] < 5000 or facts["one"] > k_one or not facts["off"] < k_off
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
