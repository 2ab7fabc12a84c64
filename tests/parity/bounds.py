# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""What results may differ by from double precision: what was measured (shaders/README.md) and some half more, since
compilers choose other orders and fuse other multiplications and additions.

"exact": C++, and lavapipe, whose sine, cosine and logarithm are good to the last digits. "swiftshader": the driver
that Chromium brings, which approximates those. "unmeasured": others; all that is asked is finite numbers, none of
them negative."""

# Shape -> of rough surfaces: 99 of 100 below, the largest; of smooth ones: 99 of 100 below; of adversarial ones:
# the share that rounding of the inputs does not explain.
k_bounds = {
    "exact": {
        "quad": (1.5e-7, 1.5e-6, 2.5e-7, 0.035),
        "polygon": (1.5e-7, 1e-6, 2.5e-7, 0.015),
        "disk": (4e-7, 1e-5, 5e-6, 0.025),
        "sphere": (6e-7, 1.5e-5, 3e-6, 0.004),
        "tube": (4e-7, 2.5e-5, 3e-6, 0.008),
        "line": (2e-6, 3e-5, 1.5e-4, 0.035),
    },
    "swiftshader": {
        "quad": (1.5e-7, 1.5e-6, 2.5e-7, 0.025),
        "polygon": (1.5e-7, 1e-6, 2.5e-7, 0.015),
        "disk": (1.2e-5, 1.5e-4, 1.2e-5, 0.045),
        "sphere": (1.6e-5, 1e-4, 8e-6, 0.015),
        "tube": (1.6e-5, 5e-4, 8e-6, 0.03),
        "line": (6e-5, 4e-3, 1.5e-4, 0.035),
    },
    "unmeasured": {},
}


def breaches(kind, shape, figures):
    """What is wrong with the figures of a shape, in words."""
    found = ["%s: %d numbers are negative, infinite or none" % (group, figures[group]["wrong"])
             for group in figures if figures[group]["wrong"]]
    if shape not in k_bounds[kind]:
        return found
    rough, smooth, hard = figures["rough"], figures["smooth"], figures["adversarial"]
    usual, most, narrow, share = k_bounds[kind][shape]
    for name, value, bound in (("rough, 99 of 100 below", rough["p99"], usual),
                               ("rough, largest", rough["largest"], most),
                               ("smooth, 99 of 100 below", smooth["p99"], narrow),
                               ("adversarial, share beyond rounding", hard["beyond"] / hard["count"], share)):
        if not value <= bound:
            found.append("%s: %.2g, more than %.2g" % (name, value, bound))
    return found
