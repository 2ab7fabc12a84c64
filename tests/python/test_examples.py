# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The examples in the docstrings of the package, as doctests."""

import doctest
import importlib
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

    def test_every_public_name_says_what_it_is(self):
        for name in openltc.__all__:
            if not name.startswith("__"):
                self.assertTrue(getattr(openltc, name).__doc__, name)
