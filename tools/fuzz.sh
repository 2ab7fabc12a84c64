#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
#   tools/fuzz.sh BUILD_DIR   run every libFuzzer program, fuzz_NAME, for FUZZ_SECONDS (60) each
#
# fuzz_NAME_seeds, if there, writes the files to start from; tests/fuzz/NAME.dict helps mutation.
# New inputs gather in BUILD_DIR/corpus/NAME; a crash is left in BUILD_DIR/crashes and fails.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build="${1:-build/fuzz}"

found=0
for program in "$build"/bin/fuzz_*; do
  [[ -x "$program" && "$program" != *_seeds ]] || continue
  found=1
  name="${program##*/fuzz_}"
  corpus="$build/corpus/$name"
  mkdir -p "$corpus" "$build/crashes"
  if [[ -x "${program}_seeds" ]]; then "${program}_seeds" "$corpus"; fi
  options=(-max_total_time="${FUZZ_SECONDS:-60}" -timeout=10 -rss_limit_mb=4096 -max_len=65536
    -artifact_prefix="$build/crashes/$name-" -print_final_stats=1)
  if [[ -f "tests/fuzz/$name.dict" ]]; then options+=(-dict="tests/fuzz/$name.dict"); fi
  echo "== fuzz_$name, ${FUZZ_SECONDS:-60} s"
  "$program" "$corpus" "${options[@]}"
done
if [[ $found -eq 0 ]]; then
  echo "fuzz: no fuzz_* in $build/bin" >&2
  exit 1
fi
