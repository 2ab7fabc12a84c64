# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""What the closing line of `make test` counts, from reports that ctest itself writes."""

import os
import subprocess
import sys
import tempfile
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
k_counter = os.path.join(k_root, "tools", "count_tests.py")

# What doctest prints of a program with four cases, one of which skips all and one a part.
k_doctest = """[doctest] doctest version is "2.4.9"
===============================================================================
/src/a.cpp:10:
TEST CASE:  needs a file

/src/a.cpp:12: MESSAGE: skipped: the file is not there

===============================================================================
/src/a.cpp:20:
TEST CASE:  says a figure

/src/a.cpp:21: MESSAGE: nothing was skipped, 3.5

===============================================================================
/src/a.cpp:30:
TEST CASE:  two tools

/src/a.cpp:31: MESSAGE: skipped: one not found
/src/a.cpp:32: MESSAGE: skipped: another not found

===============================================================================
[doctest] test cases:  4 |  4 passed | 0 failed | 0 skipped
[doctest] assertions: 12 | 12 passed | 0 failed |
[doctest] Status: SUCCESS!
"""
k_unittest = "....s\n------\nRan 5 tests in 0.1s\n\nOK (skipped=1)\n"


class Count(unittest.TestCase):
    def count(self, *programs):
        """The counter's exit code and lines, of programs as (exit code, what they print)."""
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "CTestTestfile.cmake"), "w", encoding="utf-8") as stream:
                for i, (code, text) in enumerate(programs):
                    output = os.path.join(folder, "out%d" % i)
                    with open(output, "w", encoding="utf-8") as out:
                        out.write(text)
                    stream.write('add_test(p%d sh -c "cat %s; exit %d")\n' % (i, output, code))
                    stream.write("set_tests_properties(p%d PROPERTIES SKIP_RETURN_CODE 77)\n" % i)
            subprocess.run(["ctest", "--output-junit", "report.xml", "--test-output-size-passed",
                            "1000000"], cwd=folder, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL, check=False)
            result = subprocess.run([sys.executable, "-B", k_counter,
                                     os.path.join(folder, "report.xml")],
                                    stdout=subprocess.PIPE, text=True, check=False)
            return result.returncode, result.stdout.splitlines()

    def test_cases_that_skip_are_counted_and_named(self):
        code, lines = self.count((0, k_doctest))
        self.assertEqual(lines[-1], "2 passed, 0 failed, 2 skipped")
        self.assertEqual(code, 0)
        self.assertEqual(lines[:-1], ["skipped: p0: needs a file: skipped: the file is not there",
                                      "skipped: p0: two tools: skipped: one not found"])

    def test_programs_add_up(self):
        code, lines = self.count((0, k_doctest), (0, k_unittest), (0, "no cases\n"), (77, "no tool\n"))
        self.assertEqual(lines[-1], "7 passed, 0 failed, 4 skipped")
        self.assertEqual(code, 0)

    def test_failures(self):
        bad = k_doctest.replace("4 passed | 0 failed", "3 passed | 1 failed")
        code, lines = self.count((1, bad), (0, "fine\n"))
        self.assertEqual(lines[-1], "2 passed, 1 failed, 2 skipped")
        self.assertEqual(code, 1)

    def test_a_crash_is_a_failure_with_and_without_a_summary(self):
        for text in ("", k_doctest, k_unittest):
            code, lines = self.count((1, text), (0, "fine\n"))
            self.assertIn(", 1 failed, ", lines[-1])
            self.assertEqual(code, 1)

    def test_no_test_at_all_is_a_failure(self):
        code, lines = self.count()
        self.assertIn(", 1 failed, ", lines[-1])
        self.assertEqual(code, 1)


if __name__ == "__main__":
    unittest.main()
