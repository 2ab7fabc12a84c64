#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
#   tools/lights_demo.sh           render every shape of light by LTC and by reference, and compare
#   tools/lights_demo.sh --docs    the same, and put the pictures of docs/lights.md into docs/images
#
# Renders scenes/lights.glb and the small scenes of tools/make_light_shapes.py. Pictures lie in OUT; the
# table says how far each scene is from its reference, with shadows and without. Environment, with
# defaults:
#   OPENLTC=build/release/bin/openltc   OUT=out/lights
#   SIZE=1280x720     SAMPLES=32        SHADOW_SAMPLES=64    the large picture
#   COMPARE_SIZE=480x270                                     large pictures that are compared
#   SHAPE_SIZE=300x200                                       small ones
#   SHAPES="lights disk sphere"                              these only; lights is the large scene
#   COMPARE_SAMPLES=64   REFERENCE_SAMPLES=512   UNSHADOWED_SAMPLES=1024
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tool="${OPENLTC:-build/release/bin/openltc}"
out="${OUT:-out/lights}"
compare_size="${COMPARE_SIZE:-480x270}"
shape_size="${SHAPE_SIZE:-300x200}"
compare_samples="${COMPARE_SAMPLES:-64}"
reference_samples="${REFERENCE_SAMPLES:-512}"
unshadowed_samples="${UNSHADOWED_SAMPLES:-1024}"

if [[ ! -x "$tool" ]]; then
  echo "lights: $tool is not there; run 'make build'" >&2
  exit 1
fi
mkdir -p "$out/shapes"

# Renders a scene both ways, with shadows and without, and prints a line of the table.
compare() { # scene name size exposure
  local json=() shadows
  for shadows in "$compare_samples" 0; do
    local truth_samples="$reference_samples" suffix=""
    [[ "$shadows" == 0 ]] && truth_samples="$unshadowed_samples" suffix="_unshadowed"
    local picture="$out/$2$suffix"
    "$tool" render "$1" --size "$3" --samples "$compare_samples" --shadow-samples "$shadows" --quiet \
      --exposure "$4" -o "$picture.exr" -o "$picture.png"
    "$tool" render "$1" --size "$3" --samples "$truth_samples" --shadow-samples "$shadows" --quiet \
      --integrator reference --exposure "$4" -o "${picture}_reference.exr" -o "${picture}_reference.png"
    json+=("$("$tool" compare "$picture.exr" "${picture}_reference.exr" --json \
      --diff "${picture}_difference.png")")
  done
  /usr/bin/python3 -c 'import json, sys
name, shadowed, unshadowed = sys.argv[1], *map(json.loads, sys.argv[2:])
print("| %s | %.2f %% | %.4f | %.2f %% | %.4f |" % (
    name.split("/")[-1].replace("_", " "), 100 * shadowed["mean_relative_error"],
    shadowed["flip"]["mean"], 100 * unshadowed["mean_relative_error"], unshadowed["flip"]["mean"]),
    flush=True)' "$2" "${json[@]}"
}

/usr/bin/python3 -B tools/make_light_shapes.py "$out/shapes"
all="$(cd "$out/shapes" && echo *.glb)"
shapes="${SHAPES:-lights ${all//.glb/}}"
if [[ "$shapes" == *lights* ]]; then
  echo "lights: the picture, ${SIZE:-1280x720}" >&2
  "$tool" render scenes/lights.glb --size "${SIZE:-1280x720}" --samples "${SAMPLES:-32}" \
    --shadow-samples "${SHADOW_SAMPLES:-64}" --exposure 10 --quiet -o "$out/lights.png"
fi

echo "lights: LTC against the reference" >&2
echo "| scene | error, with shadows | FLIP | error, without | FLIP |"
echo "|---|---|---|---|---|"
for name in $shapes; do
  if [[ "$name" == lights ]]; then
    compare scenes/lights.glb lights_small "$compare_size" 10
  else
    compare "$out/shapes/$name.glb" "shapes/$name" "$shape_size" 9.4
  fi
done

if [[ "${1:-}" == --docs ]]; then
  mkdir -p docs/images/lights
  for name in $shapes; do
    case "$name" in
      lights)
        cp "$out/lights.png" docs/images/lights.png
        cp "$out/lights_small_reference.png" docs/images/lights_reference.png ;;
      *_power_*) ;; # figures only
      *) cp "$out/shapes/$name.png" docs/images/lights/ ;;
    esac
  done
fi
echo "pictures, references and differences: $out" >&2
