# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""`make shader-cost` on two of its shaders: it counts what spirv-dis lists, and goes on without a driver.

    test_shader_cost.py FOLDER_OF_PROGRAMS WORK_DIR
"""

import contextlib
import io
import os
import re
import shutil
import subprocess
import sys
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(k_root, "bench/shader_cost"))
import cost  # noqa: E402
import spirv  # noqa: E402

k_exit_skipped = 77
k_rows = [cost.lights.Row("line", "polynomial"), cost.lights.Row("usual, clipped", "table")]


def cells_of_rows():
    """The cells of each row that is printed."""
    output = io.StringIO()
    with contextlib.redirect_stdout(output):
        cost.print_static(Test.folder, k_rows)
    lines = [line.strip("| ").split(" | ") for line in output.getvalue().splitlines() if line.startswith("| ")]
    return lines[0], lines[1:]


class Test(unittest.TestCase):
    folder = None

    @classmethod
    def setUpClass(cls):
        cls.head, cls.lines = cells_of_rows()

    def test_counts_are_those_of_the_disassembler(self):
        module = Test.folder.path(k_rows[0].file_name + ".opt.spv")
        text = subprocess.run(["spirv-dis", module], stdout=subprocess.PIPE, text=True, check=True).stdout
        names = re.compile(r"^\s*(;|Op(Name|MemberName|Decorate|MemberDecorate|Source|String)\b|$)")
        self.assertEqual(spirv.count_instructions(module),
                         sum(1 for line in text.splitlines() if not names.match(line)))
        functions = re.findall(r"= OpFunction .*?OpFunctionEnd", text, re.S)
        self.assertEqual(spirv.count_in_functions(module), sum(len(text.splitlines()) for text in functions))
        self.assertGreater(spirv.count_in_functions(module), 100)
        self.assertEqual(spirv.constant_bytes(module), 4 * len(re.findall(r"= OpConstant %float ", text)))

    def test_every_cell_has_a_number(self):
        self.assertEqual([line[:2] for line in self.lines], [["line", "polynomial"], ["usual, clipped", "table"]])
        for line in self.lines:
            self.assertEqual(len(line), len(self.head))
            for cell in line[2:]:
                self.assertRegex(cell, r"^(\d+|not measured)$")

    def test_without_a_driver_it_says_so(self):
        driver, cost.k_driver = cost.k_driver, "/nowhere/*.json"
        try:
            _, lines = cells_of_rows()
        finally:
            cost.k_driver = driver
        for line in lines:
            self.assertEqual(line.count("not measured"), len(cost.k_amd_head))
            self.assertGreater(int(line[2]), 100)


if __name__ == "__main__":
    for tool, package in (("glslangValidator", "glslang-tools"), ("spirv-dis", "spirv-tools")):
        if not shutil.which(tool):
            print("skipped: no %s (package %s)" % (tool, package))
            sys.exit(k_exit_skipped)
    Test.folder = cost.parity.Folder(sys.argv[1], sys.argv[2])
    unittest.main(argv=sys.argv[:1])
