#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
#   tools/fuzz.sh BUILD_DIR   run every libFuzzer program, fuzz_*, for FUZZ_SECONDS (60) each
#
# New inputs gather in BUILD_DIR/corpus/NAME; a crash is left in BUILD_DIR/crashes and fails.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build="${1:-build/fuzz}"

found=0
for program in "$build"/bin/fuzz_*; do
  [[ -x "$program" ]] || continue
  found=1
  name="${program##*/}"
  corpus="$build/corpus/$name"
  mkdir -p "$corpus" "$build/crashes"
  seeds=()
  for folder in "tests/fuzz/seeds/$name" ../shared/malformed; do
    if [[ -d "$folder" ]]; then seeds+=("$folder"); fi
  done
  echo "== $name, ${FUZZ_SECONDS:-60} s"
  "$program" "$corpus" "${seeds[@]}" -max_total_time="${FUZZ_SECONDS:-60}" -timeout=10 \
    -rss_limit_mb=2048 -max_len=65536 -artifact_prefix="$build/crashes/$name-" -print_final_stats=1
done
if [[ $found -eq 0 ]]; then
  echo "fuzz: no fuzz_* in $build/bin" >&2
  exit 1
fi
