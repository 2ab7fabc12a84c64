#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Compares two outputs of tests/api/portable_numbers.cpp.

    compare_numbers.py ONE OTHER TOLERANCE

Values of a line are compared relative to the largest of the line, and to a hundredth at least of what
a light of radiance 1 can give: light that is next to nothing is a difference of large numbers, whose
rounding it has. Prints the largest difference and its line; exit code 1 if it is above TOLERANCE, or if
the lines are not the same ones.
"""

import sys

k_least = 0.01


def read(path):
    with open(path, encoding="ascii") as stream:
        return [line.split() for line in stream]


def main():
    one, other, tolerance = read(sys.argv[1]), read(sys.argv[2]), float(sys.argv[3])
    if [line[:2] for line in one] != [line[:2] for line in other]:
        print("DIFFERS: other lines, %d for %d" % (len(other), len(one)))
        return 1
    worst, where, equal = 0.0, "", 0
    for a, b in zip(one, other):
        x, y = [float(v) for v in a[2:]], [float(v) for v in b[2:]]
        scale = max([abs(v) for v in x + y] + [k_least])
        difference = max(abs(p - q) for p, q in zip(x, y)) / scale
        equal += a == b
        if difference > worst or difference != difference:
            worst, where = difference, " ".join(a[:2])
    verdict = "" if worst <= tolerance else "DIFFERS: "
    print("%s%d of %d lines alike to the digit, largest difference %.2g (%s)"
          % (verdict, equal, len(one), worst, where))
    return 0 if worst <= tolerance else 1


if __name__ == "__main__":
    sys.exit(main())
