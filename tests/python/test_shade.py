# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Light over arrays, against quadrature over the light in NumPy."""

import math
import unittest

import numpy as np
import openltc
from openltc import Material

k_lamp = dict(center=(0.2, 1.0, -0.3), half_u=(0.5, 0, 0), half_v=(0, 0.1, 0.4), radiance_nits=(100, 50, 10))


def rectangle_points(n=48):
    """Points of the lamp by Gauss and Legendre, their weights in m2 times nits of the first channel, and its
    normal."""
    x, w = np.polynomial.legendre.leggauss(n)
    c, u, v = (np.array(k_lamp[k]) for k in ("center", "half_u", "half_v"))
    points = c + x[:, None, None] * u + x[None, :, None] * v
    area = np.cross(u, v)
    weights = w[:, None] * w[None, :] * np.linalg.norm(area)
    return points.reshape(-1, 3), weights.reshape(-1), area / np.linalg.norm(area)


def reference(position, normal, view, material):
    """The integral of BRDF, radiance 1 and both cosines over the lamp."""
    points, weights, lamp_normal = rectangle_points()
    to = points - position
    distance = np.linalg.norm(to, axis=1)
    wi = to / distance[:, None]
    cosine = np.maximum(-(wi @ lamp_normal), 0)
    value = openltc.eval(normal, view, material, wi)[:, 0]
    return float(np.sum(value * cosine / distance**2 * weights))


def points_on_floor(n, seed=7):
    random = np.random.default_rng(seed)
    positions = random.uniform(-1, 1, (n, 3)).astype(np.float32)
    positions[:, 1] = 0
    views = random.normal(size=(n, 3)).astype(np.float32)
    views[:, 1] = np.abs(views[:, 1]) + 0.3
    return positions, np.tile(np.float32([0, 1, 0]), (n, 1)), views


