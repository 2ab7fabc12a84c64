#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
#   tools/light_figures.sh [COUNT]   the table of errors of docs/lights.md, from COUNT lights a shape
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program="${OPENLTC_BIN:-build/release/bin}/bench_light_errors"
if [[ ! -x "$program" ]]; then
  echo "light_figures: no $program; run make build, or set OPENLTC_BIN to another folder" >&2
  exit 1
fi
exec "$program" "${1:-100000}"
