// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Rays against polygons, checked by the winding number of the outline.

#include "openltc/target/shade_f32.h"
#include "tests/shade/polygon_fixture.h"
#include "tests/shade/random.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace openltc;
using testing::Plane;
using testing::Random;
using testing::Setting;
using testing::TestPolygon;

TEST_CASE("a ray hits a polygon where the winding number says inside") {
  Random random(21);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Setting s = random_setting(random, 0.5);
    const Plane p = random_plane(random, s.position);
    const bool two_sided = i % 2 == 0;
    const TestPolygon polygon(testing::shape(i % 5), p.origin, p.u, p.v, two_sided);
    const Vec3d position = i % 3 == 0 ? p.origin * 2.0 - s.position : s.position; // or from behind
    // Aim at a point of the plane near the outline, or anywhere.
    const Vec2d aim(random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2));
    const Vec3d target = p.origin + p.u * aim.x + p.v * aim.y;
    const bool at_plane = i % 7 != 0;
    const Vec3d direction = at_plane ? normalize(target - position) : random.sphere();

    const f64::LightPoint hit = f64::intersect_polygon_by_area(polygon.view(), position, direction);
    const Vec3d normal = f64::polygon_normal(polygon.view());
    const double slope = dot(direction, normal);
    const double t = dot(f64::polygon_origin(polygon.view()) - position, normal) / slope;
    const Vec3d on_plane = position + direction * t - f64::polygon_origin(polygon.view());
    const Vec2d point(dot(on_plane, f64::polygon_axis_u(polygon.view())),
                      dot(on_plane, f64::polygon_axis_v(polygon.view())));
    const bool expected =
        t > 0 && (two_sided || slope < 0) && testing::inside_by_winding(polygon.view(), point);
    CAPTURE(i);
    CHECK(hit.hit == expected);
    if (expected) {
      ++hits;
      CHECK(hit.distance == doctest::Approx(t).epsilon(1e-9));
      CHECK(hit.cos_light == doctest::Approx(std::abs(slope)).epsilon(1e-9));
    }
  }
  CHECK(hits > 2000);
}

TEST_CASE("a ray within the polygon's plane hits nothing") {
  const TestPolygon polygon({testing::rectangle(1, 1)}, Vec3d(0, 0, 0), Vec3d(1, 0, 0),
                            Vec3d(0, 1, 0), true);
  CHECK_FALSE(f64::intersect_polygon_by_area(polygon.view(), Vec3d(-2, 0, 0), Vec3d(1, 0, 0)).hit);
  CHECK_FALSE(f32::intersect_polygon_by_area(polygon.view(), Vec3f(-2, 0, 0), Vec3f(1, 0, 0)).hit);
}
