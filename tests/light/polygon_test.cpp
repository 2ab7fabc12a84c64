// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/line.h"
#include "openltc/light/polygon.h"
#include "openltc/light/punctual.h"
#include "openltc/light/shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace {

using namespace openltc;
using namespace openltc::light;

double distance_from(Vec3f a, Vec3f b) { return double(length(a - b)); }

TEST_CASE("rectangle_has_the_area_and_normal_of_its_sides") {
  const PolygonLight light =
      rectangle(Vec3f(1, 2, 3), Vec3f(1.5f, 0, 0), Vec3f(0, 0, -0.5f), Vec3f(10, 20, 30));
  CHECK(area(light) == doctest::Approx(3.0).epsilon(1e-6));
  CHECK(distance_from(light.normal, Vec3f(0, 1, 0)) < 1e-6);
  CHECK(validate(light).ok());
}

TEST_CASE("ellipse_has_the_area_and_axes_of_its_half_axes") {
  const EllipseLight light =
      ellipse(Vec3f(0, 1, 0), Vec3f(0.7f, 0, 0), Vec3f(0, 0, 0.2f), Vec3f(10, 20, 30));
  CHECK(area(light) == doctest::Approx(std::numbers::pi * 0.14).epsilon(1e-6));
  CHECK(distance_from(light.center, Vec3f(0, 1, 0)) == 0);
  CHECK(distance_from(light.radiance, Vec3f(10, 20, 30)) == 0);
  CHECK(validate(light).ok());
}

TEST_CASE("flux_is_pi_times_radiance_times_area_for_each_emitting_side") {
  PolygonLight light = rectangle(Vec3f(0), Vec3f(1, 0, 0), Vec3f(0, 1, 0), Vec3f(100, 50, 0));
  CHECK(double(flux_lumens(light).x) == doctest::Approx(std::numbers::pi * 400).epsilon(1e-6));
  CHECK(double(flux_lumens(light).z) == 0);
  light.two_sided = true;
  CHECK(double(flux_lumens(light).y) == doctest::Approx(std::numbers::pi * 400).epsilon(1e-6));
}

TEST_CASE("holes_are_subtracted") {
  PolygonLight light = rectangle(Vec3f(0), Vec3f(2, 0, 0), Vec3f(0, 2, 0), Vec3f(1));
  for (const Vec3f corner : {Vec3f(-1, -1, 0), Vec3f(-1, 1, 0), Vec3f(1, 1, 0), Vec3f(1, -1, 0)})
    light.vertices.push_back(corner); // clockwise
  light.ring_end.push_back(8);
  CHECK(area(light) == doctest::Approx(16.0 - 4.0));
  CHECK(signed_ring_area(ring_vertices(light, 1), light.normal) == doctest::Approx(-4.0));
  CHECK(validate(light).ok());
}

TEST_CASE("area_keeps_its_precision_far_from_the_origin") {
  const PolygonLight light =
      rectangle(Vec3f(4096, 8192, -4096), Vec3f(0.5f, 0, 0), Vec3f(0, 0.5f, 0), Vec3f(1));
  CHECK(area(light) == doctest::Approx(1.0).epsilon(1e-6));
}

TEST_CASE("lights_that_cannot_be_shaded_are_refused_by_name") {
  const PolygonLight good = rectangle(Vec3f(0), Vec3f(1, 0, 0), Vec3f(0, 1, 0), Vec3f(1));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto refuses = [](PolygonLight light) {
    light.name = "lamp";
    const Status status = validate(light);
    return !status.ok() && status.error().message.find("lamp") != std::string::npos;
  };
  PolygonLight light = good;
  light.vertices[2].x = nan;
  CHECK(refuses(light));
  light = good;
  light.ring_end = {5};
  CHECK(refuses(light));
  light = good;
  light.ring_end = {2, 4};
  CHECK(refuses(light));
  light = good;
  light.ring_end.clear();
  CHECK(refuses(light));
  light = good;
  light.radiance.y = -1;
  CHECK(refuses(light));
  light = good;
  light.normal = Vec3f(0, 0, 2);
  CHECK(refuses(light));
  light = good;
  light.normal = Vec3f(0, 0, -1); // clockwise
  CHECK(refuses(light));
  light = good;
  light.vertices[0].z = 0.1f; // not planar
  CHECK(refuses(light));
  light = good;
  light.vertices = {Vec3f(0), Vec3f(1, 0, 0), Vec3f(2, 0, 0), Vec3f(3, 0, 0)};
  CHECK(refuses(light));
}

TEST_CASE("punctual_lights_are_validated") {
  PunctualLight light;
  CHECK(validate(light).ok());
  light.type = PunctualType::spot;
  light.direction = Vec3f(0, 0, 0);
  CHECK(!validate(light).ok());
  light.direction = Vec3f(0, -1, 0);
  CHECK(validate(light).ok());
  light.cos_inner = 0.1f;
  CHECK(!validate(light).ok());
  light = {};
  light.intensity.x = std::numeric_limits<float>::infinity();
  CHECK(!validate(light).ok());
}

} // namespace
