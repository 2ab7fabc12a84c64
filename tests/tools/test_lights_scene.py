# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""scenes/lights.glb is what its script makes, byte for byte, and holds every shape of light."""

import json
import os
import subprocess
import sys
import tempfile
import unittest

from test_demo_scene import Glb, k_root

k_scene = os.path.join(k_root, "scenes", "lights.glb")


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


class LightsScene(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with open(k_scene, "rb") as stream:
            cls.bytes = stream.read()
        cls.glb = Glb(cls.bytes)
        cls.nodes = {n["name"]: n for n in cls.glb.document["nodes"]}

    def extras_light(self, name):
        return self.nodes[name]["extras"]["openltc_light"]

    def positions(self, name):
        mesh = self.glb.document["meshes"][self.nodes[name]["mesh"]]
        return self.glb.values(mesh["primitives"][0]["attributes"]["POSITION"])

    def test_script_makes_the_checked_in_file(self):
        with tempfile.TemporaryDirectory() as folder:
            again = os.path.join(folder, "lights.glb")
            subprocess.run([sys.executable, "-B", os.path.join(k_root, "tools/make_lights_scene.py"),
                            "-o", again], check=True, stdout=subprocess.DEVNULL)
            with open(again, "rb") as stream:
                self.assertTrue(stream.read() == self.bytes,
                                "scenes/lights.glb differs: run tools/make_lights_scene.py")

    def test_stays_small(self):
        self.assertLess(len(self.bytes), 3_000_000)

    def test_names_are_unique(self):
        self.assertEqual(len(self.nodes), len(self.glb.document["nodes"]))

    def test_triangles_face_their_unit_normals(self):
        for primitive in self.glb.primitives():
            positions = self.glb.values(primitive["attributes"]["POSITION"])
            normals = self.glb.values(primitive["attributes"]["NORMAL"])
            for n in normals:
                self.assertAlmostEqual(dot(n, n), 1, delta=1e-6)
            flat = [i for (i,) in self.glb.values(primitive["indices"])]
            for a, b, c in zip(flat[0::3], flat[1::3], flat[2::3]):
                u = [q - p for p, q in zip(positions[a], positions[b])]
                v = [q - p for p, q in zip(positions[a], positions[c])]
                for corner in (a, b, c):
                    self.assertGreater(dot(cross(u, v), normals[corner]), 0)

    def test_has_every_shape(self):
        document = self.glb.document
        shapes = {(light["type"], light.get("caps")) for node in self.nodes.values()
                  for light in [node.get("extras", {}).get("openltc_light")] if light}
        self.assertEqual(shapes, {("disk", None), ("ellipse", None), ("sphere", None),
                                  ("tube", "none"), ("tube", "flat"), ("tube", "round"),
                                  ("line", None), ("point", None)})
        extensions = document["extensions"]
        self.assertEqual([l["type"] for l in extensions["EXT_lights_area"]["lights"]], ["rect"] * 2)
        self.assertEqual([l["type"] for l in extensions["KHR_lights_punctual"]["lights"]],
                         ["spot", "directional"])
        self.assertGreater(extensions["KHR_lights_punctual"]["lights"][0]["range"], 0)
        self.assertTrue(os.path.isfile(os.path.join(
            os.path.dirname(k_scene), self.extras_light("luminaire")["ies"])))
        # The star and the window are lights by their emissive meshes, the window with a picture.
        emissive = [document["materials"][document["meshes"][self.nodes[name]["mesh"]]
                                          ["primitives"][0]["material"]] for name in ("star", "window")]
        self.assertTrue(all(any(m["emissiveFactor"]) for m in emissive))
        self.assertNotIn("emissiveTexture", emissive[0])
        self.assertIn("emissiveTexture", emissive[1])

    def test_meshes_have_the_sizes_of_their_lights(self):
        def reach(name, axis):
            return max(abs(p[axis]) for p in self.positions(name))

        self.assertAlmostEqual(reach("sphere", 0), self.extras_light("sphere")["radius"], delta=2e-3)
        for name in ("disk", "ellipse"):
            light = self.extras_light(name)
            self.assertAlmostEqual(reach(name, 0), light.get("radius", light.get("radius_x")), delta=1e-6)
            self.assertAlmostEqual(reach(name, 1), light.get("radius", light.get("radius_y")), delta=1e-3)
        for name in ("open tube", "flat tube", "capsule"):
            light = self.extras_light(name)
            half = light["length"] / 2 + (light["radius"] if light["caps"] == "round" else 0)
            self.assertAlmostEqual(reach(name, 0), half, delta=1e-6)
            self.assertAlmostEqual(reach(name, 1), light["radius"], delta=1e-6)

    def test_the_line_is_as_bright_as_its_mesh(self):
        light = self.extras_light("line")
        material = self.glb.document["materials"][self.glb.document["meshes"][
            self.nodes["line"]["mesh"]]["primitives"][0]["material"]]
        luminance = material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"]
        radius = max(p[1] for p in self.positions("line"))
        self.assertAlmostEqual(light["intensity_candela"], 2 * radius * light["length"] * luminance,
                               delta=1e-3 * light["intensity_candela"])

    def test_extensions_are_used(self):
        text = json.dumps({k: v for k, v in self.glb.document.items() if k != "extensionsUsed"})
        for extension in self.glb.document["extensionsUsed"]:
            self.assertIn('"%s"' % extension, text)


if __name__ == "__main__":
    unittest.main()