class Shading(unittest.TestCase):
    def test_diffuse_is_the_integral(self):
        # Lambert 1760 by quadrature; no specular reflection, so the albedo stays.
        material = Material(base_color=(0.5, 0.5, 0.5), specular=0.0)
        positions, normals, views = points_on_floor(20)
        got = openltc.shade(positions, normals, views, material, openltc.Rectangle(**k_lamp))
        points, weights, lamp_normal = rectangle_points()
        for position, radiance in zip(positions, got):
            to = points - position
            squared = np.sum(to * to, axis=1)
            expected = np.sum(0.5 / math.pi * weights * to[:, 1] * np.maximum(-(to @ lamp_normal), 0) / squared**2)
            np.testing.assert_allclose(radiance, expected * np.array(k_lamp["radiance_nits"]), rtol=2e-4)

    def test_specular_is_the_integral_within_the_error_of_lobes(self):
        # The mean error of the lobes in light, and of two lobes less.
        material = Material(base_color=(0.9, 0.9, 0.9), metallic=1.0, roughness=0.5)
        positions, normals, views = points_on_floor(60)
        expected = np.array([reference(p, n, v, material) for p, n, v in zip(positions, normals, views)])
        error = {}
        for lobes in ("table", "two-lobe"):
            got = openltc.shade(positions, normals, views, material, openltc.Rectangle(**k_lamp), lobes=lobes)
            error[lobes] = np.abs(got[:, 0] / 100 - expected).sum() / expected.sum()
        self.assertLess(error["table"], 0.06)
        self.assertLess(error["two-lobe"], error["table"])

    def test_samples_estimate_the_same(self):
        material = Material(base_color=(0.8, 0.4, 0.2), roughness=0.6)
        u = (np.random.default_rng(3).permuted(np.arange(2 * 4096).reshape(2, -1) % 4096, axis=1).T + 0.5) / 4096
        normal, view = np.array([0, 0, 1.0]), np.array([0.6, 0, 0.8])
        wi, value, density, counts = openltc.sample(normal, view, material, u)
        estimate = np.where(counts[:, None], value / np.where(counts, density, 1)[:, None], 0).mean(axis=0)
        # The albedo by quadrature over the hemisphere.
        x, w = np.polynomial.legendre.leggauss(64)
        z, phi = 0.5 * (x + 1), 2 * np.pi * (np.arange(128) + 0.5) / 128
        s = np.sqrt(1 - z * z)
        grid = np.stack(np.broadcast_arrays(s[:, None] * np.cos(phi), s[:, None] * np.sin(phi), z[:, None]), -1)
        full = openltc.eval(normal, view, material, grid)
        albedo = np.einsum("i,ijc->c", 0.5 * w, full) * 2 * np.pi / 128
        np.testing.assert_allclose(estimate, albedo, rtol=0.02)
        np.testing.assert_allclose(openltc.pdf(normal, view, material, wi)[counts], density[counts], rtol=1e-3)
        # The density is one.
        total = (0.5 * w[:, None] * openltc.pdf(normal, view, material, grid)).sum() * 2 * np.pi / 128
        self.assertAlmostEqual(total, 1.0, delta=0.02)

    def test_every_light_arrives(self):
        # Candela over squared metres, and lux, by hand: E/pi of albedo 1.
        white = Material(base_color=(1, 1, 1), specular=0.0)
        down = (0, -1, 0)
        for light, lux in (
            (openltc.Point((0, 2, 0), 8.0), 2.0),
            (openltc.Spot((0, 2, 0), down, 8.0, 10.0, 20.0), 2.0),
            (openltc.Directional(down, 2.0), 2.0),
            (openltc.Sphere((0, 2, 0), 0.5, 10.0), 10.0 * math.pi * 0.25 / 4),
            (openltc.Disk((0, 2, 0), down, 0.5, 10.0), 10.0 * math.pi * 0.25 / 4.25),
            (openltc.Ellipse((0, 2, 0), (0.5, 0, 0), (0, 0, 0.5), 10.0, two_sided=True), 10.0 * math.pi * 0.25 / 4.25),
            (openltc.Line((-1e-3, 2, 0), (1e-3, 2, 0), 1000.0), 2e-3 * 1000 / 4),
            (openltc.Tube((-1e-3, 2, 0), (1e-3, 2, 0), 1e-4, 1000.0 / 2e-4, caps="none"), 2e-3 * 1000 / 4),
            (openltc.Polygon([(0.01, 2, 0.01), (-0.01, 2, 0.01), (-0.01, 2, -0.01), (0.01, 2, -0.01)],
                             1e4, two_sided=True), 4e-4 * 1e4 / 4),
        ):
            with self.subTest(type(light).__name__):
                got = openltc.shade([[0, 0, 0]], [0, 1, 0], [0, 1, 0], white, light)
                np.testing.assert_allclose(got, np.full((1, 3), lux / math.pi), rtol=2e-3)

    def test_directions_for_any_brdf_have_their_densities(self):
        # The mean of f cos over the density is the albedo, and the density the share that counts; both by quadrature.
        side = (np.arange(128) + 0.5) / 128
        u = np.stack(np.meshgrid(side, side), -1).reshape(-1, 2)
        nodes, weights = np.polynomial.legendre.leggauss(200)
        theta, phi = np.meshgrid((nodes + 1) * np.pi / 4, (np.arange(180) + 0.5) * np.pi / 90, indexing="ij")
        solid_angle = (weights * np.pi / 4)[:, None] * np.sin(theta) * np.pi / 90
        around = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], -1)
        for name, cosine, roughness in (("ggx", 0.9, 0.4), ("burley", 0.5, 0.6), ("charlie", 0.3, 1.0)):
            with self.subTest(name):
                brdf, wo = openltc.Brdf(name), np.array([np.sqrt(1 - cosine**2), 0, cosine])
                albedo = (brdf.parts(wo, around, roughness)[0] * solid_angle).sum()
                wi, density = brdf.sample(np.broadcast_to(wo, (len(u), 3)), roughness, u)
                value = brdf.parts(wo, wi.astype(float), roughness)[0]
                mean = np.divide(value, density, out=np.zeros(len(u)), where=density > 0).mean()
                self.assertLess(abs(mean - albedo), 0.005 * albedo)
                drawn = brdf.pdf(np.broadcast_to(wo, around.shape), around, roughness)
                self.assertLess(abs((drawn * solid_angle).sum() - (density > 0).mean()), 0.002)

    def test_parts_add_up(self):
        positions, normals, views = points_on_floor(50)
        arguments = positions, normals, views, Material(roughness=0.4), openltc.Rectangle(**k_lamp)
        diffuse, specular = openltc.shade_parts(*arguments)
        np.testing.assert_allclose(diffuse + specular, openltc.shade(*arguments), rtol=1e-3, atol=1e-4)


