#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Sends rays to two meshes of 9,600 triangles by the package's texture of triangles, on both back ends of WebGPURenderer,
and asks what three-mesh-bvh says on the processor: whether a ray meets them, and how far it gets.

    rays.py --openltc PROGRAM [--web FOLDER] --work DIR

FOLDER is what `make web` makes; without it the package is made below DIR. Exit code 0: the answers are the same; 1: they are not; 77: nothing could run, and why."""

import argparse
import os
import sys

k_here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(os.path.dirname(k_here), "parity"), os.path.join(os.path.dirname(k_here), "engines"), k_here]
import browser
from app_pages import build_packages
from engines import skip

# Rays of 16,384 whose answer is another, at the mesh's outline. Measured: 0.
k_others = 20


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--openltc", required=True)
    parser.add_argument("--web")
    parser.add_argument("--work", required=True)
    arguments = parser.parse_args()
    program = browser.find()
    if not program:
        skip("chromium not found (package chromium)")
    os.makedirs(arguments.work, exist_ok=True)
    web = arguments.web or build_packages(arguments.openltc, os.path.abspath(arguments.work))
    answers = browser.run(program, os.path.join(k_here, "rays.html"), arguments.work, [],
                          root=os.path.abspath(web), timeout=400)
    failed = "done" not in answers
    for name, facts in answers.items():
        if "failed" in facts:
            print("%s: %s" % (name, facts["failed"]))
            failed = True
        elif name != "done":
            print("%s: %d rays of 16384 meet the mesh, %d have another answer; %.0f ms for the first picture, %.0f for the "
                  "quickest other" % (name, facts["meet"], facts["others"], facts["first"], facts["rest"]))
            failed |= facts["meet"] < 5000 or facts["others"] > k_others
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
