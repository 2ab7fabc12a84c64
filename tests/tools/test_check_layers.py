# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The repository keeps its layers, and the checker notices each kind of breach."""

import os
import sys
import tempfile
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(k_root, "tools"))
import check_layers  # noqa: E402

k_licence = "// Copyright (c) 2026 The OpenLTC authors\n// SPDX-License-Identifier: MIT\n"


def check_tree(files):
    """Breaches of a made-up tree: path -> text after the licence lines (whole text if bytes)."""
    with tempfile.TemporaryDirectory() as root:
        for path, text in files.items():
            os.makedirs(os.path.join(root, os.path.dirname(path)), exist_ok=True)
            with open(os.path.join(root, path), "wb") as stream:
                stream.write(text if isinstance(text, bytes) else (k_licence + text).encode())
        return check_layers.check(root)


class Layers(unittest.TestCase):
    def assert_breach(self, path, text, expected):
        breaches = check_tree({path: text})
        self.assertEqual(len(breaches), 1, breaches)
        self.assertEqual(breaches[0][0], path)
        self.assertIn(expected, breaches[0][2])

    def assert_clean(self, path, text):
        self.assertEqual(check_tree({path: text}), [])

    def test_repository_keeps_its_rules(self):
        breaches = check_layers.check(k_root)
        self.assertEqual(breaches, [], "\n" + "\n".join("%s:%d: %s" % b for b in breaches))

    def test_repository_is_really_read(self):
        paths = list(check_layers.find_sources(k_root))
        for path in ("openltc/shade/ggx.glsl", "openltc/scene/scene.h", "cli/main.cpp", ".ci/run"):
            self.assertIn(path, paths)

    def test_folders_include_upwards_only(self):
        for position, folder in enumerate(check_layers.k_layers):
            for lower in check_layers.k_layers[position + 1:]:
                self.assertEqual(
                    len(check_tree({"openltc/%s/a.h" % folder: '#include "openltc/%s/b.h"\n' % lower})),
                    1, "%s includes %s" % (folder, lower))
        self.assert_clean("openltc/render/a.cpp", '#include "openltc/scene/scene.h"\n#include <vector>\n')
        self.assert_clean("openltc/fit/a.h", '#include "openltc/table/lobe_table.h"\n')

    def test_rendering_does_not_know_fitting(self):
        for folder in ("light", "scene", "render"):
            self.assert_breach("openltc/%s/a.cpp" % folder, '#include "openltc/fit/fit.h"\n',
                               "may not include fit")

    def test_the_public_header_includes_the_api_alone(self):
        self.assert_clean("openltc/openltc.h", '#include "openltc/api/surface.h"\n')
        self.assert_breach("openltc/openltc.h", '#include "openltc/light/light.h"\n', "api alone")
        self.assert_breach("openltc/openltc.h", '#include <vector>\n', "api alone")
        self.assert_breach("openltc/api/a.h", '#include "openltc/base/result.h"\n', "may not include")
        self.assert_breach("openltc/render/a.cpp", '#include "openltc/openltc.h"\n', "includes start")

    def test_the_c_header_includes_headers_of_c_alone(self):
        self.assert_clean("openltc/openltc_c.h", "#include <stddef.h>\n#include <stdint.h>\n")
        self.assert_breach("openltc/openltc_c.h", '#include "openltc/api/surface.h"\n', "C alone")
        self.assert_breach("openltc/openltc_c.h", "#include <cstddef>\n", "C alone")
        self.assert_clean("openltc/c_api/a.cpp", '#include "openltc/openltc_c.h"\n')
        self.assert_breach("openltc/fit/a.cpp", '#include "openltc/openltc_c.h"\n', "includes start")

    def test_shade_includes_nothing(self):
        self.assert_breach("openltc/shade/a.glsl", "#include <cmath>\n", "includes nothing")
        self.assert_breach("openltc/shade/a.glsl", '#include "openltc/shade/b.glsl"\n',
                           "includes nothing")

    def test_library_does_not_include_its_users(self):
        self.assert_breach("openltc/base/a.cpp", '#include "cli/commands.h"\n', "root")
        self.assert_breach("openltc/base/a.cpp", '#include "result.h"\n', "root")

    def test_heavy_headers_stay_in_source_files(self):
        for header in ("embree3/rtcore.h", "tiny_gltf.h", "OpenEXR/ImfHeader.h", "png.h",
                       "stb_image.h", "draco/compression/decode.h", "meshoptimizer.h"):
            self.assert_breach("openltc/render/a.h", "#include <%s>\n" % header, ".cpp")
            self.assert_clean("openltc/render/a.cpp", "#include <%s>\n" % header)
        self.assert_clean("openltc/render/embree.h", "#include <embree4/rtcore.h>\n")
        self.assert_clean("openltc/image/exr/exr_input.h", "#include <ImfIO.h>\n")
        self.assert_clean("openltc/scene/gltf/file/tinygltf.h", "#include <tiny_gltf.h>\n")

    def test_library_is_silent(self):
        for line in ("std::cerr << 1;", 'fmt::print(stderr, "x");', 'fmt::print("x");', 'printf("x");',
                     "std::fputs(text, stdout);", "#include <csignal>", "sigaction(2, &a, &b);",
                     "std::signal(2, f);", "std::exit(1);", "::_exit(1);", "std::atexit(f);",
                     "if (isatty(2)) f();", "std::abort();"):
            self.assert_breach("openltc/base/a.cpp", "int a; // x\n%s\n" % line, "prints nothing")
            self.assertEqual(check_tree({"cli/a.cpp": line + "\n"}), [])
        for line in ("// std::cerr and stdout", '/* exit(1)\n abort() */ int b = 1;',
                     'f("stderr", "abort()");', 'fmt::print(file, "x");', "bool on_exit;",
                     'std::fprintf(file, "x");', "snprintf(a, 2, b);", "group.exit(1);"):
            self.assert_clean("openltc/base/a.cpp", line + "\n")

    def test_threads_come_from_one_file(self):
        for line in ("#include <tbb/parallel_for.h>", "tbb::parallel_for(0, n, f);",
                     "std::thread t(f);", "std::async(f);", "#include <execution>"):
            for path in ("openltc/fit/a.cpp", "cli/a.cpp"):
                self.assert_breach(path, line + "\n", "openltc/base/parallel.cpp")
            self.assert_clean("openltc/base/parallel.cpp", line + "\n")
        self.assert_clean("openltc/fit/a.cpp", "// as tbb::parallel_for\n"
                          "int n = std::thread::hardware_concurrency();\n")

    def test_folders_are_narrow(self):
        for folder in ("openltc/base", "cli", "tests/shade", "bench", "tools"):
            files = {"%s/a%d.h" % (folder, i): "" for i in range(30)}
            files[folder + "/room/a.h"] = ""
            self.assertEqual(check_tree(files), [])
            files[folder + "/a30.h"] = ""
            breaches = check_tree(files)
            self.assertEqual([breach[0] for breach in breaches], [folder])
            self.assertIn("31 files", breaches[0][2])

    def test_sources_are_short(self):
        # The two licence lines count.
        for path in ("openltc/base/a.cpp", "cli/a.cpp", "tests/base/a.cpp", "docs/examples/a.c"):
            self.assert_clean(path, "\n" * 398)
            self.assert_breach(path, "\n" * 399, "401 lines")
        python = k_licence.replace("//", "#").encode()
        self.assert_breach("tools/a.py", python + b"\n" * 399, "401 lines")

    def test_long_sources_are_there_and_say_why(self):
        for path, reason in check_layers.k_long_sources.items():
            self.assertTrue(os.path.isfile(os.path.join(k_root, path)), path)
            self.assertTrue(reason)
            self.assert_clean(path, "\n" * 1000)

    def test_every_file_names_its_licence(self):
        for path in ("openltc/base/a.h", "tools/a.py", "cmake/a.cmake", "tests/shaders/a.frag"):
            self.assert_breach(path, b"int x;\n", "licence")

    def test_unknown_folder_is_noticed(self):
        self.assert_breach("openltc/utils/a.h", "", "not in the list")

    def test_root_list_file_stays_short(self):
        head = k_licence.replace("//", "#").encode()
        self.assert_breach("CMakeLists.txt", head + b"\n" * 90, "under 80 lines")
        self.assertEqual(check_tree({"CMakeLists.txt": head + b"\n" * 70}), [])


if __name__ == "__main__":
    unittest.main()
