# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""What tools/make_emissive_scenes.py makes is lit as its geometry says: flux is pi L A."""

import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(k_root, "tools"))

import make_emissive_scenes as script  # noqa: E402


class EmissiveScenes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        for name, make in script.scenes():
            with open(os.path.join(cls.folder.name, name), "wb") as stream:
                stream.write(make())

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def lights(self, name):
        output = subprocess.run([k_tool, "inspect", "--json", os.path.join(self.folder.name, name)],
                                check=True, stdout=subprocess.PIPE).stdout
        return json.loads(output)["lights"]

    def check(self, name, lumens, most_lights, tolerance=1e-3):
        lights = self.lights(name)
        self.assertLessEqual(len(lights), most_lights)
        flux = sum(light["flux_lumens"] for light in lights)
        self.assertAlmostEqual(flux / lumens, 1, delta=tolerance)

    def test_neon(self):
        letters = script.lettering("COSODUNS", 0.42)
        self.assertEqual(len(letters), 8300)
        self.check("neon.glb", math.pi * 0.5 * script.area_of(letters), 1500)

    def test_knots_have_the_same_flux(self):
        power = 100 * script.area_of(script.knot(380, 14))
        for triangles, most in ((96, 96), (960, 960), (10640, 1500)):
            self.check("knot-%d.glb" % triangles, math.pi * power, most)

    def test_a_fine_disk(self):
        self.check("disk.glb", math.pi * 100 * math.pi / 4, 10)

    def test_a_masked_panel(self):
        # The texture's filter rounds off the corners of its openings a little, for the camera too.
        self.check("mask.glb", math.pi * 100 / 4, 1, 0.006)

    def test_overlapping_quads_shine_once(self):
        quads = script.area_of(script.overlapping_quads(10000))
        lights = self.lights("overlapping.glb")
        self.assertEqual(len(lights), 1)
        flux = lights[0]["flux_lumens"]
        # More than the inner rectangle, less than the one around all.
        self.assertGreater(flux, math.pi * 10 * 2 * 1.2)
        self.assertLess(flux, math.pi * 10 * 2.15 * 1.35)
        self.assertLess(flux, math.pi * 10 * quads / 10)


if __name__ == "__main__":
    k_tool = sys.argv.pop(1)
    unittest.main()
