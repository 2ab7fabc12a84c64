# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Pictures of scenes equal the tool's; their lights, cameras and materials can be changed."""

import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import openltc

k_demo = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scenes", "demo.glb")
k_small = dict(width=64, height=36, samples=2, shadow_samples=2)


def dark_surfaces(scene):
    """Lamps are seen as well as they light: here only what they light counts."""
    for material in scene.materials:
        material.emission_nits = (0, 0, 0)
    return scene


class Scenes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = openltc.Scene.load(k_demo)
        cls.before = cls.scene.render(**k_small)

    def fresh(self):
        """The scene as the file has it."""
        self.scene.__init__(self.scene._lower)
        return self.scene

    def test_picture_is_the_tools(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.exr")
            for options, more in (((), {}), (("--integrator", "reference"), {"integrator": "reference"})):
                subprocess.run([os.environ["OPENLTC"], "render", k_demo, "--size", "64x36", "--samples", "2",
                                "--shadow-samples", "2", "-o", path, "--quiet", *options], check=True)
                got = self.fresh().render(**k_small, **more)
                np.testing.assert_array_equal(got, openltc.read(path))
                if more:
                    np.testing.assert_array_equal(got.layers["stderr"], openltc.read(path, "stderr"))
                    again = os.path.join(folder, "b.exr")
                    got.save(again)
                    np.testing.assert_array_equal(openltc.read(again, "stderr"), got.layers["stderr"])

    def test_lights_are_the_callers(self):
        scene = self.fresh()
        np.testing.assert_array_equal(scene.render(**k_small), self.before)
        once = dark_surfaces(scene).render(**k_small)
        scene.scale_lights(2)
        twice = scene.render(**k_small)
        np.testing.assert_allclose(twice.mean(), 2 * once.mean(), rtol=0.02)
        kept = scene.lights.pop()
        self.assertLess(scene.render(**k_small).mean(), twice.mean())
        scene.lights.append(kept)
        np.testing.assert_array_equal(scene.render(**k_small), twice)

    def test_own_lights_light_scenes(self):
        # One lamp of each shape, and one of twice the light.
        scene = dark_surfaces(self.fresh())
        for light in (openltc.Rectangle((0, 3, 0), (0.3, 0, 0), (0, 0, 0.3), 1000.0), openltc.Point((0, 3, 0), 100.0),
                      openltc.Disk((0, 3, 0), (0, -1, 0), 0.3, 1000.0), openltc.Sphere((0, 3, 0), 0.3, 1000.0),
                      openltc.Tube((-0.3, 3, 0), (0.3, 3, 0), 0.1, 1000.0), openltc.Line((-0.3, 3, 0), (0.3, 3, 0), 100.0),
                      openltc.Ellipse((0, 3, 0), (0.3, 0, 0), (0, 0, 0.2), 1000.0), openltc.Directional((0, -1, 0), 10.0),
                      openltc.Spot((0, 3, 0), (0, -1, 0), 100.0)):
            with self.subTest(type(light).__name__):
                scene.lights[:] = [light]
                one = scene.render(**{**k_small, "shadow_samples": 0}, lights="scene")
                self.assertGreater(one.mean(), 0)
                scene.scale_lights(2)
                two = scene.render(**{**k_small, "shadow_samples": 0}, lights="scene")
                self.assertAlmostEqual(float(two.mean() / one.mean()), 2, delta=0.05)

    def test_materials_and_cameras(self):
        scene = dark_surfaces(self.fresh())
        for material in scene.materials:
            material.base_color = (0, 0, 0, 1)
            material.specular, material.metallic = 0.0, 0.0
        dark = scene.render(**k_small)
        self.assertLess(np.median(dark), 0.02 * np.median(self.before))
        camera = scene.camera()
        self.assertAlmostEqual(camera.fov_y_rad, scene.cameras[0].fov_y_rad)
        fresh = self.fresh()
        np.testing.assert_array_equal(fresh.render(**k_small, camera=camera), self.before)
        camera.fov_y_rad *= 0.5
        self.assertFalse(np.array_equal(fresh.render(**k_small, camera=camera), self.before))
        framed = scene.camera("auto", aspect=64 / 36)
        self.assertNotEqual(framed.position, scene.camera().position)
        np.testing.assert_array_equal(fresh.render(**k_small, camera="auto"), fresh.render(**k_small, camera=framed))

    def test_faults_are_told(self):
        scene = self.fresh()
        for words, call in (
            ("not/there.glb", lambda: openltc.Scene.load("not/there.glb")),
            ("integrator=magic: choose", lambda: scene.render(**k_small, integrator="magic")),
            ("lobes=best", lambda: scene.render(**k_small, lobes="best")),
            ("camera", lambda: scene.render(**k_small, camera="nobody")),
            ("", lambda: scene.render(width=0)),
            ("a.tiff: .*.exr", lambda: self.before.save("a.tiff")),
            ("not/there.exr", lambda: openltc.read("not/there.exr")),
            ("1 to 65,535 pixels", lambda: openltc.compare(np.empty((0, 0, 3)), np.empty((0, 0, 3)))),
            ("differ in size", lambda: openltc.compare(self.before, self.before[:9])),
        ):
            with self.subTest(words):
                self.assertRaisesRegex(openltc.Error, words, call)
        for words, option in (("width='a'", {"width": "a"}), ("seed=1.5", {"seed": 1.5}), ("camera=None", {"camera": None}),
                              ("window", {"window": "abcd"}), ("threads=-1", {"threads": -1}),
                              ("integrator=3", {"integrator": 3})):
            with self.subTest(words):
                self.assertRaisesRegex((TypeError, ValueError), words, lambda: scene.render(**{**k_small, **option}))
        # Fields that were set: what would crash, or make a picture of NaN.
        nan = float("nan")
        for words, part, field, value in (
            ("radiance_nits is -1", scene.lights[0], "radiance_nits", (-1, 0, 0)),
            ("vertices is inf", scene.lights[0], "vertices", [(float("inf"), 0, 0)] * 4),
            ("ring_ends", scene.lights[0], "ring_ends", [3]),
            ("ring_ends", scene.lights[0], "vertices", []),
            ("normal is not of length 1", scene.lights[0], "normal", (0, 0, 0)),
            (r"materials\[1\], .*emission_nits is nan", scene.materials[1], "emission_nits", (nan, 0, 0)),
            (r"materials\[1\], .*roughness is nan", scene.materials[1], "roughness", nan),
            ("camera: fov_y_rad is nan", scene.cameras[0], "fov_y_rad", nan),
            ("camera: position is inf", scene.cameras[0], "position", (float("inf"), 0, 0)),
            ("camera: forward is not of length 1", scene.cameras[0], "forward", (0, 0, 0)),
            ("not at right angles", scene.cameras[0], "up", tuple(scene.cameras[0].forward)),
        ):
            with self.subTest(words):
                before = getattr(part, field)
                setattr(part, field, value)
                self.assertRaisesRegex(openltc.Error, words, lambda: scene.render(**k_small, camera=scene.cameras[0]))
                setattr(part, field, before)
        np.testing.assert_array_equal(scene.render(**k_small, camera=scene.cameras[0]), self.before)
        for words, part, field, value in (
            ("roughness='rough': a float is wanted", scene.materials[1], "roughness", "rough"),
            ("radiance_nits=3: a tuple is wanted", scene.lights[0], "radiance_nits", 3),
            ("two_sided=None: a bool is wanted", scene.lights[0], "two_sided", None),
            ("position=", scene.cameras[0], "position", (1, 2)),
        ):
            with self.subTest(words):
                self.assertRaisesRegex(TypeError, words, setattr, part, field, value)
        for field, value in (("lights", 3), ("lights", "lamp"), ("lights", ["lamp"]), ("materials", None), ("materials", ["wood"])):
            with self.subTest(field):
                before = getattr(scene, field)
                setattr(scene, field, value)
                self.assertRaisesRegex(TypeError, field + ".* is wanted", lambda: scene.render(**k_small))
                setattr(scene, field, before)

    def test_progress_and_ctrl_c(self):
        shares = []
        self.fresh().render(**k_small, progress=shares.append)
        self.assertEqual(shares[-1], 1.0)

        def stop(share):
            raise LookupError("enough")

        self.assertRaises(LookupError, lambda: self.scene.render(width=4096, height=2048, samples=64, progress=stop))


class Pictures(unittest.TestCase):
    def test_figures_by_hand(self):
        a = np.full((24, 32, 3), 0.5, np.float32)
        b = a.copy()
        b[0, 0] = 1.0
        result = openltc.compare(a, b)
        self.assertAlmostEqual(result["mse"], 0.25 / (24 * 32))
        self.assertEqual(result["max_abs_at"], (0, 0))
        self.assertEqual(result.flip_map.shape, (24, 32))
        self.assertEqual(openltc.compare(a, a)["flip"], 0)

    def test_figures(self):
        self.assertIn("<svg", openltc.plot.polygon(matrix="0.5,-0.6,0.3,0").svg)
        lobes = openltc.fit("ggx", size=8)
        self.assertIn("<svg", openltc.plot.error(lobes, norms=["tv"]).svg)
        self.assertIn("<svg", openltc.plot.fit(lobes, theta=[30], roughness=[0.5])._repr_svg_())
        self.assertRaises(openltc.Error, lambda: openltc.plot.polygon(brdf="gold"))
