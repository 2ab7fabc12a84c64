#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# Renders the demo scene by LTC and by reference, compares them, and says where the files are.
#
#   tools/demo.sh
#
# Environment, with defaults:
#   OPENLTC=build/release/bin/openltc   the tool
#   OUT=out                             folder of the results
#   SCENE=scenes/demo.glb
#   SIZE=1280x720                       the picture
#   SAMPLES=16                          its camera samples per pixel
#   SHADOW_SAMPLES=32                   per pixel and light
#   COMPARE_SIZE=320x180                both sides of each comparison
#   COMPARE_SAMPLES=64                  camera samples of its LTC side
#   COMPARE_SHADOW_SAMPLES=64           per pixel and light
#   REFERENCE_SAMPLES=256               of its reference with shadows
#   UNSHADOWED_SAMPLES=1024             and without
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tool="${OPENLTC:-build/release/bin/openltc}"
out="${OUT:-out}"
scene="${SCENE:-scenes/demo.glb}"
size="${SIZE:-1280x720}"
samples="${SAMPLES:-16}"
shadow_samples="${SHADOW_SAMPLES:-32}"
compare_size="${COMPARE_SIZE:-320x180}"
compare_samples="${COMPARE_SAMPLES:-64}"
compare_shadow_samples="${COMPARE_SHADOW_SAMPLES:-64}"
reference_samples="${REFERENCE_SAMPLES:-256}"
unshadowed_samples="${UNSHADOWED_SAMPLES:-1024}"

if [[ ! -x "$tool" ]]; then
  echo "demo: $tool is not there; run 'make build'" >&2
  exit 1
fi
mkdir -p "$out"

# Runs a render, its number and what it is on stderr before, its time behind, and keeps the time, of
# the clock, in `seconds`.
step=0
render() { # what arguments...
  local start end
  step="$((step + 1))"
  printf '[%d/5] %-62s' "$step" "$1" >&2
  start="$(date +%s%N)"
  "$tool" render "$scene" --quiet "${@:2}"
  end="$(date +%s%N)"
  seconds="$(awk -v ns="$((end - start))" 'BEGIN { printf "%.1f", ns / 1e9 }')"
  printf '%8s s\n' "$seconds" >&2
}

# The line of the summary that a comparison's JSON amounts to.
summary() { # json label seconds_ltc seconds_reference
  /usr/bin/python3 -c 'import json, sys
result, label, ltc, reference = json.loads(sys.argv[1]), *sys.argv[2:]
print("%-20s %14.2f %% %10.4f %10s s %10s s" % (label, 100 * result["mean_relative_error"],
      result["flip"]["mean"], ltc, reference))' "$@"
}

# Where the error is largest, from a comparison's JSON: the surfaces that have most of it.
largest() { # json
  /usr/bin/python3 -c 'import json, sys
for e in json.loads(sys.argv[1])["by_surface"][:4]:
    print("  %-38s %5.1f %% of the error; mean %.2f %%, largest %.0f %% at pixel (%d, %d)" % (
        e["surface"], 100 * e["share"], 100 * e["mean_relative_error"],
        100 * e["max_relative_error"], *e["max_relative_error_at"]))' "$1"
}

# Compares two pictures and keeps a line of the summary; the whole in `json`.
compare() { # label a b seconds_a seconds_b difference_picture
  json="$("$tool" compare "$2" "$3" --json --diff "$6" --scene "$scene")"
  rows+=("$(summary "$json" "$1" "$4" "$5")")
}

rows=()
render "the picture by LTC, $size, $samples samples per pixel" \
  -o "$out/demo.exr" -o "$out/demo.png" --size "$size" --samples "$samples" \
  --shadow-samples "$shadow_samples"
picture_seconds="$seconds"

render "LTC with shadows, $compare_size, $compare_samples samples" \
  -o "$out/demo_small.exr" --size "$compare_size" --samples "$compare_samples" \
  --shadow-samples "$compare_shadow_samples"
ltc_seconds="$seconds"
render "its reference, $reference_samples samples" \
  -o "$out/demo_reference.exr" -o "$out/demo_reference.png" --size "$compare_size" \
  --integrator reference --samples "$reference_samples"
compare "with shadows" "$out/demo_small.exr" "$out/demo_reference.exr" "$ltc_seconds" "$seconds" \
  "$out/demo_difference.png"

# Where the closed form has no noise.
render "LTC without shadows, $compare_samples samples" \
  -o "$out/demo_unshadowed.exr" -o "$out/demo_unshadowed.png" --size "$compare_size" \
  --samples "$compare_samples" --shadow-samples 0
ltc_seconds="$seconds"
render "its reference, $unshadowed_samples samples" \
  -o "$out/demo_unshadowed_reference.exr" -o "$out/demo_unshadowed_reference.png" \
  --size "$compare_size" --integrator reference --samples "$unshadowed_samples" --shadow-samples 0
compare "without shadows" "$out/demo_unshadowed.exr" "$out/demo_unshadowed_reference.exr" \
  "$ltc_seconds" "$seconds" "$out/demo_unshadowed_difference.png"

echo
printf '%-20s %16s %10s %12s %12s\n' "$compare_size" "relative error" "FLIP" "LTC" "reference"
printf '%s\n' "${rows[@]}"
echo
echo "where the closed form is off, without shadows: what two lobes and the ratio leave of GGX,"
echo "whose tails are longer than those of clamped cosines, where it is not taken itself"
largest "$json"
echo
echo "the picture, $size in $picture_seconds s:"
echo "  $out/demo.png  $out/demo.exr"
echo "ground truth:"
echo "  $out/demo_reference.png  $out/demo_unshadowed_reference.png"
echo "differences:"
echo "  $out/demo_difference.png  $out/demo_unshadowed_difference.png"
echo
echo "what to try next:"
echo "  $tool render scenes/lights.glb -o $out/lights.png   # every shape of light"
echo "  $tool inspect $scene   # its lights in nits and lumens, its size, its cameras"
echo "  $tool plot polygon -o $out/polygon.svg   # the method in one figure"
