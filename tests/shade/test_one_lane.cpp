// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The sum over edges as shaders do it, in double; test_shaders and parity have it in their
// languages.

#include "tests/shade/polygon_fixture.h"
#include "tests/shade/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace openltc;
using testing::brute_force_integral;
using testing::Plane;
using testing::Random;
using testing::Setting;
using testing::TestPolygon;

namespace {

constexpr double k_turn = 2 * 3.14159265358979323846;

} // namespace

TEST_CASE("edges in one lane: any outline, cut by both horizons and by a triangle, equals brute "
          "force") {
  for (const bool cut : {false, true}) {
    Random random(cut ? 31 : 30);
    double worst = 0, light = 0;
    for (int i = 0; i < 150; ++i) {
      const Setting s = testing::random_setting(random, random.log_uniform(0.08, 1.0));
      const Plane p = testing::random_plane(random, s.position);
      const TestPolygon polygon(testing::shape(i % 5), p.origin, p.u, p.v);
      const Vec3d front = cut ? normalize(s.frame.n + random.sphere() * 0.5) : s.frame.n;
      const Vec3d front_shading = f64::to_shading(s.frame, front);
      const double h = dot(f64::polygon_origin(polygon.view()) - s.position,
                           f64::polygon_normal(polygon.view()));
      const f64::EdgeSums sums =
          i % 5 == 0 // a rectangle
              ? f64::sum_quad_in_one_lane(polygon.view(), s.position, s.frame, s.lobe, h, cut,
                                          front_shading)
              : f64::sum_edges_in_one_lane(polygon.view(), s.position, s.frame, s.lobe, cut,
                                           front_shading);
      const Vec3d* plane = cut ? &front : nullptr;
      const double diffuse = brute_force_integral(polygon.view(), s.position, s.frame,
                                                  f64::cosine_lobe(), 1e-9, plane);
      const double specular =
          brute_force_integral(polygon.view(), s.position, s.frame, s.lobe, 1e-9, plane);
      CAPTURE(i);
      // In front of a polygon its outline runs clockwise.
      CHECK(-sums.diffuse.z / k_turn == doctest::Approx(diffuse).epsilon(3e-7));
      CHECK(-sums.specular.z / k_turn == doctest::Approx(specular).epsilon(3e-7));
      worst = std::max({worst, std::abs(-sums.diffuse.z / k_turn - diffuse),
                        std::abs(-sums.specular.z / k_turn - specular)});
      light += diffuse + specular;
    }
    MESSAGE(std::string(cut ? "cut" : "whole"), ": largest difference ", worst);
    CHECK(light > 10);
  }
}
