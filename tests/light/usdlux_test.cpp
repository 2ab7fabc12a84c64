// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// USDLux emissions against their definition, and against their inverse.

#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/polygon.h"
#include "openltc/light/units/usdlux.h"
#include "tests/light/light_patches.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace openltc;
using namespace openltc::light;
using namespace openltc::light::test;

constexpr double k_pi = std::numbers::pi;

TEST_CASE("usdlux_lights_are_nits_and_when_normalized_keep_their_flux") {
  UsdLuxEmission emission;
  emission.intensity = 3;
  emission.exposure = 2;
  emission.color = {1, 0.5f, 0};
  const Vec3f nits = *luminance_from_usdlux(emission, 0);
  CHECK(double(nits.x) == doctest::Approx(12));
  CHECK(double(nits.y) == doctest::Approx(6));
  CHECK(nits.z == 0.0f);

  emission.normalize = true;
  const auto check_flux = [&](const auto& light) {
    const Vec3f radiance = *luminance_from_usdlux(emission, area(light));
    CHECK(summed_flux(patches_of(light), 0) * double(radiance.x) ==
          doctest::Approx(12 * k_pi).epsilon(1e-3));
  };
  for (const float size : {0.1f, 3.0f}) {
    SphereLight sphere;
    sphere.radius = size;
    check_flux(sphere);
    EllipseLight disk;
    disk.half_u = {size, 0, 0};
    disk.half_v = {0, size, 0};
    check_flux(disk);
    TubeLight cylinder; // whose ends do not emit
    cylinder.caps = TubeCaps::none;
    cylinder.radius = size;
    check_flux(cylinder);
  }
  check_flux(bent_polygon());
}

TEST_CASE("a_distant_light_lights_a_facing_surface_by_all_of_its_cone") {
  for (const double angle : {0.53, 60.0, 180.0, 250.0, 360.0}) {
    CAPTURE(angle);
    // Beyond the hemisphere the definition counts |cos|.
    const double t = angle * k_pi / 360;
    double sum = 0;
    constexpr int rings = 200000;
    for (int i = 0; i < rings; ++i) {
      const double c = 1 - (1 - std::cos(t)) * (i + 0.5) / rings;
      sum += std::abs(c) * 2 * k_pi * (1 - std::cos(t)) / rings;
    }
    UsdLuxEmission emission;
    emission.intensity = 50;
    emission.exposure = 1;
    CHECK(double(illuminance_from_usdlux_distant(emission, angle)->y) ==
          doctest::Approx(100 * sum).epsilon(1e-4));
    emission.normalize = true;
    CHECK(double(illuminance_from_usdlux_distant(emission, angle)->y) == doctest::Approx(100));
  }
  CHECK(*usdlux_distant_size_factor(0) == 1.0);
}

TEST_CASE("usdlux_emissions_come_back") {
  const Vec3f value(3, 40, 0.25f);
  for (const bool normalize : {false, true})
    for (const double exposure : {-3.0, 0.0, 8.5}) {
      const UsdLuxEmission area_light = *usdlux_from_luminance(value, exposure, normalize, 0.3);
      const UsdLuxEmission distant =
          *usdlux_distant_from_illuminance(value, exposure, normalize, 2.0);
      CHECK(area_light.exposure == exposure);
      CHECK(double(area_light.color.y) == doctest::Approx(1));
      for (const Vec3f back : {*luminance_from_usdlux(area_light, 0.3),
                               *illuminance_from_usdlux_distant(distant, 2.0)}) {
        CHECK(double(back.x) == doctest::Approx(3).epsilon(1e-6));
        CHECK(double(back.y) == doctest::Approx(40).epsilon(1e-6));
        CHECK(double(back.z) == doctest::Approx(0.25).epsilon(1e-6));
      }
    }
  const UsdLuxEmission black = *usdlux_from_luminance(Vec3f(0.0f), 0, false, 0);
  CHECK(black.intensity == 0);
  CHECK(luminance_from_usdlux(black, 0)->x == 0.0f);
}

} // namespace
