# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""openltc/openltc.h is what it says: C++17, without warnings, by GCC and Clang; leaves no macros. It and the other
public headers mind none.

    test_api_headers.py COMPILER   the build's own, besides those that are found
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
k_flags = ["-std=c++17", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-pedantic", "-Werror", "-I", k_root]
k_own = sys.argv.pop(1)

k_standard = "".join("#include <%s>\n" % name for name in
                     ("algorithm", "cassert", "cmath", "cstddef", "cstdint", "limits", "utility", "vector"))

# What other headers define by names without a prefix: those of Windows, of X11, of doctest, Catch2 and gmock;
# and the dialect's own.
k_foreign = """
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define near
#define far
#define small char
#define hyper long long
#define interface struct
#define IN
#define OUT
#define OPTIONAL
#define CONST const
#define VOID void
#define TRUE 1
#define FALSE 0
#define ERROR 0
#define ABSOLUTE 1
#define RELATIVE 2
#define OPAQUE 2
#define TRANSPARENT 1
#define DIFFERENCE 11
#define RGB(r, g, b) (r)
#define Bool int
#define Status int
#define None 0L
#define True 1
#define False 0
#define Success 0
#define Always 2
#define Above 0
#define Below 1
#define Complex 0
#define Convex 2
#define GIVEN(name) while (name)
#define WHEN(name) while (name)
#define THEN(name) while (name)
#define CHECK(condition) while (condition)
#define REQUIRE(condition) while (condition)
#define INFO(text) (text)
#define ASSERT_THAT(value, matcher) while (matcher == value)
#define FN 1
#define FN_INLINE 4
#define FN_CALL 2
#define CONSTANT 3
"""


def compilers():
    """The build's compiler, and one of the other kind if there is one."""
    found = [k_own]
    other = ["clang++-14", "clang++"] if "clang" not in os.path.basename(k_own) else ["g++-12", "g++-11", "g++"]
    return found + [path for path in map(shutil.which, other) if path][:1]


def macros_of(compiler, text):
    """The macros that are defined at the end of a source: what each is, by its name."""
    run = subprocess.run([compiler, "-std=c++17", "-I", k_root, "-dM", "-E", "-x", "c++", "-"], input=text,
                         capture_output=True, text=True, check=True)
    return {re.split(r"[ (]", line)[1]: line for line in run.stdout.splitlines()}


class ApiHeaders(unittest.TestCase):
    def compile(self, compiler, arguments):
        run = subprocess.run([compiler] + k_flags + arguments, capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, "%s\n%s" % (compiler, run.stderr))

    def test_all_of_the_api_is_cxx17_without_warnings(self):
        for compiler in compilers():
            with tempfile.TemporaryDirectory() as folder:
                self.compile(compiler, ["-O1", "-c", os.path.join(k_root, "tests/api/second_unit.cpp"), "-o",
                                        os.path.join(folder, "unit.o")])

    def test_the_table_can_be_left_out(self):
        for compiler in compilers():
            with tempfile.TemporaryDirectory() as folder:
                source = os.path.join(folder, "no_table.cpp")
                with open(source, "w", encoding="utf-8") as stream:
                    stream.write('#include "openltc/openltc.h"\n'
                                 "int main() { return openltc::built_in_polynomial().polynomial.degree - 4; }\n")
                self.compile(compiler, ["-DOPENLTC_NO_TABLE", "-fsyntax-only", source])
                with open(source, "w", encoding="utf-8") as stream:
                    stream.write('#include "openltc/openltc.h"\nconst float* table = openltc::k_ggx_table;\n')
                run = subprocess.run([compiler] + k_flags + ["-DOPENLTC_NO_TABLE", "-fsyntax-only", source],
                                     capture_output=True, check=False)
                self.assertNotEqual(run.returncode, 0, "OPENLTC_NO_TABLE leaves the table in")

    def test_the_code_of_the_documents_compiles(self):
        for name in ("README.md", "README.zh-CN.md", "docs/api.md"):
            with open(os.path.join(k_root, name), encoding="utf-8") as stream:
                blocks = re.findall(r"^```cpp\n(.*?)^```$", stream.read(), re.S | re.M)
            self.assertGreater(len(blocks), 0, name)
            # What is no whole program stands in a function, with the names that the text takes for granted.
            text = blocks[0] + "Vec2f random_2();\nbool is_open(Vec3f, Vec3f);\n"
            for number, block in enumerate(blocks[1:]):
                text += ("Vec3f block_%d(const Surface& surface, Vec3f point, Vec3f radiance, int samples) {\n%s"
                         "return shaded;\n}\n" % (number, block))
            run = subprocess.run([k_own] + k_flags + ["-fsyntax-only", "-x", "c++", "-"], capture_output=True,
                                 text=True, check=False, input=text)
            self.assertEqual(run.returncode, 0, "%s\n%s" % (name, run.stderr))

    def test_every_header_includes_what_it_needs(self):
        folder = os.path.join(k_root, "openltc", "api")
        names = sorted(name for name in os.listdir(folder) if name.endswith((".h", ".inc")))
        self.assertGreater(len(names), 5)
        for name in names:
            run = subprocess.run([k_own] + k_flags + ["-fsyntax-only", "-x", "c++", "-"], capture_output=True,
                                 text=True, check=False, input='#include "openltc/api/%s"\n' % name)
            self.assertEqual(run.returncode, 0, "%s\n%s" % (name, run.stderr))

    def test_no_macro_is_left_behind(self):
        for compiler in compilers():
            left = macros_of(compiler, k_standard + '#include "openltc/openltc.h"\n')
            self.assertEqual(set(left) - set(macros_of(compiler, k_standard)), set())

    def test_macros_of_other_headers_neither_harm_it_nor_suffer(self):
        before = k_standard + k_foreign
        for header in ("openltc.h", "batch.h", "openltc_c.h"):
            after = before + '#include "openltc/%s"\n' % header
            for compiler in compilers():
                run = subprocess.run([compiler] + k_flags + ["-fsyntax-only", "-x", "c++", "-"], capture_output=True,
                                     text=True, check=False, input=after)
                self.assertEqual(run.returncode, 0, "%s by %s\n%s" % (header, compiler, run.stderr))
                # A guard that the header leaves is no foreign macro.
                found = macros_of(compiler, after)
                self.assertEqual({name: found.get(name) for name in macros_of(compiler, before)},
                                 macros_of(compiler, before), header)


if __name__ == "__main__":
    unittest.main()
