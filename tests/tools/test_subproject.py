# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Inside another project that asks for them OpenLTC is its libraries: no tool, test, benchmark or flag of
its own. What it is where nobody asks, test_install.py says."""

import os
import subprocess
import sys
import tempfile
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
k_compiler = sys.argv.pop(1)

k_project = """cmake_minimum_required(VERSION 3.22)
project(consumer LANGUAGES CXX)
set(OPENLTC_LIBRARY ON)
add_subdirectory("%s" openltc)
add_executable(consumer consumer.cpp)
target_link_libraries(consumer PRIVATE openltc::base)
add_executable(engine engine.cpp)
target_link_libraries(engine PRIVATE openltc::api)
set_target_properties(engine PROPERTIES CXX_STANDARD 17)
foreach(name openltc test_base bench_fit)
  if(TARGET ${name})
    message(FATAL_ERROR "${name} is there")
  endif()
endforeach()
""" % k_root

k_source = """#include "openltc/base/quote.h"
int main() { return openltc::escaped("a\\tb") == "a\\\\tb" ? 0 : 1; }
"""

k_engine = """#include "openltc/openltc.h"
int main() { return openltc::Polygon::rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}).usable() ? 0 : 1; }
"""


class Subproject(unittest.TestCase):
    def test_add_subdirectory(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (("CMakeLists.txt", k_project), ("consumer.cpp", k_source),
                               ("engine.cpp", k_engine)):
                with open(os.path.join(folder, name), "w", encoding="utf-8") as stream:
                    stream.write(text)
            build = os.path.join(folder, "build")
            self.run_all(["cmake", "-G", "Ninja", "-S", folder, "-B", build,
                          "-DCMAKE_CXX_COMPILER=" + k_compiler])
            targets = self.run_all(["ninja", "-C", build, "-t", "targets", "all"])
            self.assertIn("libopenltc_plot.a", targets)
            for ours in ("bin/openltc", "test_base", "bench_fit"):
                self.assertNotIn(ours, targets)
            commands = self.run_all(["ninja", "-C", build, "-t", "commands", "consumer"])
            line = next(l for l in commands.splitlines() if "-c" in l and "consumer.cpp" in l)
            self.assertIn("-std=c++20", line.replace("gnu++20", "c++20"))
            for flag in ("-Wextra", "-Werror", "-ffp-contract", "-fno-math-errno"):
                self.assertNotIn(flag, line)
            # The public API alone asks for C++17, and for no library.
            commands = self.run_all(["ninja", "-C", build, "-t", "commands", "engine"])
            line = next(l for l in commands.splitlines() if "-c" in l and "engine.cpp" in l)
            self.assertIn("-std=c++17", line.replace("gnu++17", "c++17"))
            self.assertNotIn("libopenltc", commands)
            self.run_all(["ninja", "-C", build, "-j", "2", "consumer", "engine"])
            self.run_all([os.path.join(build, "consumer")])
            self.run_all([os.path.join(build, "engine")])

    def run_all(self, command):
        result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(result.returncode, 0, "%s:\n%s" % (command, result.stdout))
        return result.stdout


if __name__ == "__main__":
    unittest.main()
