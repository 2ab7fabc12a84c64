#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
#   tools/bench.sh BIN_DIR [ARGUMENT]...   run every benchmark program, bench_*, of the folder
#
# Arguments go to each program, e.g. --benchmark_filter=polygon.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder="${1:-build/release/bin}"
shift || true

found=0
for program in "$folder"/bench_*; do
  [[ -x "$program" ]] || continue
  found=1
  echo "== ${program##*/}"
  "$program" "$@"
done
if [[ $found -eq 0 ]]; then
  echo "bench: no bench_* in $folder; configure with OPENLTC_BENCH=ON and build" >&2
  exit 1
fi
