// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The reference's polygon lights by lobes: the mean is what it was, and the noise is less.

#include "openltc/light/light.h"
#include "openltc/render/renderer.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace openltc;

namespace {

/// Floor and spheres of a material under a rectangle and an L, one of which reaches nearly to the
/// floor.
scene::Scene lamp_room(const scene::Material& floor, const scene::Material& sphere) {
  scene::Scene scene;
  test::add_floor(scene, 20, 0, floor);
  test::add_sphere(scene, {0, 0.8f, 0}, 0.8f, sphere);
  scene.lights.polygons.push_back(test::ceiling_rectangle(-2, -1, 1, 2, 3, 10));
  scene.lights.polygons.push_back(
      test::ceiling_light({{{-4, -2}, {-2, -2}, {-2, 0}, {-3, 0}, {-3, 1}, {-4, 1}}}, 0.3f, 20));
  scene.cameras.push_back(test::look_at({0, 2.5f, 5}, {0, 0.7f, 0}, 0.7f));
  return scene;
}

render::RenderOptions reference_options(int samples) {
  render::RenderOptions options;
  options.width = 48;
  options.height = 36;
  options.filter = render::PixelFilter::none;
  options.integrator = render::Integrator::reference;
  options.samples = samples;
  options.shadow_samples = 0;
  return options;
}

/// The mean of a picture over seeds, and the mean of the variance of its pixels.
struct Spread {
  double mean = 0, mean_error = 0, variance = 0;
};

Spread spread_of(const scene::Scene& scene, render::RenderOptions options, int seeds) {
  std::vector<double> sum, square;
  for (int seed = 1; seed <= seeds; ++seed) {
    options.seed = std::uint32_t(seed);
    const render::Picture picture = test::rendered(scene, options);
    const std::vector<float>& data = picture.radiance.data;
    sum.resize(data.size());
    square.resize(data.size());
    for (std::size_t i = 0; i < data.size(); ++i) {
      sum[i] += double(data[i]);
      square[i] += double(data[i]) * double(data[i]);
    }
  }
  Spread spread;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const double mean = sum[i] / seeds;
    spread.mean += mean / double(sum.size());
    spread.variance +=
        std::max(square[i] / seeds - mean * mean, 0.0) * seeds / (seeds - 1) / double(sum.size());
  }
  // Pixels are independent, their three channels are not.
  spread.mean_error = std::sqrt(3 * spread.variance / (seeds * double(sum.size())));
  return spread;
}

} // namespace

TEST_CASE("by lobes the reference of a Lambertian floor has no noise but that of rounding") {
  // All the light of a polygon is its form factor, whose closed form is exact.
  scene::Scene scene;
  test::add_floor(scene, 20, 0, test::diffuse_material({0.5f, 0.4f, 0.3f}));
  scene.lights.polygons.push_back(test::ceiling_rectangle(-2, -1, 1, 2, 3, 10));
  scene.cameras.push_back(test::look_at({0, 2.5f, 5}, {0, 0, 0}, 0.7f));
  const render::RenderOptions options = reference_options(1);
  render::RenderOptions ltc = options;
  ltc.integrator = render::Integrator::ltc;
  const image::Image a = test::rendered(scene, options).radiance,
                     b = test::rendered(scene, ltc).radiance;
  double sum = 0, difference = 0;
  for (const float v : b.data)
    sum += double(v);
  const double mean = sum / double(b.data.size());
  int compared = 0, apart = 0;
  for (std::size_t i = 0; i < b.data.size(); ++i) {
    if (double(b.data[i]) < 0.1 * mean) continue;
    ++compared;
    const double relative = std::abs(double(a.data[i]) / double(b.data[i]) - 1);
    difference += relative;
    apart += relative > 1e-4 ? 1 : 0;
  }
  MESSAGE(compared << " values, off by " << difference / compared << " in the mean, " << apart
                   << " by more than 1e-4");
  CHECK(compared > 3000);
  CHECK(difference / compared < 5e-5);
  // Points that see a sliver of the light sample it by its solid angle.
  CHECK(apart < compared / 50);
}

TEST_CASE(
    "by lobes and by solid angle the reference has the same mean, and less variance by lobes") {
  struct Kind {
    std::string name;
    scene::Material floor, sphere;
    double gain; ///< of the variance, at least; half of what was measured
  };
  const Kind kinds[] = {
      {"dielectric", test::glossy_material({0.4f, 0.3f, 0.2f}, 0.5f, false),
       test::glossy_material({0.8f, 0.3f, 0.2f}, 0.2f, false), 5},
      {"metal", test::glossy_material({0.9f, 0.8f, 0.5f}, 0.6f, true),
       test::glossy_material({0.9f, 0.8f, 0.5f}, 0.25f, true), 2},
  };
  for (const Kind& kind : kinds) {
    CAPTURE(kind.name);
    const scene::Scene scene = lamp_room(kind.floor, kind.sphere);
    render::RenderOptions options = reference_options(16);
    const Spread lobes = spread_of(scene, options, 12);
    options.lobe_samples = false;
    const Spread solid_angle = spread_of(scene, options, 12);
    const double error = std::hypot(lobes.mean_error, solid_angle.mean_error);
    MESSAGE(kind.name << ": variance " << solid_angle.variance / lobes.variance
                      << " times less, means apart by " << (lobes.mean - solid_angle.mean) / error
                      << " standard errors, " << lobes.mean / solid_angle.mean - 1);
    CHECK(std::abs(lobes.mean - solid_angle.mean) < 4 * error);
    CHECK(error < 0.003 * lobes.mean);
    CHECK(solid_angle.variance > kind.gain * lobes.variance);
  }
}
