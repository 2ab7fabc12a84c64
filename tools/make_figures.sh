#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
#   tools/make_figures.sh           make every figure of docs/images/plot
#   tools/make_figures.sh --check   make them elsewhere and compare (tools/compare_figures.py)
#   tools/make_figures.sh --list    print each file and its command
#
# Environment, with defaults: OPENLTC=build/release/bin/openltc   FIGURES=docs/images/plot
set -euo pipefail
openltc="$(realpath -m "${OPENLTC:-$(dirname "${BASH_SOURCE[0]}")/../build/release/bin/openltc}")"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
figures="${FIGURES:-docs/images/plot}"

# FILE  WHAT OPTIONS...: what follows "openltc plot". Every checked-in figure stands here.
list() {
  cat <<'END'
lobes.svg        lobes
lobes_sweep.svg  lobes --matrix 0.7,0,0.4,0.2 --sweep b=-1.05:1.05:8
polygon.svg      polygon
literal.svg      literal
END
}

make_all() { # folder
  local file command
  while read -r file command; do
    # The words of a command hold no spaces.
    "$openltc" plot $command --quiet -o "$1/$file" </dev/null
    [[ -n "${2:-}" ]] || echo "$1/$file: openltc plot $command"
  done < <(list)
}

case "${1:-}" in
  --list) list; exit 0 ;;
  -h | --help) sed -n '5,9s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
  "" | --check) ;;
  *) echo "make_figures: unknown option '$1'; there are --check, --list and --help" >&2; exit 2 ;;
esac
if [[ ! -x "$openltc" ]]; then
  echo "make_figures: $openltc is not there; run make build, or set OPENLTC to the tool" >&2
  exit 1
fi
if [[ "${1:-}" == --check ]]; then
  fresh="$(mktemp -d)"
  trap 'rm -rf "$fresh"' EXIT
  make_all "$fresh" quiet
  if ! python3 tools/compare_figures.py "$figures" "$fresh"; then
    echo "make_figures: run make figures, look at the pictures, and commit them" >&2
    exit 1
  fi
  echo "make_figures: $(list | wc -l) figures are as they are checked in"
else
  mkdir -p "$figures"
  make_all "$figures"
fi
