#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
#   tools/metal_floor.sh    how far one lobe is from a metal floor seen at 80 degrees from its normal
#
# For roughness 0.2 to 0.6: the mean relative error of the LTC picture against the reference, without
# shadows and without a pixel filter, in the reflection of a lamp and beside it (the lamp 2 m to the side),
# and in the reflection at 40 degrees. Environment, with defaults:
#   OPENLTC=build/release/bin/openltc   OUT=out/metal_floor   SIZE=160x90   REFERENCE_SAMPLES=512
set -euo pipefail
tool="${OPENLTC:-build/release/bin/openltc}"
out="${OUT:-out/metal_floor}"
size="${SIZE:-160x90}"
mkdir -p "$out"

printf '%-10s %16s %16s %16s\n' "roughness" "80 degrees" "80, beside it" "40 degrees"
for roughness in 0.2 0.3 0.4 0.5 0.6; do
  printf '%-10s' "$roughness"
  for place in "80 0" "80 2" "40 0"; do
    read -r degrees aside <<<"$place"
    name="$out/${roughness}_${degrees}_$aside"
    python3 -B "$(dirname "$0")/make_metal_floor.py" "$name.glb" "$roughness" "$degrees" "$aside"
    common=("$name.glb" --size "$size" --filter none --shadow-samples 0 --quiet)
    "$tool" render "${common[@]}" --samples 1 -o "$name.exr"
    "$tool" render "${common[@]}" --integrator reference --samples "${REFERENCE_SAMPLES:-512}" \
      -o "${name}_reference.exr"
    "$tool" compare "$name.exr" "${name}_reference.exr" --json |
      python3 -c 'import json, sys
print(" %14.1f %%" % (100 * json.load(sys.stdin)["mean_relative_error"]), end="")'
  done
  printf '\n'
done
