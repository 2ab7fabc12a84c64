#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# What the Python module is compiled and tested with, in a virtual environment in the build folder.
# Prints CMake's options: the module ON with that Python, or OFF where something is missing, of which it
# leaves the reason in FOLDER.missing for the tests to name.
#
#   tools/python/prepare.sh FOLDER [PYTHON]
set -uo pipefail
cd "$(dirname "$0")/../.."
folder=$1 python=${2:-/usr/bin/python3}
mkdir -p "$(dirname "$folder")"
wanted=python/requirements/test.txt cluster=python/requirements/cluster.txt

off() {
  printf '%s\n' "$1" > "$folder.missing"
  echo "-DOPENLTC_PYTHON_MODULE=OFF"
  exit 0
}

if ! cat "$wanted" "$cluster" 2> /dev/null | cmp -s - "$folder/installed.txt"; then
  "$python" -c 'import sys; sys.exit(sys.version_info < (3, 10))' 2> /dev/null || off "Python 3.10 or later"
  "$python" -c 'import os, sysconfig, sys; sys.exit(not os.path.exists(sysconfig.get_path("include") + "/Python.h"))' ||
    off "the headers of Python (Debian: python3-dev)"
  rm -rf "$folder"
  "$python" -m venv "$folder" > "$folder.log" 2>&1 || off "Python's module venv (Debian: python3-venv)"
  "$folder/bin/pip" install --quiet --disable-pip-version-check --require-hashes -r "$wanted" >> "$folder.log" 2>&1 ||
    off "nanobind and NumPy, which pip could not fetch ($folder.log)"
  # Without it the tests of openltc.cluster are skipped.
  "$folder/bin/pip" install --quiet --disable-pip-version-check --require-hashes -r "$cluster" >> "$folder.log" 2>&1 || true
  cat "$wanted" "$cluster" > "$folder/installed.txt"
fi
rm -f "$folder.missing"
echo "-DOPENLTC_PYTHON_MODULE=ON -DPython_EXECUTABLE=$PWD/$folder/bin/python"
