#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Runs the tests of the Python package, and the examples in its docstrings.

    run.py --package FOLDER --openltc TOOL [--missing FILE] [TEST...]

FOLDER/openltc is the package with the module of a build.
Exit code 0: all passed; 1: one did not; 77: there is no module, and why."""

import argparse
import os
import sys
import unittest

k_here = os.path.dirname(os.path.abspath(__file__))
k_root = os.path.dirname(os.path.dirname(k_here))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--package", required=True)
    parser.add_argument("--openltc", required=True)
    parser.add_argument("--missing", default="")
    parser.add_argument("tests", nargs="*")
    arguments = parser.parse_args()
    package = os.path.abspath(arguments.package)
    built = os.path.isdir(os.path.join(package, "openltc")) and any(
        name.startswith("_openltc") for name in os.listdir(os.path.join(package, "openltc")))
    if not built or os.path.exists(arguments.missing):
        why = "the option OPENLTC_PYTHON_MODULE"
        if os.path.exists(arguments.missing):
            with open(arguments.missing) as file:
                why = file.read().strip()
        print(f"skipped: the Python package, without {why}")
        return 77
    os.environ["OPENLTC"] = os.path.abspath(arguments.openltc)
    os.environ["PYTHONPATH"] = package
    sys.path[:0] = [package, k_here]
    os.chdir(k_root)
    loader = unittest.defaultTestLoader
    tests = loader.loadTestsFromNames(arguments.tests) if arguments.tests else loader.discover(k_here)
    return 0 if unittest.TextTestRunner(verbosity=2).run(tests).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
