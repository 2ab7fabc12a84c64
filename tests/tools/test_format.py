# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""All sources are as `make format` leaves them, and the check notices one that is not."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
k_script = os.path.join(k_root, "tools", "format.sh")
k_exit_skipped = 77


def run(*arguments):
    return subprocess.run([k_script, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True)


class Format(unittest.TestCase):
    def test_all_sources(self):
        result = run("--check")
        self.assertEqual(result.returncode, 0, "run `make format`:\n" + result.stdout[:4000])

    def check(self, name, before, after):
        """`before` is refused, formatting makes `after` of it, and that is left alone."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, name)
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(before)
            result = run("--check", path)
            self.assertEqual(result.returncode, 1, result.stdout)
            self.assertIn(name, result.stdout)
            self.assertEqual(run(path).returncode, 0)
            with open(path, encoding="utf-8") as stream:
                self.assertEqual(stream.read(), after)
            self.assertEqual(run("--check", path).returncode, 0)

    def test_cpp(self):
        for name in ("a.cpp", "a.c", "a.h"):
            self.check(name, "int  f( int a ){return a;}\n", "int f(int a) { return a; }\n")

    def test_shading_source(self):
        for name in ("a.glsl", "a.inc", "a.comp", "a.frag"):
            self.check(name, "FN Real f( Real a ){return a+a;}\n",
                       "FN Real f(Real a) { return a + a; }\n")

    def test_the_order_of_includes_and_long_comments_stay(self):
        includes = '#include "z.glsl"\n#include "a.glsl"\n'
        comment = "// " + "a = b  " * 20 + "c\n"
        self.check("a.inc", includes + comment + "Real  a;\n", includes + comment + "Real a;\n")


if __name__ == "__main__":
    if shutil.which(os.environ.get("CLANG_FORMAT", "clang-format-14")) is None:
        print("skipped: clang-format-14 is not there")
        sys.exit(k_exit_skipped)
    unittest.main()
