#!/bin/sh
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# Makes the built-in GGX tables and polynomials anew: tools/make_builtin_lobes.sh [path of openltc]
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
openltc=${1:-$root/build/release/bin/openltc}
"$openltc" fit --brdf ggx --size 64 -o "$root/openltc/api/ggx_table.inc"
"$openltc" fit --brdf ggx --form two-lobe --size 32 -o "$root/openltc/api/ggx_two_lobes.inc"
"$openltc" fit --brdf ggx --form polynomial --degree 4 -o "$root/openltc/api/ggx_polynomial.inc"
"$openltc" fit --brdf ggx --form two-lobe-polynomial --degree 4 \
  -o "$root/openltc/api/ggx_two_lobe_polynomial.inc"
