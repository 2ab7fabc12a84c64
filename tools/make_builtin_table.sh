#!/bin/sh
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# Makes the built-in GGX table anew: tools/make_builtin_table.sh [path of the openltc program]
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
exec "${1:-$root/build/bin/openltc}" fit --brdf ggx --size 64 -o "$root/openltc/table/builtin_ggx.cpp"
