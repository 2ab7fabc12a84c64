#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
#   tools/test.sh PRESET   run the preset's tests; the last line is 'N passed, N failed'
#
# The counts come from ctest's own report, and so does the exit code. Skipped tests (a tool or the
# material beside the repository is missing) are named before and counted as neither.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset="${1:-release}"
report="$PWD/build/$preset/test_report.xml"

rm -f "$report"
ctest --preset "$preset" --output-on-failure -j "${JOBS:-2}" --output-junit "$report"
code=$?
# No report, or one without a single test, is a failure of its own.
/usr/bin/python3 - "$report" <<'PYTHON' || [[ $code -ne 0 ]] || code=1
import sys
import xml.etree.ElementTree as tree
passed, failed = 0, 0
try:
    for case in tree.parse(sys.argv[1]).getroot().iter("testcase"):
        note = case.find("skipped")
        reason = note.get("message", "") if note is not None else ""
        if case.get("status") == "run":
            passed += 1
        elif case.get("status") == "disabled" or reason.startswith("SKIP_"):
            print("skipped: %s" % case.get("name"))
        else:  # failed, timed out, or its program is missing
            failed += 1
except (OSError, tree.ParseError) as error:
    print("ctest left no report: %s" % error)
    failed = 1
print("%d passed, %d failed" % (passed, failed))
sys.exit(0 if passed > 0 and failed == 0 else 1)
PYTHON
exit $code
