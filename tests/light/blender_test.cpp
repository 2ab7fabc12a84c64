// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Blender's watts against what its lights send, and against their inverse.

#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/units/blender.h"
#include "tests/light/light_patches.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace openltc;
using namespace openltc::light;
using namespace openltc::light::test;

constexpr double k_pi = std::numbers::pi;

TEST_CASE("blender_s_sphere_emits_its_watts_and_its_area_light_a_quarter_of_pi_of_them") {
  const double watts = 40;
  SphereLight sphere;
  sphere.radius = 0.2f;
  const double nits = *luminance_from_blender_sphere(watts, double(sphere.radius), 100);
  CHECK(summed_flux(patches_of(sphere), 0) * nits == doctest::Approx(watts * 100).epsilon(1e-3));
  CHECK(*blender_sphere_from_luminance(nits, double(sphere.radius), 100) == doctest::Approx(watts));

  // Seen from far away it is the point light that the exporter writes.
  const double standard =
      *gltf_intensity_from_blender(watts, PunctualType::point, GltfLightMode::standard);
  const double seen = summed_intensity(patches_of(sphere), 0, {0, 0, 1}) *
                      *luminance_from_blender_sphere(watts, double(sphere.radius));
  CHECK(seen == doctest::Approx(standard).epsilon(1e-3));

  EllipseLight disk;
  const double area_nits = *luminance_from_blender_area(watts, area(disk), 100);
  CHECK(summed_flux(patches_of(disk), 0) * area_nits ==
        doctest::Approx(watts * 100 * k_pi / 4).epsilon(1e-3));
  CHECK(*blender_area_from_luminance(area_nits, area(disk), 100) == doctest::Approx(watts));
}

TEST_CASE("the_exporter_s_modes_differ_by_efficacy_and_solid_angle") {
  const auto written = [](PunctualType type, GltfLightMode mode) {
    return *gltf_intensity_from_blender(10, type, mode);
  };
  CHECK(written(PunctualType::point, GltfLightMode::standard) ==
        doctest::Approx(6830 / (4 * k_pi)));
  CHECK(written(PunctualType::spot, GltfLightMode::unitless) == doctest::Approx(10 / (4 * k_pi)));
  CHECK(written(PunctualType::spot, GltfLightMode::raw) == 10);
  CHECK(written(PunctualType::directional, GltfLightMode::standard) == doctest::Approx(6830));
  CHECK(written(PunctualType::directional, GltfLightMode::unitless) == 10);
  CHECK(written(PunctualType::directional, GltfLightMode::raw) == 10);
  for (const auto type : {PunctualType::point, PunctualType::spot, PunctualType::directional})
    for (const auto mode : {GltfLightMode::standard, GltfLightMode::unitless, GltfLightMode::raw})
      CHECK(*blender_from_gltf_intensity(written(type, mode), type, mode) == doctest::Approx(10));
}

} // namespace
