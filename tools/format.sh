#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
#   tools/format.sh [FILE...]           format the sources in place, all or these
#   tools/format.sh --check [FILE...]   say which are not formatted, and where; exit code 1 if any
#
# C and C++ by .clang-format. What is included as text and what shaders read (.inc .glsl .comp .frag) by the
# same but for two things: the order of includes has a meaning there, and comments, in which formulas
# and tables stand, are not wrapped. CLANG_FORMAT=clang-format-14 names the program; other versions
# format otherwise. Exit code 77 when it is not there. shaders/ is left as the tool lays it out.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
program="${CLANG_FORMAT:-clang-format-14}"
check=0
if [[ "${1:-}" == --check ]]; then
  check=1
  shift
fi
if ! command -v "$program" >/dev/null; then
  echo "format: $program is not there; install the package clang-format-14" >&2
  exit 77
fi
if [[ $# -gt 0 ]]; then
  files=("$@")
else
  cd "$root"
  # New files too, if git does not ignore them.
  mapfile -t files < <(git ls-files --cached --others --exclude-standard -- \
    '*.h' '*.c' '*.cpp' '*.inc' '*.glsl' '*.comp' '*.frag' ':!shaders/' | sort -u |
    while read -r file; do [[ ! -e "$file" ]] || echo "$file"; done)
fi

cpp=() text=()
for file in "${files[@]}"; do
  case "$file" in
    *.h | *.c | *.cpp) cpp+=("$file") ;;
    *) text+=("$file") ;;
  esac
done

text_style="$(mktemp)"
trap 'rm -f "$text_style"' EXIT
{
  cat "$root/.clang-format"
  echo "SortIncludes: Never"
  echo "ReflowComments: false"
} >"$text_style"

run() { # style files...
  [[ $# -gt 1 ]] || return 0
  if [[ $check == 1 ]]; then
    "$program" "--style=file:$1" --dry-run -Werror "${@:2}"
  else
    "$program" "--style=file:$1" -i "${@:2}"
  fi
}
code=0
run "$root/.clang-format" "${cpp[@]}" || code=1
run "$text_style" "${text[@]}" || code=1
exit $code