class Arrays(unittest.TestCase):
    def test_any_layout_gives_the_same(self):
        positions, normals, views = points_on_floor(60)
        lamp, material = openltc.Rectangle(**k_lamp), Material(roughness=0.4)
        expected = openltc.shade(positions, normals, views, material, lamp)
        structs = np.zeros(60, [("id", "i4"), ("position", "f4", 3), ("rest", "f8")])
        structs["position"] = positions
        read_only = positions.copy()
        read_only.flags.writeable = False
        for other in (structs["position"], np.asfortranarray(positions), positions[::-1][::-1], read_only,
                      positions.astype(">f4"), positions.astype(np.float64), positions.tolist(),
                      np.repeat(positions, 2, axis=0)[::2]):
            np.testing.assert_array_equal(openltc.shade(other, normals, views, material, lamp), expected)
        np.testing.assert_array_equal(openltc.shade(positions, [0, 1, 0], views, material, [lamp]), expected)
        grid = [a.reshape(6, 10, 3) for a in (positions, normals, views)]
        np.testing.assert_array_equal(openltc.shade(*grid, material, lamp), expected.reshape(6, 10, 3))
        each = Material(roughness=np.full((6, 10), 0.4), base_color=np.ones((6, 10, 3)))
        np.testing.assert_array_equal(openltc.shade(*grid, each, lamp), expected.reshape(6, 10, 3))
        out = np.empty((6, 10, 3), np.float32)
        self.assertIs(openltc.shade(*grid, material, lamp, out=out, threads=1), out)
        np.testing.assert_array_equal(out, expected.reshape(6, 10, 3))

    def test_parts_of_long_arrays_meet(self):
        n = (1 << 20) + 3
        positions = np.zeros((n, 3), np.float32)
        positions[:, 0] = np.linspace(-1, 1, n)
        roughness = np.linspace(0.1, 1, n)
        got = openltc.shade(positions, [0, 1, 0], [0, 1, 1], Material(roughness=roughness), openltc.Rectangle(**k_lamp))
        for i in (0, (1 << 20) - 1, 1 << 20, n - 1):
            one = openltc.shade(positions[i], [0, 1, 0], [0, 1, 1], Material(roughness=roughness[i]),
                                openltc.Rectangle(**k_lamp))
            np.testing.assert_array_equal(got[i], one)

    def test_empty_and_unusable(self):
        empty = np.empty((0, 3))
        self.assertEqual(openltc.shade(empty, empty, empty).shape, (0, 3))
        self.assertEqual(openltc.shade(np.empty((4, 0, 3)), [0, 1, 0], [0, 1, 1]).shape, (4, 0, 3))
        far = np.full((2, 3), 1e300)
        np.testing.assert_array_equal(openltc.shade(far, [0, 1, 0], [0, 1, 1], None, openltc.Rectangle(**k_lamp)), 0)
        bad = openltc.shade([[np.nan, 0, 0], [0, 0, 0]], [[0, 1, 0], [0, 0, 0]], [0, 1, 0], None,
                            openltc.Rectangle(**k_lamp))
        np.testing.assert_array_equal(bad, 0)

    def test_faults_are_told(self):
        ok = np.zeros((4, 3), np.float32)
        lamp = openltc.Rectangle(**k_lamp)
        for error, words, call in (
            (ValueError, "normals: .*\\(4, 3\\) is wanted", lambda: openltc.shade(ok, ok[:2], ok)),
            (ValueError, "positions: .*\\(..., 3\\)", lambda: openltc.shade(ok[:, :2], ok, ok)),
            (TypeError, "positions: complex", lambda: openltc.shade(ok + 1j, ok, ok)),
            (TypeError, "positions: numbers", lambda: openltc.shade(np.full((4, 3), "a"), ok, ok)),
            (ValueError, "roughness", lambda: openltc.shade(ok, ok, ok, Material(roughness=np.ones(3)))),
            (TypeError, "material", lambda: openltc.shade(ok, ok, ok, 3, lamp)),
            (TypeError, r"lights\[1\]", lambda: openltc.shade(ok, ok, ok, None, [lamp, 3])),
            (openltc.Error, r"lights\[0\], Sphere: radius", lambda: openltc.shade(ok, ok, ok, None, openltc.Sphere((0, 0, 0), -1, 1))),
            (openltc.Error, "radiance is negative", lambda: openltc.shade(ok, ok, ok, None, openltc.Sphere((0, 0, 0), 1, -1))),
            (ValueError, "out: ", lambda: openltc.shade(ok, ok, ok, None, lamp, out=np.empty((4, 3)))),
            (ValueError, "out: .*memory", lambda: openltc.shade(ok, ok, ok, None, lamp, out=ok)),
            (ValueError, "lobes=", lambda: openltc.shade(ok, ok, ok, None, lamp, lobes="best")),
            (TypeError, "threads='two'", lambda: openltc.shade(ok, ok, ok, None, lamp, threads="two")),
            (ValueError, "threads=-1", lambda: openltc.shade(ok, ok, ok, None, lamp, threads=-1)),
            (TypeError, "lights: .*NoneType", lambda: openltc.shade(ok, ok, ok, None, None)),
            (TypeError, "Point: intensity_candela=None", lambda: openltc.shade(ok, ok, ok, None, openltc.Point((0, 1, 0), None))),
            (ValueError, "inner_angle_degrees", lambda: openltc.shade(ok, ok, ok, None, openltc.Spot((0, 1, 0), (0, -1, 0), 1, 50, 20))),
            (openltc.Error, "u: ", lambda: openltc.Lobes().sample(0.5, 0.5, [[1.5, np.nan]])),
        ):
            with self.subTest(words):
                self.assertRaisesRegex(error, words, call)


