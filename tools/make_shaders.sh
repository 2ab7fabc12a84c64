#!/bin/sh
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# Makes the files of shaders/ anew: tools/make_shaders.sh [path of openltc]
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
openltc=${1:-$root/build/release/bin/openltc}
for language in glsl glsl-es hlsl metal wgsl gdshader; do
  for what in "--shapes quad" "--shapes quad --lobe two-lobe-polynomial" "--shapes quad --lobe table" \
    "--shapes quad --lean" \
    "--shapes all"; do
    # shellcheck disable=SC2086
    "$openltc" shaders --language "$language" $what --quiet -o "$root/shaders"
  done
done
