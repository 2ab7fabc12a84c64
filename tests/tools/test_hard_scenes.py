# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""scenes/hard holds what its script makes, byte for byte, and nothing else."""

import os
import subprocess
import sys
import tempfile
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
k_folder = os.path.join(k_root, "scenes", "hard")


def contents(folder):
    found = {}
    for name in os.listdir(folder):
        with open(os.path.join(folder, name), "rb") as stream:
            found[name] = stream.read()
    return found


class HardScenes(unittest.TestCase):
    def test_script_makes_the_checked_in_files(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, "-B", os.path.join(k_root, "tools/make_hard_scenes.py"), folder],
                           check=True)
            made, there = contents(folder), contents(k_folder)
        self.assertEqual(sorted(made), sorted(there))
        for name, data in made.items():
            self.assertTrue(data == there[name], name + " differs: run tools/make_hard_scenes.py")


unittest.main()
