#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
#   tools/render_scenes.sh FOLDER...    render every glTF file below the folders by LTC and by reference
#
# For each: a picture of both and of their difference in OUT, and a line with the mean relative error
# and FLIP of the LTC picture. inspect and convert must take every file too. A file that is named in
# EXPECTED_FAILURES must end with 1 and a message that holds the text given there. All files are tried;
# the exit status is 1 when one of them ended otherwise. Environment, with defaults:
#   OPENLTC=build/release/bin/openltc   OUT=out/scenes   SIZE=480x360   SAMPLES=64   REFERENCE_SAMPLES=512
#   EXPECTED_FAILURES=tools/render_scenes_fail.txt
set -euo pipefail
[ $# -gt 0 ] || { echo "usage: tools/render_scenes.sh FOLDER..." >&2; exit 2; }
tool="${OPENLTC:-build/release/bin/openltc}"
out="${OUT:-out/scenes}"
size="${SIZE:-480x360}"
expected="${EXPECTED_FAILURES:-$(dirname "$0")/render_scenes_fail.txt}"
mkdir -p "$out"
failures=0
last="$out/last_message.txt"

# expected_text FILE: what its message must hold; empty when the file must render.
expected_text() {
  local pattern text
  [ -f "$expected" ] || return 0
  while read -r pattern text; do
    case "$pattern" in '' | '#'*) continue ;; esac
    # shellcheck disable=SC2254  # the pattern is one on purpose
    case "$1" in */$pattern) printf '%s' "$text" ;; esac
  done <"$expected"
}

fail() {
  printf '%-44s FAILED: %s\n' "$1" "$2"
  failures=$((failures + 1))
}

# attempt COMMAND...: runs the tool; its message is kept.
attempt() {
  status=0
  "$tool" "$@" </dev/null >"$out/last_output.txt" 2>"$last" || status=$?
}

message() { grep -v '^warning\|^note' "$last" | tail -n 1 | cut -c 1-200; }

compare_integrators() {
  local scene="$1" name="$2" picture="$out/$2"
  attempt render "$scene" --size "$size" --samples "${SAMPLES:-64}" --shadow-samples "${SAMPLES:-64}" \
    -o "$picture.exr" -o "$picture.png" --quiet
  [ "$status" = 0 ] || { fail "$name" "render ended with $status: $(message)"; return; }
  attempt render "$scene" --size "$size" --samples "${REFERENCE_SAMPLES:-512}" --integrator reference \
    -o "${picture}_reference.exr" -o "${picture}_reference.png" --quiet
  [ "$status" = 0 ] || { fail "$name" "the reference ended with $status: $(message)"; return; }
  attempt compare "$picture.exr" "${picture}_reference.exr" --json --metric flip --exposure auto \
    --diff "${picture}_flip.png"
  [ "$status" = 0 ] || { fail "$name" "compare ended with $status: $(message)"; return; }
  local numbers
  numbers="$(/usr/bin/python3 -c 'import json, sys
r = json.load(sys.stdin)
print("%12.2f %% %10.4f" % (100 * r["mean_relative_error"], r["flip"]["mean"]))' <"$out/last_output.txt")"
  for command in inspect convert; do
    if [ "$command" = inspect ]; then attempt inspect "$scene"; else attempt convert "$scene" "$picture.glb"; fi
    [ "$status" = 0 ] || { fail "$name" "$command ended with $status: $(message)"; return; }
  done
  printf '%-44s %s\n' "$name" "$numbers"
}

refuse() {
  local scene="$1" name="$2" text="$3"
  for command in render inspect convert; do
    case "$command" in
      render) attempt render "$scene" --size 16x9 --samples 1 -o "$out/$name.png" --quiet ;;
      inspect) attempt inspect "$scene" ;;
      convert) attempt convert "$scene" "$out/$name.glb" ;;
    esac
    if [ "$status" != 1 ] || ! grep -qF -- "$text" "$last"; then
      fail "$name" "$command ended with $status, not with 1 and \"$text\": $(message)"
      return
    fi
  done
  printf '%-44s %s\n' "$name" "refused as it must: $text"
}

printf '%-44s %14s %10s\n' "scene, $size" "relative error" "FLIP"
for folder in "$@"; do
  while IFS= read -r -d '' scene; do
    name="${scene#"$folder"/}"
    name="${name%.*}_${name##*.}" # one.glb and one.gltf may lie side by side
    name="${name//\//_}"
    text="$(expected_text "$scene")"
    if [ -n "$text" ]; then refuse "$scene" "$name" "$text"; else compare_integrators "$scene" "$name"; fi
  done < <(find "$folder" \( -name '*.glb' -o -name '*.gltf' \) -print0 | sort -z)
done
[ "$failures" = 0 ] || { echo "$failures failed"; exit 1; }
