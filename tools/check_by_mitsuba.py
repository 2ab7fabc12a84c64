#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Renders scenes/hard/floor_sphere_45.glb by Mitsuba 3 and says how far a picture is from that.

    tools/check_by_mitsuba.py REFERENCE.exr [SAMPLES]

REFERENCE.exr is a picture of that scene, unshadowed, through the middle of each pixel:

    openltc render scenes/hard/floor_sphere_45.glb --integrator reference --samples 4096 \\
        --size 192x108 --shadow-samples 0 --filter none -o REFERENCE.exr

The scene is written down here a second time. Mitsuba's camera, sphere and sampling of the sphere are
its own, and so are D and the Smith G1 of its GGX; its G2 is separable, so the height-correlated one is
made of the two G1 (Heitz 2014, equation 99): 1 / (1 / G1(o) + 1 / G1(i) - 1). F = 1. SAMPLES (8192)
are points of the light per pixel, all seen through the middle of the pixel. Needs `pip install mitsuba
numpy` and LLVM (DRJIT_LIBLLVM_PATH; 19.1 works, 15 fails on AVX-512).
"""

import sys

import drjit as dr
import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_mono")

k_alpha = 0.45 ** 2
k_samples_of_pass = 128


class CorrelatedGgx(mi.BSDF):
    """The metal; only what a direct integrator that samples lights asks for."""

    def __init__(self, props):
        mi.BSDF.__init__(self, props)
        flags = mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.FrontSide
        self.m_components = [flags]
        self.m_flags = flags

    def sample(self, ctx, si, sample1, sample2, active):
        return dr.zeros(mi.BSDFSample3f), mi.Spectrum(0)

    def eval(self, ctx, si, wo, active):
        cos_o, cos_i = mi.Frame3f.cos_theta(si.wi), mi.Frame3f.cos_theta(wo)
        ggx = mi.MicrofacetDistribution(mi.MicrofacetType.GGX, k_alpha, False)
        h = dr.normalize(wo + si.wi)
        g2 = 1 / (1 / ggx.smith_g1(si.wi, h) + 1 / ggx.smith_g1(wo, h) - 1)
        value = ggx.eval(h) * g2 / (4 * cos_o)  # times cos_i, as Mitsuba wants it
        return mi.Spectrum(dr.select(active & (cos_o > 0) & (cos_i > 0), value, 0))

    def pdf(self, ctx, si, wo, active):
        return mi.Float(0)

    def eval_pdf(self, ctx, si, wo, active):
        return self.eval(ctx, si, wo, active), mi.Float(0)


def rendered(width, height, samples):
    mi.register_bsdf("correlated_ggx", CorrelatedGgx)
    to_world = mi.ScalarTransform4f
    scene = mi.load_dict({
        "type": "scene",
        "integrator": {"type": "direct", "emitter_samples": k_samples_of_pass, "bsdf_samples": 0,
                       "hide_emitters": True},
        "floor": {"type": "rectangle", "bsdf": {"type": "correlated_ggx"},
                  "to_world": to_world().translate([0, 0, -35]).rotate([1, 0, 0], -90).scale([40, 45, 1])},
        "light": {"type": "sphere", "center": [0.3, 0.6, -6.0], "radius": 0.35,
                  "emitter": {"type": "area", "radiance": {"type": "spectrum", "value": 1000.0}}},
        "sensor": {"type": "perspective", "fov": 23.5, "fov_axis": "y", "near_clip": 0.01,
                   "to_world": to_world().translate([0, 1.2, 0]).rotate([1, 0, 0], -13.25).rotate([0, 1, 0], 180),
                   "film": {"type": "hdrfilm", "width": width, "height": height, "pixel_format": "luminance",
                            "component_format": "float32", "rfilter": {"type": "box"}},
                   "sampler": {"type": "independent"}}})
    # One ray through the middle of each pixel, made by the sensor; so Mitsuba's integrator runs on it.
    index = dr.arange(mi.UInt32, width * height)
    place = mi.Point2f((mi.Float(index % width) + 0.5) / width, (mi.Float(index // width) + 0.5) / height)
    ray, _ = scene.sensors()[0].sample_ray_differential(0, 0, place, mi.Point2f(0.5))
    sampler = mi.load_dict({"type": "independent"})
    passes = max(samples // k_samples_of_pass, 1)
    light = np.zeros(width * height)
    for seed in range(passes):
        sampler.seed(seed, width * height)
        value, _, _ = scene.integrator().sample(scene, sampler, ray)
        light += np.array(value[0]) / passes
    hit = scene.ray_intersect(ray)
    # Where the lamp stands before the floor Mitsuba shows neither.
    floor = np.array(hit.is_valid() & (hit.emitter(scene) == None)).reshape(height, width)  # noqa: E711
    return light.reshape(height, width), floor


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    layers = dict(mi.Bitmap(sys.argv[1]).split())
    other = np.array(layers["<root>"])[:, :, 0]  # grey in all three channels
    height, width = other.shape
    samples = int(sys.argv[2]) if len(sys.argv) == 3 else 8192
    truth, floor = rendered(width, height, samples)
    truth, other = truth[floor], other[floor]
    print("%d of %d pixels show the floor" % (floor.sum(), floor.size))
    print("mean %.6g, Mitsuba %.6g nits (%+.3f %%)" % (
        other.mean(), truth.mean(), 100 * (other.mean() / truth.mean() - 1)))
    print("sum of differences: %.3f %% of the light" % (100 * abs(other - truth).sum() / truth.sum()))
    lit = truth > 0.01 * truth.mean()
    relative = abs(other - truth)[lit] / truth[lit]
    print("relative over lit pixels: median %.2f %%, p95 %.2f %%" % (
        100 * np.median(relative), 100 * np.quantile(relative, 0.95)))


main()
