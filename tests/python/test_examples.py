# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The examples in the docstrings of the package, as doctests."""

import ast
import doctest
import inspect
import importlib
import os
import re
import pkgutil
import unittest

import numpy as np
import openltc


class Examples(unittest.TestCase):
    def test_docstrings(self):
        tried = 0
        for module in pkgutil.iter_modules(openltc.__path__):
            if module.name in ("_openltc", "__main__"):
                continue
            part = importlib.import_module(f"openltc.{module.name}")
            result = doctest.testmod(part, extraglobs={"openltc": openltc, "np": np})
            self.assertEqual(result.failed, 0, module.name)
            tried += result.attempted
        self.assertGreater(tried, 10)

    def test_types_are_those_of_the_module(self):
        # What editors see of the package, and the stubs of its module.
        shown = next(node for node in ast.parse(inspect.getsource(openltc)).body if isinstance(node, ast.If))
        names = {name.name for node in shown.body if isinstance(node, ast.ImportFrom) for name in node.names}
        self.assertEqual(names | {"__version__"}, set(openltc.__all__))
        from nanobind.stubgen import StubGen

        module = importlib.import_module("openltc._openltc")
        made = StubGen(module)
        made.put(module)
        with open(os.path.join(os.path.dirname(openltc.__file__), "_openltc.pyi"), encoding="utf-8") as file:
            kept = file.read()

        # Scenes' fields are set by a function of ours, for its words; for editors fields are what their types say.
        setters = r'    def __(?:set|del)attr__\(.*\n(?:        """.*"""\n)?'

        def lines(text):  # their order is not always the same
            return sorted(line for line in re.sub(setters, "", text).splitlines() if line and not line.startswith("#"))

        self.assertEqual(lines(made.get()), lines(kept))

    def test_every_public_name_says_what_it_is(self):
        for name in openltc.__all__:
            if not name.startswith("__"):
                self.assertTrue(getattr(openltc, name).__doc__, name)