class Lobes(unittest.TestCase):
    def test_density_is_one_and_samples_follow_it(self):
        x, w = np.polynomial.legendre.leggauss(200)
        phi = 2 * np.pi * (np.arange(400) + 0.5) / 400
        s = np.sqrt(1 - x * x)
        sphere = np.stack(np.broadcast_arrays(s[:, None] * np.cos(phi), s[:, None] * np.sin(phi), x[:, None]), -1)
        u = np.random.default_rng(5).random((40000, 2))
        for source in ("table", "two-lobe"):
            lobes = openltc.Lobes(source)
            density = lobes.eval(0.7, 0.6, sphere)
            measure = w[:, None] * density * 2 * np.pi / 400
            self.assertAlmostEqual(measure.sum(), 1, delta=1e-3)
            mean = np.einsum("ij,ijk->k", measure, sphere)
            np.testing.assert_allclose(lobes.sample(0.7, 0.6, u).mean(axis=0), mean, atol=0.02)

    def test_own_fit_shades_as_the_built_in(self):
        positions, normals, views = points_on_floor(30)
        lamp = openltc.Rectangle(**k_lamp)
        own = openltc.shade(positions, normals, views, Material(roughness=0.5), lamp, lobes=openltc.fit("ggx"))
        np.testing.assert_allclose(own, openltc.shade(positions, normals, views, Material(roughness=0.5), lamp), rtol=1e-6)
        with self.assertRaisesRegex(openltc.Error, "narrow"):
            openltc.Lobes(openltc.fit("charlie", size=12))

    def test_brdf_by_name(self):
        # Lambert's part of EON at roughness 0 is the only one: f = albedo 1 / pi.
        f = openltc.Brdf("oren-nayar")
        np.testing.assert_allclose(f([[0, 0, 1.0]], [[0.6, 0, 0.8]], 0.0), [1 / np.pi], rtol=1e-6)
        np.testing.assert_array_equal(f([0, 0, 1.0], [[0.6, 0, -0.8], [0, 0, 1]], 0.5)[0], 0)
        self.assertRaisesRegex(openltc.Error, "not known", lambda: openltc.Brdf("gold"))
