# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""openltc/openltc_c.h is C and C++ without a warning, and libopenltc_c.so is what it declares.

    test_c_library.py COMPILER [LIBRARY]   the C compiler of the build, and the library if it was built
"""

import ctypes
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
k_header = os.path.join(k_root, "openltc", "openltc_c.h")
k_compiler = sys.argv[1]
k_library = sys.argv[2] if len(sys.argv) > 2 else None
del sys.argv[1:]

k_strict = ["-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-pedantic", "-Werror", "-I", k_root, "-fsyntax-only"]
# What a process that loads the library has to have: no image or scene library.
k_needed = re.compile(r"lib(tbb|fmt|stdc\+\+|c\+\+|m|gcc_s|c)\.so|ld-linux")


def compilers():
    """The build's C compiler, and one of the other kind if there is one."""
    other = ["clang-14", "clang"] if "clang" not in os.path.basename(k_compiler) else ["gcc"]
    return [k_compiler] + [path for path in map(shutil.which, other) if path][:1]


def declared_functions():
    with open(k_header, encoding="utf-8") as stream:
        code = re.sub(r"//[^\n]*", "", stream.read())
    return set(re.findall(r"OPENLTC_EXPORT[^;]*?\b(openltc_\w+)\s*\(", code))


class Header(unittest.TestCase):
    def compile(self, compiler, language, standard, text):
        run = subprocess.run([compiler, "-x", language, "-std=" + standard] + k_strict + ["-"], input=text,
                             capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, "%s %s\n%s" % (compiler, standard, run.stderr))

    def test_it_is_c_and_cpp(self):
        text = '#include "openltc/openltc_c.h"\n#include "openltc/openltc_c.h"\n'
        for compiler in compilers():
            for language, standard in (("c", "c99"), ("c", "c17"), ("c++", "c++17"), ("c++", "c++20")):
                self.compile(compiler, language, standard, text + "int main(void) { return OPENLTC_OK; }\n")

    def test_the_code_of_the_page_compiles(self):
        with open(os.path.join(k_root, "docs", "api.md"), encoding="utf-8") as stream:
            blocks = re.findall(r"^```c\n(.*?)^```$", stream.read(), re.S | re.M)
        self.assertGreater(len(blocks), 0)
        for block in blocks:
            self.compile(k_compiler, "c", "c99", block)

    def test_declarations_are_found(self):
        self.assertIn("openltc_shade", declared_functions())
        self.assertIn("openltc_fit_function", declared_functions())
        self.assertGreater(len(declared_functions()), 25)


class Vectors(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("stride", ctypes.c_size_t)]


class Points(ctypes.Structure):
    _fields_ = [("count", ctypes.c_size_t)] + [
        (name, Vectors) for name in ("positions", "normals", "views", "materials", "geometric_normals",
                                     "position_errors")]


k_progress = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_double, ctypes.c_void_p)
k_brdf = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.POINTER(ctypes.c_double), ctypes.POINTER(ctypes.c_double),
                          ctypes.c_double, ctypes.c_void_p)


class FitOptions(ctypes.Structure):
    _fields_ = [("form", ctypes.c_int32), ("refine", ctypes.c_int32), ("size", ctypes.c_size_t),
                ("degree", ctypes.c_size_t), ("objective", ctypes.c_char_p), ("progress", k_progress),
                ("progress_user", ctypes.c_void_p)]


class FitResult(ctypes.Structure):
    _fields_ = [("float_count", ctypes.c_size_t), ("columns", ctypes.c_size_t), ("rows", ctypes.c_size_t),
                ("degree", ctypes.c_size_t), ("width", ctypes.c_int32), ("mean_tv", ctypes.c_double),
                ("max_tv", ctypes.c_double)]


k_ok, k_cancelled = 0, 5
k_same = ctypes.c_size_t(-1).value


def floats(*values):
    return (ctypes.c_float * len(values))(*values)


