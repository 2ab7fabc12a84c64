#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Says what was skipped and counts what passed, by ctest's reports.

    tools/count_tests.py REPORT.xml...

A program of doctest or of Python's unittest counts for its test cases, any other for one. A case that
says "skipped", since something is missing, counts as skipped, although to doctest it has passed. The
exit code is 0 if something passed and nothing failed."""

import re
import sys
import xml.etree.ElementTree as tree

k_case = re.compile(r"^TEST CASE:\s+(.*)$")
k_skip = re.compile(r"MESSAGE: (skipped.*)$")
k_doctest = re.compile(r"^\[doctest\] test cases:\s*(\d+)\s*\|\s*(\d+) passed\s*\|\s*(\d+) failed", re.M)
k_unittest = re.compile(r"^Ran (\d+) tests? in ", re.M)
k_unittest_skips = re.compile(r"^(?:OK|FAILED) \(.*skipped=(\d+)", re.M)


def skipped_cases(output):
    """Names of doctest's cases that say they skip, each with what it says."""
    skips, name = {}, ""
    for line in output.splitlines():
        case, skip = k_case.match(line), k_skip.search(line)
        if case:
            name = case.group(1).strip()
        elif skip:
            skips.setdefault(name, skip.group(1).strip())
    return skips


def count_program(name, failed, output):
    """(passed, failed, skipped) of a program that ran, and lines that say what it skipped."""
    doctest = k_doctest.search(output)
    if doctest:
        skips = skipped_cases(output)
        bad = int(doctest.group(3))
        # A crash behind the summary, or a leak, is a failure as well.
        return ((int(doctest.group(2)) - len(skips), max(bad, int(failed)), len(skips)),
                ["%s: %s: %s" % (name, case, what) for case, what in skips.items()])
    cases, left_out = k_unittest.search(output), k_unittest_skips.search(output)
    if cases and not failed:
        skips = int(left_out.group(1)) if left_out else 0
        return ((int(cases.group(1)) - skips, 0, skips),
                ["%s: %d of its cases" % (name, skips)] if skips else [])
    return (int(not failed), int(failed), 0), []


def count_report(path):
    passed, failed, skipped, lines = 0, 0, 0, []
    for case in tree.parse(path).getroot().iter("testcase"):
        name, status = case.get("name"), case.get("status")
        note = case.find("skipped")
        reason = note.get("message", "") if note is not None else ""
        if status == "disabled" or (status != "run" and reason.startswith("SKIP_")):
            skipped += 1
            lines.append(name)
            continue
        # Anything else that did not run to a good end: it failed, timed out or is missing.
        (good, bad, out), more = count_program(name, status != "run", case.findtext("system-out") or "")
        passed, failed, skipped = passed + good, failed + bad, skipped + out
        lines += more
    return passed, failed, skipped, lines


def main(paths):
    total = [0, 0, 0]
    seen = {}
    for path in paths:
        try:
            *counts, lines = count_report(path)
        except (OSError, tree.ParseError) as error:
            print("ctest left no report: %s" % error)
            counts, lines = (0, 1, 0), []
        if counts[0] + counts[1] == 0:
            print("%s: not a single test ran" % path)
            counts = (0, 1, counts[2])
        total = [a + b for a, b in zip(total, counts)]
        seen.update(dict.fromkeys(lines))
    for line in seen:
        print("skipped: %s" % line)
    print("%d passed, %d failed, %d skipped" % tuple(total))
    return 0 if total[0] > 0 and total[1] == 0 else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
