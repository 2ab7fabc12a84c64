#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# Compiles the public API for other systems, without warnings, and compares what they compute with what
# this one does.
#
#   tools/cross.sh
#
# Targets: Windows and Linux on x86-64, Linux and macOS on AArch64, by Zig (PyPI: ziglang) and, where it is
# installed, MinGW. Programs for Windows are run by Wine, those for AArch64 Linux by qemu-user, where
# these are installed (Debian: wine64, qemu-user-static, g++-mingw-w64-x86-64); others are compiled and
# linked only. Fails when something does not compile, or differs by more than TOLERANCE.
#
# Environment, with defaults:
#   CXX=g++   TOLERANCE=1e-3   OUT=out/cross
#
# On x86-64 numbers agree to 1e-6; compilers for AArch64 fuse multiply and add, which turns directions by
# an ulp and densities of narrow lobes by 3e-4.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
cxx="${CXX:-g++}"
tolerance="${TOLERANCE:-1e-3}"
out="${OUT:-out/cross}"
source=tests/api/portable_numbers.cpp
flags=(-std=c++17 -O2 -Wall -Wextra -Wconversion -Wshadow -pedantic -Werror -I .)
mkdir -p "$out"

"$cxx" "${flags[@]}" "$source" -o "$out/native"
"$out/native" >"$out/native.txt"
printf '%-28s %s\n' "native, $cxx" "$(wc -l <"$out/native.txt") lines of numbers"

zig=()
if command -v zig >/dev/null; then
  zig=(zig)
else
  if [[ ! -x "$out/venv/bin/python" ]]; then
    /usr/bin/python3 -m venv "$out/venv"
    "$out/venv/bin/pip" -q install ziglang==0.13.0
  fi
  zig=("$out/venv/bin/python" -m ziglang)
fi

failures=0
# compare NAME RUNNER...: runs the program NAME and compares its numbers.
compare() {
  local name="$1"
  shift
  if ! "$@" "$out/$name" 2>"$out/$name.log" | tr -d '\r' >"$out/$name.txt"; then
    printf '%-28s FAILED to run: %s\n' "$name" "$(head -n 1 "$out/$name.log")"
    failures=$((failures + 1))
  elif ! /usr/bin/python3 -B tools/compare_numbers.py "$out/native.txt" "$out/$name.txt" "$tolerance" |
    sed "s/^/$(printf '%-28s ' "$name")/"; then
    failures=$((failures + 1))
  fi
}

# build NAME COMPILER...: compiles NAME; false, and said, when that fails.
build() {
  local name="$1"
  shift
  if ! "$@" "${flags[@]}" "$source" -o "$out/$name" 2>"$out/$name.log"; then
    printf '%-28s FAILED to compile: %s\n' "$name" "$(grep -m 1 error "$out/$name.log" || head -n 1 "$out/$name.log")"
    failures=$((failures + 1))
    return 1
  fi
}

wine="$(command -v wine64 || command -v wine || true)"
qemu="$(command -v qemu-aarch64-static || command -v qemu-aarch64 || true)"
export WINEDEBUG=-all WINEPREFIX="$PWD/$out/wine"

for target in x86_64-linux-musl aarch64-linux-musl x86_64-windows-gnu aarch64-macos; do
  name="zig-$target"
  [[ "$target" == *windows* ]] && name="$name.exe"
  build "$name" "${zig[@]}" c++ -target "$target" || continue
  case "$target" in
    x86_64-linux-musl) compare "$name" env ;;
    aarch64-linux-musl) if [[ -n "$qemu" ]]; then compare "$name" "$qemu"; else printf '%-28s compiles; no qemu-user to run it\n' "$name"; fi ;;
    x86_64-windows-gnu) if [[ -n "$wine" ]]; then compare "$name" "$wine"; else printf '%-28s compiles; no Wine to run it\n' "$name"; fi ;;
    *) printf '%-28s compiles and links\n' "$name" ;;
  esac
done
if command -v x86_64-w64-mingw32-g++ >/dev/null; then
  name=mingw-x86_64.exe
  if build "$name" x86_64-w64-mingw32-g++ -static; then
    if [[ -n "$wine" ]]; then compare "$name" "$wine"; else printf '%-28s compiles; no Wine to run it\n' "$name"; fi
  fi
fi
if command -v aarch64-linux-gnu-g++ >/dev/null; then
  name=gcc-aarch64
  if build "$name" aarch64-linux-gnu-g++ -static; then
    if [[ -n "$qemu" ]]; then compare "$name" "$qemu"; else printf '%-28s compiles; no qemu-user to run it\n' "$name"; fi
  fi
fi
[[ $failures -eq 0 ]] || { echo "cross: $failures failed" >&2; exit 1; }
