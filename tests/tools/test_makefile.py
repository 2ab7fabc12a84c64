# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Which compiler the Makefile takes: Clang where one finds the standard library, or what is asked."""

import os
import shutil
import stat
import subprocess
import tempfile
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
k_clangs = ("clang++-14", "clang++", "clang++-19", "clang++-18")


def compiler_of_build(clangs, *arguments):
    """What `make build` would configure with, on a system with these Clangs: name, whether it works."""
    with tempfile.TemporaryDirectory() as folder:
        for tool in ("make", "sh", "bash", "git", "nproc", "sed"):
            os.symlink(shutil.which(tool), os.path.join(folder, tool))
        for name, works in clangs.items():
            path = os.path.join(folder, name)
            with open(path, "w", encoding="utf-8") as stream:
                stream.write("#!/bin/sh\nexit %d\n" % (not works))
            os.chmod(path, stat.S_IRWXU)
        environment = {k: v for k, v in os.environ.items()
                       if k not in ("CXX", "MAKEFLAGS", "MFLAGS", "MAKELEVEL", "MAKEOVERRIDES")}
        environment["PATH"] = folder
        result = subprocess.run(["make", "-n", "build", *arguments], cwd=k_root, env=environment,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        if result.returncode != 0 or result.stderr:
            raise AssertionError(result.stderr)
        for line in result.stdout.splitlines():
            if "-DCMAKE_CXX_COMPILER=" in line:
                return os.path.basename(line.split("-DCMAKE_CXX_COMPILER=")[1].strip())
    raise AssertionError(result.stdout)


class Compiler(unittest.TestCase):
    def test_any_single_clang_is_found(self):
        for name in k_clangs:
            self.assertEqual(compiler_of_build({name: True}), name)

    def test_first_of_several(self):
        self.assertEqual(compiler_of_build({name: True for name in k_clangs}), k_clangs[0])

    def test_one_without_the_standard_library_does_not_count(self):
        self.assertEqual(compiler_of_build({"clang++-14": False, "clang++-19": True}), "clang++-19")
        self.assertEqual(compiler_of_build({"clang++-14": False}), "g++")

    def test_gcc_without_clang(self):
        self.assertEqual(compiler_of_build({}), "g++")

    def test_choice_of_the_user(self):
        self.assertEqual(compiler_of_build({"clang++-14": True}, "CXX=g++"), "g++")


if __name__ == "__main__":
    unittest.main()
