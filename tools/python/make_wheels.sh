#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# Makes the wheels and the source distribution of the Python package: out/python.
#
#   tools/python/make_wheels.sh [PYTHON...]
#
# A wheel for the stable ABI, cp312-abi3, by the first Python from 3.12 on, and one for each older
# version that is named; without names those that are found. The compiler is $CXX. What the wheels
# need of the system is put inside by auditwheel; tools and their versions: python/requirements/build.txt.
set -euo pipefail
cd "$(dirname "$0")/../.."
out=out/python work=build/python
mkdir -p "$work" "$out"
rm -f "$out"/*.whl "$out"/*.tar.gz

version_of() { "$1" -c 'import sys; print("%d.%d" % sys.version_info[:2])' 2> /dev/null || true; }

if [ $# -eq 0 ]; then
  for version in 3.10 3.11 3.12 3.13 3.14; do
    for python in "$(command -v python$version || true)" "$HOME"/.pyenv/versions/$version.*/bin/python /usr/bin/python3; do
      [ -x "$python" ] && [ "$(version_of "$python")" = $version ] || continue
      # Needs its headers too.
      "$python" -c 'import os, sysconfig, sys; sys.exit(not os.path.exists(sysconfig.get_path("include") + "/Python.h"))' || continue
      set -- "$@" "$python"
      break
    done
  done
fi
[ $# -gt 0 ] || { echo "make_wheels: no Python from 3.10 on with its headers (Debian: python3-dev)" >&2; exit 1; }

stable=
for python in "$@"; do
  version=$(version_of "$python")
  [ "${version#3.}" -lt 12 ] || { [ -z "$stable" ] || continue; stable=$version; }
  venv=$work/venv-$version
  [ -x "$venv/bin/auditwheel" ] || {
    "$python" -m venv "$venv"
    "$venv/bin/pip" install --quiet --disable-pip-version-check --require-hashes -r python/requirements/build.txt
  }
  echo "== Python $version"
  # Another Python is found anew; what is compiled stays.
  rm -rf "$work/dist" build/wheel/CMakeCache.txt
  PATH=$PWD/$venv/bin:$PATH "$venv/bin/python" -m build --wheel --no-isolation --outdir "$work/dist" . > "$work/build-$version.log" 2>&1 ||
    { tail -n 40 "$work/build-$version.log" >&2; exit 1; }
  [ -e "$out"/*.tar.gz ] || "$venv/bin/python" -m build --sdist --no-isolation --outdir "$out" . > "$work/sdist.log" 2>&1
  PATH=$PWD/$venv/bin:$PATH "$venv/bin/auditwheel" repair --strip -w "$out" "$work"/dist/*.whl
done
ls -l "$out"
