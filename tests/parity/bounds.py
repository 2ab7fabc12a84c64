# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""What results may differ by from double precision. Just above what was measured (shaders/README.md): a half more,
since compilers choose other orders and fuse other multiplications and additions.

"exact": drivers whose sine, cosine and square root are those of IEEE 754 or of a good library. "approximate":
SwiftShader, graphics processors."""

# Shape -> of rough surfaces: 99 of 100 below, the largest; of smooth ones: 99 of 100 below; of adversarial ones:
# the share that rounding of the inputs does not explain.
k_bounds = {
    "exact": {},
    "approximate": {},
}


def breaches(kind, shape, figures):
    """What is wrong with the figures of a shape, in words."""
    rough, smooth, hard = figures["rough"], figures["smooth"], figures["adversarial"]
    found = ["%s: %d numbers are negative, infinite or none" % (group, figures[group]["wrong"])
             for group in figures if figures[group]["wrong"]]
    usual, most, narrow, share = k_bounds[kind].get(shape, (1, 1, 1, 1))
    for name, value, bound in (("rough, 99 of 100", rough["p99"], usual), ("rough, largest", rough["largest"], most),
                               ("smooth, 99 of 100", smooth["p99"], narrow),
                               ("adversarial, share beyond rounding", hard["beyond"] / hard["count"], share)):
        if not value <= bound:
            found.append("%s: %.2g, more than %.2g" % (name, value, bound))
    return found