@unittest.skipUnless(k_library, "built without libopenltc_c.so")
class Library(unittest.TestCase):
    def setUp(self):
        self.library = ctypes.CDLL(k_library)
        self.library.openltc_last_error.restype = ctypes.c_char_p
        self.library.openltc_brdf_name.restype = ctypes.c_char_p

    def read(self, *command):
        return subprocess.run(list(command) + [k_library], capture_output=True, text=True, check=True).stdout

    def test_it_shows_what_the_header_declares_and_nothing_else(self):
        names = {line.split()[-1] for line in self.read("nm", "-D", "--defined-only").splitlines()}
        self.assertEqual(names, declared_functions())

    def test_it_needs_few_libraries(self):
        needed = re.findall(r"\(NEEDED\).*\[(.*)\]", self.read("readelf", "-d"))
        self.assertGreater(len(needed), 0)
        self.assertEqual([name for name in needed if not k_needed.match(name)], [])

    def test_it_is_installed_with_what_a_program_needs(self):
        with tempfile.TemporaryDirectory() as folder:
            first, prefix = os.path.join(folder, "first"), os.path.join(folder, "moved")
            build = os.path.dirname(os.path.dirname(k_library))
            subprocess.run(["cmake", "--install", build, "--prefix", first, "--component", "c"], check=True,
                           stdout=subprocess.DEVNULL)
            os.rename(first, prefix)
            found = [at for at, _, names in os.walk(prefix) if "openltc_c.pc" in names]
            self.assertEqual(len(found), 1)
            flags = subprocess.run(["pkg-config", "--cflags", "--libs", "openltc_c"], capture_output=True, text=True,
                                   check=True, env=dict(os.environ, PKG_CONFIG_PATH=found[0])).stdout.split()
            program = os.path.join(folder, "shade_quad")
            subprocess.run([k_compiler, "-std=c99", os.path.join(k_root, "docs/examples/shade_quad.c"), "-o", program]
                           + flags, check=True)
            printed = subprocess.run([program], capture_output=True, text=True, check=True,
                                     env=dict(os.environ, LD_LIBRARY_PATH=os.path.dirname(found[0]))).stdout
            self.assertRegex(printed, r"^in the middle: \d+\.\d+ nits$")

    def call(self, name, *arguments):
        self.assertEqual(getattr(self.library, name)(*arguments), k_ok, self.library.openltc_last_error())

    def test_a_white_floor_shows_a_quarter_of_the_radiance_of_a_sphere(self):
        # Lambert: a sphere straight above gives the square of the sine of its angular radius, here 1/4.
        lobes, lights = ctypes.c_void_p(), ctypes.c_void_p()
        self.call("openltc_lobes_create_built_in", 0, ctypes.byref(lobes))
        self.call("openltc_lights_create", ctypes.byref(lights))
        self.call("openltc_lights_add_sphere", lights, floats(0, 1, 0), ctypes.c_float(0.5), floats(8, 4, 0))
        count = 1000
        positions = floats(*[0.0] * 3 * count)
        up, white = floats(0, 1, 0), floats(1, 1, 1, 0, 1, 0, 1, 1, 1, 1.5)
        points = Points(count)
        points.positions = Vectors(ctypes.addressof(positions), 0)
        points.normals = points.views = Vectors(ctypes.addressof(up), k_same)
        points.materials = Vectors(ctypes.addressof(white), k_same)
        radiance = floats(*[-1.0] * 3 * count)
        self.call("openltc_shade", lobes, lights, ctypes.byref(points), 0, radiance)
        for i, expected in ((0, 2), (1, 1), (2, 0), (3 * count - 3, 2)):
            self.assertAlmostEqual(radiance[i], expected, 5)
        self.library.openltc_lights_destroy(lights)
        self.library.openltc_lobes_destroy(lobes)

    def test_a_function_of_python_is_fitted(self):
        # A clamped cosine is Lambert's lobe.
        brdf = k_brdf(lambda wo, wi, roughness, user: 1 / math.pi)
        seen = []
        progress = k_progress(lambda share, user: seen.append(share) or 1)
        options = FitOptions(size=2, objective=b"tv", refine=2, progress=progress)
        numbers, result = (ctypes.c_float * 32)(), FitResult()
        self.call("openltc_fit_function", brdf, None, 1, ctypes.byref(options), numbers, ctypes.c_size_t(32),
                  ctypes.byref(result))
        self.assertEqual((result.columns, result.rows, result.float_count), (2, 2, 32))
        self.assertAlmostEqual(numbers[4], 1, 2)  # the albedo
        self.assertEqual(seen[-1], 1)

    def test_python_stops_a_fit(self):
        options = FitOptions(size=64, progress=k_progress(lambda share, user: 0))
        numbers = (ctypes.c_float * (64 * 64 * 8))()
        status = self.library.openltc_fit(b"ggx", ctypes.byref(options), numbers, ctypes.c_size_t(len(numbers)),
                                          None)
        self.assertEqual(status, k_cancelled)
        self.assertEqual(self.library.openltc_last_error(), b"cancelled")
        self.assertEqual(self.library.openltc_brdf_name(ctypes.c_size_t(0)), b"ggx")


if __name__ == "__main__":
    unittest.main()
