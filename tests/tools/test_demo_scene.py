# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""scenes/demo.glb is what its script makes, byte for byte, and it is a valid glTF file."""

import json
import math
import os
import struct
import subprocess
import sys
import tempfile
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
k_scene = os.path.join(k_root, "scenes", "demo.glb")
k_components = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
k_formats = {5123: ("H", 2), 5126: ("f", 4)}


class Glb:
    def __init__(self, data):
        magic, version, length = struct.unpack_from("<4sII", data)
        json_length, json_kind = struct.unpack_from("<I4s", data, 12)
        assert (magic, version, length, json_kind) == (b"glTF", 2, len(data), b"JSON")
        assert json_length % 4 == 0
        self.document = json.loads(data[20:20 + json_length])
        start = 20 + json_length
        binary_length, binary_kind = struct.unpack_from("<I4s", data, start)
        assert binary_kind == b"BIN\0" and start + 8 + binary_length == len(data)
        self.binary = data[start + 8:]

    def values(self, index):
        accessor = self.document["accessors"][index]
        view = self.document["bufferViews"][accessor["bufferView"]]
        letter, size = k_formats[accessor["componentType"]]
        assert view["byteOffset"] % size == 0
        count = k_components[accessor["type"]]
        assert accessor["count"] * count * size == view["byteLength"]
        data = self.binary[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]
        return list(struct.iter_unpack("<%d%s" % (count, letter), data))

    def primitives(self):
        return [p for mesh in self.document["meshes"] for p in mesh["primitives"]]


class DemoScene(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with open(k_scene, "rb") as stream:
            cls.bytes = stream.read()
        cls.glb = Glb(cls.bytes)

    def test_script_makes_the_checked_in_file(self):
        with tempfile.TemporaryDirectory() as folder:
            again = os.path.join(folder, "demo.glb")
            subprocess.run([sys.executable, "-B", os.path.join(k_root, "tools/make_demo_scene.py"),
                            "-o", again], check=True, stdout=subprocess.DEVNULL)
            with open(again, "rb") as stream:
                self.assertTrue(stream.read() == self.bytes,
                                "scenes/demo.glb differs: run tools/make_demo_scene.py")

    def test_stays_small(self):
        self.assertLess(len(self.bytes), 3_000_000)

    def test_accessors_state_their_bounds(self):
        for index, accessor in enumerate(self.glb.document["accessors"]):
            columns = list(zip(*self.glb.values(index)))
            self.assertEqual(accessor["min"], [min(c) for c in columns])
            self.assertEqual(accessor["max"], [max(c) for c in columns])
            for column in columns:
                self.assertTrue(all(map(math.isfinite, column)))

    def test_buffer_views_neither_overlap_nor_leave_the_buffer(self):
        end = 0
        for view in self.glb.document["bufferViews"]:
            self.assertEqual(view["byteOffset"] % 4, 0)
            self.assertGreaterEqual(view["byteOffset"], end)
            end = view["byteOffset"] + view["byteLength"]
        self.assertLessEqual(end, self.glb.document["buffers"][0]["byteLength"])

    def test_directions_are_unit_and_triangles_face_their_normals(self):
        for primitive in self.glb.primitives():
            attributes = primitive["attributes"]
            positions = self.glb.values(attributes["POSITION"])
            normals = self.glb.values(attributes["NORMAL"])
            for n in normals:
                self.assertAlmostEqual(sum(x * x for x in n), 1, delta=1e-6)
            for k, t in enumerate(self.glb.values(attributes["TANGENT"])
                                  if "TANGENT" in attributes else []):
                self.assertAlmostEqual(sum(x * x for x in t[:3]), 1, delta=1e-6)
                self.assertAlmostEqual(sum(x * y for x, y in zip(t, normals[k])), 0, delta=1e-6)
                self.assertIn(t[3], (-1, 1))
            flat = [i for (i,) in self.glb.values(primitive["indices"])]
            self.assertEqual(len(flat) % 3, 0)
            for a, b, c in zip(flat[0::3], flat[1::3], flat[2::3]):
                u = [q - p for p, q in zip(positions[a], positions[b])]
                v = [q - p for p, q in zip(positions[a], positions[c])]
                cross = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                         u[0] * v[1] - u[1] * v[0])
                for corner in (a, b, c):
                    self.assertGreater(sum(x * y for x, y in zip(cross, normals[corner])), 0)

    def test_nothing_is_unused(self):
        document = self.glb.document
        used = {kind: set() for kind in ("accessors", "bufferViews", "images", "textures",
                                         "materials", "meshes", "nodes", "cameras")}
        for p in self.glb.primitives():
            used["accessors"] |= {p["indices"], *p["attributes"].values()}
            used["materials"].add(p["material"])
        used["bufferViews"] = {a["bufferView"] for a in document["accessors"]}
        used["bufferViews"] |= {i["bufferView"] for i in document["images"]}
        used["images"] = {t["source"] for t in document["textures"]}
        for m in document["materials"]:
            infos = [m.get("normalTexture")] + list(m["pbrMetallicRoughness"].values())
            used["textures"] |= {i["index"] for i in infos if isinstance(i, dict)}
        used["nodes"] = set(document["scenes"][0]["nodes"])
        used["meshes"] = {n["mesh"] for n in document["nodes"] if "mesh" in n}
        used["cameras"] = {n["camera"] for n in document["nodes"] if "camera" in n}
        for kind, indices in used.items():
            self.assertEqual(indices, set(range(len(document[kind]))), kind)
        text = json.dumps({k: v for k, v in document.items() if k != "extensionsUsed"})
        for extension in document["extensionsUsed"]:
            self.assertIn('"%s"' % extension, text)

    def test_has_five_lights_of_the_kinds_it_promises(self):
        document = self.glb.document
        emitters = [m for m in document["materials"] if any(m.get("emissiveFactor", []))]
        for material in emitters:
            strength = material["extensions"]["KHR_materials_emissive_strength"]
            self.assertTrue(1000 <= strength["emissiveStrength"] <= 10000)
        self.assertEqual(len(emitters), 3)
        self.assertEqual(len(document["extensions"]["EXT_lights_area"]["lights"]), 1)
        self.assertEqual([l["type"] for l in document["extensions"]["KHR_lights_punctual"]["lights"]],
                         ["point"])


if __name__ == "__main__":
    unittest.main()
