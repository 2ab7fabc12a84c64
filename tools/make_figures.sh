#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
#   tools/make_figures.sh              make the figures of tools/figures.txt in docs/images/plot
#   tools/make_figures.sh --out DIR    make them in DIR instead
#   tools/make_figures.sh --check      make them elsewhere, compare with those of docs/images/plot
#   tools/make_figures.sh error        this one only; any of these may name some figures
#
# Environment, with its default: OPENLTC=build/release/bin/openltc
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tool="${OPENLTC:-build/release/bin/openltc}"
out=docs/images/plot
check=0
names=()

usage() {
  sed -n 's/^#   //p' "$0" >&2
  exit 2
}

while [[ $# -gt 0 ]]; do
  case "$1" in
    --check) check=1 ;;
    --out)
      [[ $# -gt 1 ]] || usage
      out="$2"
      shift
      ;;
    -*)
      echo "figures: unknown option $1" >&2
      usage
      ;;
    *) names+=("$1") ;;
  esac
  shift
done

if [[ ! -x "$tool" ]]; then
  echo "figures: $tool is not there; run 'make build'" >&2
  exit 1
fi
if [[ "$check" == 1 ]]; then
  out="$(mktemp -d)"
  trap 'rm -rf "$out"' EXIT
fi
mkdir -p "$out"
made=0
while read -r name arguments; do
  [[ -z "$name" || "$name" == \#* ]] && continue
  [[ ${#names[@]} -gt 0 && " ${names[*]} " != *" $name "* ]] && continue
  # Word splitting is wanted: the list has arguments without spaces in them.
  # shellcheck disable=SC2086
  "$tool" $arguments --quiet -o "$out/$name.svg"
  [[ "$check" == 1 ]] || echo "$out/$name.svg"
  made=$((made + 1))
done < tools/figures.txt
if [[ "$made" == 0 ]]; then
  echo "figures: tools/figures.txt has none of: ${names[*]}" >&2
  exit 1
fi
if [[ "$check" == 1 ]]; then tools/compare_figures.py docs/images/plot "$out"; fi
