# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Programs find the headers by each way that the README names, and the libraries by find_package:
tests/install has a project for each.

    test_install.py COMPILER BUILD FLAGS   BUILD has the libraries, which need these flags to be linked
"""

import os
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
k_projects = os.path.join(k_root, "tests", "install")
k_compiler, k_build, *k_flags = sys.argv[1:]
del sys.argv[1:]


def installed_files(folder):
    return {os.path.relpath(os.path.join(at, name), folder) for at, _, names in os.walk(folder) for name in names}


class Install(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.TemporaryDirectory()
        cls.folder = cls.work.name
        # Moved afterwards: nothing in it may hold the path that it was installed to. Without a space in its
        # name, at which older versions of pkg-config cut it in two.
        build, first = os.path.join(cls.folder, "headers"), os.path.join(cls.folder, "first")
        cls.prefix = os.path.join(cls.folder, "moved")
        run(["cmake", "-G", "Ninja", "-S", k_root, "-B", build, "-DOPENLTC_LIBRARY=OFF", "-DCMAKE_INSTALL_LIBDIR=lib",
             "-DCMAKE_CXX_COMPILER=" + k_compiler])
        with open(os.path.join(build, "CMakeCache.txt"), encoding="utf-8") as stream:
            cls.found = re.findall(r"^\w+_DIR:PATH=(?!%s).*" % re.escape(cls.folder), stream.read(), re.M)
        cls.targets = run(["ninja", "-C", build, "-n"])
        run(["cmake", "--install", build, "--prefix", first])
        os.rename(first, cls.prefix)

    @classmethod
    def tearDownClass(cls):
        cls.work.cleanup()

    def test_the_headers_alone_need_no_package_and_no_build(self):
        self.assertEqual(self.found, [])
        self.assertIn("no work to do", self.targets)

    def test_the_installed_headers_are_those_that_the_public_one_includes(self):
        include = os.path.join(self.prefix, "include")
        rule = run([k_compiler, "-std=c++17", "-I", include, "-MM", "-x", "c++",
                    os.path.join(include, "openltc/openltc.h")])
        needed = {os.path.relpath(path, include) for path in shlex.split(rule.replace("\\\n", " "))[1:]}
        # Preludes for other targets than float, which docs/api.md names.
        preludes = {"openltc/target/" + name for name in ("glsl.inc", "lanes.inc", "shade_f64.h")}
        self.assertEqual(installed_files(include), needed | preludes)

    def test_no_file_knows_where_it_was_installed(self):
        for name in installed_files(self.prefix):
            with open(os.path.join(self.prefix, name), "rb") as stream:
                data = stream.read()
            for path in (self.folder, k_root):
                self.assertNotIn(path.encode(), data, name)

    def test_find_package(self):
        self.build_and_run("find_package", "-DCMAKE_PREFIX_PATH=" + self.prefix)

    def test_a_component_that_is_not_installed_is_missed(self):
        result = subprocess.run(self.configure("library", "-DCMAKE_PREFIX_PATH=" + self.prefix,
                                               "-B", os.path.join(self.folder, "missed")),
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("without its component `library`", result.stdout)

    def test_add_subdirectory(self):
        self.build_and_run("add_subdirectory")

    def test_fetch_content(self):
        self.build_and_run("fetch_content", "-DFETCHCONTENT_SOURCE_DIR_OPENLTC=" + k_root)

    def test_pkg_config(self):
        environment = dict(os.environ, PKG_CONFIG_PATH=os.path.join(self.prefix, "share", "pkgconfig"))
        flags = run(["pkg-config", "--cflags", "--libs", "openltc"], environment)
        program = os.path.join(self.folder, "by_pkg_config")
        run([k_compiler, "-std=c++17"] + shlex.split(flags) +
            [os.path.join(k_projects, "consumer.cpp"), "-o", program])
        run([program])

    def test_the_tool_is_refused_without_the_libraries(self):
        result = subprocess.run(self.configure("../..", "-DOPENLTC_LIBRARY=OFF", "-DOPENLTC_TOOL=ON",
                                               "-B", os.path.join(self.folder, "refused")),
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("OPENLTC_LIBRARY=ON", result.stdout)

    def test_the_libraries_render(self):
        prefix = os.path.join(self.folder, "libraries")
        for component in ("headers", "library"):
            run(["cmake", "--install", k_build, "--prefix", prefix, "--component", component])
        self.assertFalse(os.path.exists(os.path.join(prefix, "bin")))
        run(self.configure("library", "-DCMAKE_PREFIX_PATH=" + prefix, "-DCMAKE_CXX_FLAGS=" + " ".join(k_flags)))
        build = os.path.join(self.folder, "library")
        run(["ninja", "-C", build])
        # The scene's four polygons; its fifth light is a point.
        printed = run([os.path.join(build, "consumer"), os.path.join(k_root, "scenes", "demo.glb")])
        self.assertIn("4 polygon lights", printed)
        # Their headers include nothing that is not installed, and can all be included at once.
        include = os.path.join(prefix, "include")
        names = sorted(name for name in installed_files(include) if name.endswith(".h"))
        self.assertGreater(len(names), 150)
        program = os.path.join(self.folder, "all_headers.cpp")
        with open(program, "w", encoding="utf-8") as stream:
            stream.write("".join('#include "%s"\n' % name for name in names))
        run([k_compiler, "-std=c++20", "-fsyntax-only", "-I", include, program])

    def configure(self, name, *arguments):
        return ["cmake", "-G", "Ninja", "-S", os.path.join(k_projects, name), "-B", os.path.join(self.folder, name),
                "-DCMAKE_CXX_COMPILER=" + k_compiler, *arguments]

    def build_and_run(self, name, *arguments):
        run(self.configure(name, *arguments))
        build = os.path.join(self.folder, name)
        commands = run(["ninja", "-C", build, "-t", "commands", "consumer"])
        for ours in ("-std=c++20", "-Wextra", "-ffp-contract", "-fno-math-errno", "libopenltc"):
            self.assertNotIn(ours, commands.replace("gnu++20", "c++20"))
        run(["ninja", "-C", build, "-j", "2"])
        run([os.path.join(build, "consumer")])


def run(command, environment=None):
    """What it printed; what fails says so with all of it."""
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment,
                            check=False)
    if result.returncode != 0:
        raise AssertionError("%s:\n%s" % (command, result.stdout))
    return result.stdout


if __name__ == "__main__":
    unittest.main()
