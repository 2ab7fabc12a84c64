// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The ratio of the BRDF to the lobe in a light's mean direction: against GGX itself, integrated
// over the lights by midpoints, in double precision.

#include "placed_lights.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace openltc;
using namespace openltc::testing;

namespace {

constexpr double k_pi = std::numbers::pi;

// One lobe, without a diffuse part.
f64::Surface surface(double theta, double roughness, double f0 = 1) {
  return surface_of_form(LightForm::lobe, theta, roughness, f0);
}

PlacedLight line(Placed at) { return k_placed_shapes[3].make(at); }

struct Errors {
  double of_light = 0; // sum of errors over the sum of light
  double median = 0;   // of relative errors
};

Errors errors(const std::vector<double>& found, const std::vector<double>& exact) {
  double error = 0, sum = 0;
  std::vector<double> relative;
  for (std::size_t i = 0; i < found.size(); ++i) {
    error += std::abs(found[i] - exact[i]);
    sum += exact[i];
    if (exact[i] > 1e-6) relative.push_back(std::abs(found[i] - exact[i]) / exact[i]);
  }
  std::nth_element(relative.begin(), relative.begin() + std::ptrdiff_t(relative.size() / 2),
                   relative.end());
  return {error / sum, relative[relative.size() / 2]};
}

} // namespace

TEST_CASE("ratio at the mean direction: an area light that shrinks becomes the exact point light") {
  for (const LightForm form : {LightForm::ratio, LightForm::two_lobes_ratio})
    for (const PlacedShape& shape : k_placed_shapes) {
      CAPTURE(std::string(shape.name));
      Random random(7);
      double worst = 0;
      for (int i = 0; i < 300; ++i) {
        const f64::Surface s = surface_of_form(form, random.uniform(0, 1.5), random.uniform(0.1, 1),
                                               i % 2 ? 1.0 : 0.04);
        const Placed at = random_place(0.004, random);
        const PlacedLight light = shape.make(at);
        const double exact = light.exact(s, 80);
        // Where the lobes have nothing, beyond their horizons, there is nothing to correct.
        const double density = f64::eval_lobes(s, f64::to_shading(s.frame, normalize(at.center)));
        if (exact < 1e-9 || density < 1e-4 || at.center.z < 0.1) continue;
        worst = std::max(worst, std::abs(light.shade(s) - exact) / exact);
      }
      MESSAGE(std::string(shape.name), ": ", worst);
      CHECK(worst < 3e-3); // sizes of 0.002 of the distance, lobes that turn by a few times that
    }
}

TEST_CASE(
    "ratio at the mean direction: errors of lights of every shape and size, halved at least") {
  struct Size {
    double size, of_light, median; // bounds a fifth above what is measured
  };
  // A light at twice its size; as wide as half the distance; a quarter; a tenth.
  for (const Size& size : {Size{2, 0.032, 0.027}, Size{1, 0.031, 0.022}, Size{0.5, 0.02, 0.008},
                           Size{0.2, 0.015, 0.0016}}) {
    for (const PlacedShape& shape : k_placed_shapes) {
      Random random(17);
      std::vector<double> plain, corrected, exact;
      for (int i = 0; i < 160; ++i) {
        const f64::Surface s = surface(random.uniform(0, 1.56), random.uniform(0.1, 1));
        const PlacedLight light = shape.make(random_place(size.size, random));
        const double truth = light.exact(s, 160);
        if (truth < 1e-7) continue;
        exact.push_back(truth);
        plain.push_back(light.shade(s));
        corrected.push_back(light.shade(f64::correct_at_mean(s)));
      }
      const Errors before = errors(plain, exact), after = errors(corrected, exact);
      CAPTURE(size.size);
      CAPTURE(std::string(shape.name));
      MESSAGE(std::string(shape.name), " of size ", size.size, ": ", 100 * before.of_light, " to ",
              100 * after.of_light, " % of the light, median ", 100 * before.median, " to ",
              100 * after.median, " %");
      CHECK(after.of_light < size.of_light);
      CHECK(after.median < size.median);
      CHECK(after.of_light < before.of_light);
      CHECK(after.median < 0.7 * before.median);
    }
  }
}

TEST_CASE(
    "ratio at the mean direction: a line low over a glossy dielectric, down to the floor itself") {
  Random random(23);
  for (const double height : {0.01, 0.0}) {
    std::vector<double> plain, corrected, exact;
    for (int i = 0; i < 200; ++i) {
      const f64::Surface s = surface(random.uniform(1, 1.5), 0.3, 0.04);
      const double turn = random.uniform(0, 2 * k_pi), away = random.uniform(0.05, 2);
      const Vec3d out(std::cos(turn), std::sin(turn), 0), along(-out.y, out.x, 0);
      Placed at;
      at.center = out * away + along * random.uniform(-1, 1) + Vec3d(0, 0, height);
      at.u = along * 0.5;
      at.v = Vec3d(0, 0, 1);
      const PlacedLight light = line(at);
      exact.push_back(light.exact(s, 400));
      plain.push_back(light.shade(s));
      corrected.push_back(light.shade(f64::correct_at_mean(s)));
    }
    if (height > 0) {
      const Errors before = errors(plain, exact), after = errors(corrected, exact);
      MESSAGE("1 cm over the floor: ", 100 * before.of_light, " to ", 100 * after.of_light,
              " % of the light");
      CHECK(before.of_light > 0.2);
      CHECK(after.of_light < 0.03);
    } else {
      for (const double light : corrected)
        CHECK(light < 1e-9);
    }
  }
}
