# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The notebooks run: their cells of code, one after the other, as a notebook would; what a cell shows can be
shown."""

import ast
import contextlib
import glob
import io
import json
import os
import unittest

k_root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def run_cell(source, names):
    """Runs a cell and gives the value of its last expression, as a notebook has it."""
    tree = ast.parse(source)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    return eval(compile(ast.Expression(last.value), "cell", "eval"), names) if last else None


class Notebooks(unittest.TestCase):
    def test_all_run(self):
        paths = sorted(glob.glob(os.path.join(k_root, "docs", "examples", "python", "*.ipynb")))
        self.assertGreaterEqual(len(paths), 3)
        here = os.getcwd()
        os.chdir(k_root)
        try:
            for path in paths:
                with self.subTest(os.path.basename(path)), contextlib.redirect_stdout(io.StringIO()):
                    with open(path, encoding="utf-8") as file:
                        cells = json.load(file)["cells"]
                    names, shown = {}, 0
                    for cell in cells:
                        if cell["cell_type"] == "code":
                            value = run_cell("".join(cell["source"]), names)
                            for show in ("_repr_svg_", "_repr_png_", "_repr_html_"):
                                if hasattr(value, show):
                                    self.assertTrue(getattr(value, show)())
                                    shown += 1
                    self.assertGreater(shown, 0)
        finally:
            os.chdir(here)
