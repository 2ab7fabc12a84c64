#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
#   tools/test.sh PRESET...   run the presets' tests; the last line is 'N passed, N failed, N skipped'
#
# The counts are of test cases, out of ctest's own reports (tools/count_tests.py), and so is the exit
# code. What was skipped, because a tool or the material beside the repository is missing, is named
# before.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
reports=()
code=0
for preset in "${@:-release}"; do
  report="$PWD/build/$preset/test_report.xml"
  rm -f "$report"
  # All of the output: what is cut off would be skipped unseen.
  ctest --preset "$preset" --output-on-failure -j "${JOBS:-2}" --test-output-size-passed 100000000 \
    --output-junit "$report" || code=$?
  reports+=("$report")
done
# No report, or one without a single test, is a failure of its own.
/usr/bin/python3 -B tools/count_tests.py "${reports[@]}" || [[ $code -ne 0 ]] || code=1
exit $code
