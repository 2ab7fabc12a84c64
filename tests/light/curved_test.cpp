// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Curved lights: what is known of them from their definition, and what is refused.

#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/emitter.h"
#include "openltc/light/line.h"
#include "openltc/light/punctual.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace {

using namespace openltc;
using namespace openltc::light;

constexpr double k_pi = std::numbers::pi;

TEST_CASE("a_capsule_without_length_is_nearly_a_sphere_and_a_thin_tube_nearly_a_line") {
  SphereLight sphere;
  sphere.radius = 0.3f;
  TubeLight tube;
  tube.radius = 0.3f;
  tube.to = tube.from + Vec3f(1e-5f, 0, 0);
  CHECK(area(tube) == doctest::Approx(area(sphere)).epsilon(1e-4));

  LineLight line;
  line.to = line.from + Vec3f(0, 2, 0);
  line.intensity_per_metre = Vec3f(3.0f);
  tube.to = tube.from + Vec3f(0, 2, 0);
  tube.radius = 1e-4f;
  tube.radiance = line.intensity_per_metre * (1 / (2 * tube.radius)); // I = L w
  CHECK(double(flux_lumens(tube).x) == doctest::Approx(double(flux_lumens(line).x)).epsilon(1e-3));
}

TEST_CASE("the_exitance_is_the_integral_of_the_emission_over_the_hemisphere") {
  for (const float power : {0.0f, 0.5f, 1.0f, 4.0f, 30.0f}) {
    SphereLight light;
    light.cosine_power = power;
    double sum = 0;
    constexpr int n = 20000;
    for (int i = 0; i < n; ++i) {
      const double c = (i + 0.5) / n; // cosine, uniform over solid angle
      sum += std::pow(c, double(power)) * c * 2 * k_pi / n;
    }
    CHECK(exitance_per_radiance(light) == doctest::Approx(sum).epsilon(1e-6));
  }
}

TEST_CASE("lights_that_cannot_be_shaded_are_refused_by_name") {
  const auto refused = [](const auto& light, const char* words) {
    const Status status = validate(light);
    REQUIRE(!status.ok());
    INFO(status.error().message);
    CHECK(status.error().message.find("\"lamp\"") != std::string::npos);
    CHECK(status.error().message.find(words) != std::string::npos);
  };
  const float inf = std::numeric_limits<float>::infinity();
  SphereLight sphere;
  sphere.name = "lamp";
  CHECK(validate(sphere).ok());
  for (const float radius : {0.0f, -1.0f, inf, std::nanf("")}) {
    sphere.radius = radius;
    refused(sphere, "radius");
  }
  sphere.radius = 1;
  sphere.cosine_power = -1;
  refused(sphere, "cosine power");
  EllipseLight ellipse;
  ellipse.name = "lamp";
  CHECK(validate(ellipse).ok());
  ellipse.half_v = Vec3f(0.5f, 1, 0);
  refused(ellipse, "perpendicular");
  ellipse.half_v = Vec3f(0, 0, 0);
  refused(ellipse, "semi-axis");
  TubeLight tube;
  tube.name = "lamp";
  CHECK(validate(tube).ok());
  tube.to = tube.from;
  refused(tube, "length");
  LineLight line;
  line.name = "lamp";
  CHECK(validate(line).ok());
  line.intensity_per_metre = Vec3f(-1.0f);
  refused(line, "intensity per metre");
}

} // namespace
