#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
#   tools/render_scenes.sh FOLDER    render every glTF file below FOLDER by LTC and by reference
#
# For each: a picture of both and of their difference in OUT, and a line with the mean relative error
# and FLIP of the LTC picture. Environment, with defaults:
#   OPENLTC=build/release/bin/openltc   OUT=out/scenes   SIZE=480x360   SAMPLES=64   REFERENCE_SAMPLES=512
set -euo pipefail
tool="${OPENLTC:-build/release/bin/openltc}"
out="${OUT:-out/scenes}"
size="${SIZE:-480x360}"
folder="${1:?usage: tools/render_scenes.sh FOLDER}"
mkdir -p "$out"

printf '%-28s %14s %10s\n' "scene, $size" "relative error" "FLIP"
find "$folder" -name '*.glb' -o -name '*.gltf' | sort | while read -r scene; do
  name="$(basename "${scene%.*}")"
  "$tool" render "$scene" --size "$size" --samples "${SAMPLES:-64}" --shadow-samples "${SAMPLES:-64}" \
    -o "$out/$name.exr" -o "$out/$name.png" --quiet </dev/null
  "$tool" render "$scene" --size "$size" --samples "${REFERENCE_SAMPLES:-512}" \
    --integrator reference -o "$out/${name}_reference.exr" -o "$out/${name}_reference.png" --quiet </dev/null
  "$tool" compare "$out/$name.exr" "$out/${name}_reference.exr" --json --metric flip --exposure auto \
    --diff "$out/${name}_flip.png" </dev/null |
    /usr/bin/python3 -c 'import json, sys
r = json.load(sys.stdin)
print("%-28s %12.2f %% %10.4f" % (sys.argv[1], 100 * r["mean_relative_error"], r["flip"]["mean"]))' "$name"
done
