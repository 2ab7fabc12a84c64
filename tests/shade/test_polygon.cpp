// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The polygon integral against brute force, and the properties that any exact integral has.

#include "polygon_fixture.h"
#include "random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace openltc;
using testing::brute_force_integral;
using testing::Random;
using testing::Ring;
using testing::TestPolygon;

namespace {

struct Setting {
  f64::Frame frame;
  f64::Lobe lobe;
  Vec3d position;
};

// A frame at random and a lobe of the kind that fits give, width `alpha`.
Setting random_setting(Random& random, double alpha) {
  Setting s;
  const Vec3d n = random.sphere();
  Vec3d wo = random.sphere();
  if (dot(wo, n) < 0) wo = -wo;
  s.frame = f64::shading_frame(n, wo);
  const double cos_theta = dot(wo, n);
  const Vec4d abcd(cos_theta + random.uniform(0, 0.6), random.uniform(-1, 0.2),
                   random.uniform(0, 1.2), 0.1 + 2 * cos_theta);
  s.lobe = f64::lobe_from_mirror(abcd, alpha, cos_theta);
  s.position = Vec3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  return s;
}

std::vector<Ring> shape(int kind) {
  using namespace testing;
  switch (kind) {
  case 0:
    return {rectangle(1.5, 0.8)};
  case 1:
    return {l_shape(1.6)};
  case 2:
    return {star(5, 1.0, 0.4)};
  case 3:
    return {rectangle(1.8, 1.6), reversed(rectangle(0.7, 0.5, {0.3, 0.2}))};
  default:
    return {rectangle(0.6, 0.6, {-0.6, 0}), star(3, 0.5, 0.2)};
  }
}

// A plane at random near the position, so that many outlines straddle a horizon.
struct Plane {
  Vec3d origin, u, v;
};
Plane random_plane(Random& random, Vec3d position) {
  const f64::Frame f = f64::shading_frame(random.sphere(), random.sphere());
  Vec3d origin = position + random.sphere() * random.uniform(0.4, 2.0);
  // Its emitting side, t1 x t2 = n, towards the position.
  if (dot(origin - position, f.n) > 0) return {origin, f.t2, f.t1};
  return {origin, f.t1, f.t2};
}

} // namespace

TEST_CASE("polygon integrals equal brute-force quadrature, both horizons honoured") {
  Random random(1);
  int straddling = 0;
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    const Setting s = random_setting(random, random.log_uniform(0.08, 1.0));
    const Plane p = random_plane(random, s.position);
    const TestPolygon polygon(shape(i % 5), p.origin, p.u, p.v);
    const f64::PolygonIntegral integral =
        f64::integrate_polygon(polygon.view(), s.position, s.frame, s.lobe);
    const double diffuse =
        brute_force_integral(polygon.view(), s.position, s.frame, f64::cosine_lobe(), 1e-9);
    const double specular = brute_force_integral(polygon.view(), s.position, s.frame, s.lobe, 1e-9);
    CAPTURE(i);
    CHECK(integral.diffuse == doctest::Approx(diffuse).epsilon(3e-7));
    CHECK(integral.specular == doctest::Approx(specular).epsilon(3e-7));
    worst = std::max(
        {worst, std::abs(integral.diffuse - diffuse), std::abs(integral.specular - specular)});
    bool above = false, below = false;
    for (int k = 0; k < polygon.view().point_count; ++k) {
      const Vec3d x = f64::to_shading(s.frame, f64::polygon_point(polygon.view(), k) - s.position);
      (x.z > 0 ? above : below) = true;
    }
    straddling += above && below;
  }
  MESSAGE("largest difference ", worst, ", outlines across the horizon: ", straddling);
  CHECK(straddling > 100);
}

TEST_CASE("vertices exactly on the horizon do not open the outline") {
  // A diamond standing on its tip, its side corners at the height of the surface; and a panel whose
  // lower edge lies on the floor.
  f64::Frame frame;
  frame.t1 = Vec3d(1, 0, 0);
  frame.t2 = Vec3d(0, 1, 0);
  frame.n = Vec3d(0, 0, 1);
  const f64::Lobe lobe = f64::lobe_from_mirror(Vec4d(0.6, -0.3, 0.5, 1.0), 0.4, 0.6);
  const Ring diamond = {Vec2d(-1, 0), Vec2d(0, -1), Vec2d(1, 0), Vec2d(0, 1)};
  const Ring standing = {Vec2d(-1, 0), Vec2d(1, 0), Vec2d(1, 1), Vec2d(-1, 1)};
  const Ring tip = {Vec2d(0, 0), Vec2d(1, 1), Vec2d(-1, 1)};
  const Ring half = {Vec2d(-1, -1), Vec2d(0, 0), Vec2d(1, -1), Vec2d(1, 1), Vec2d(-1, 1)};
  for (const Ring& ring : {diamond, standing, tip, half}) {
    for (const double turn : {0.0, 0.3, 1.2, 2.0, 3.0, 4.4, 5.5}) {
      // A vertical plane at distance 1, turned about the surface's normal; v is up, so corners with
      // v = 0 have exactly the surface's height.
      const Vec3d out(std::cos(turn), std::sin(turn), 0);
      const Vec3d u(out.y, -out.x, 0), v(0, 0, 1);
      const TestPolygon polygon({ring}, out, u, v);
      const f64::PolygonIntegral integral =
          f64::integrate_polygon(polygon.view(), Vec3d(0, 0, 0), frame, lobe);
      CAPTURE(turn);
      const Vec3d origin(0, 0, 0);
      const double diffuse =
          brute_force_integral(polygon.view(), origin, frame, f64::cosine_lobe(), 1e-10);
      const double specular = brute_force_integral(polygon.view(), origin, frame, lobe, 1e-10);
      CHECK(diffuse > 0.01);
      CHECK(integral.diffuse == doctest::Approx(diffuse).epsilon(1e-6));
      CHECK(integral.specular == doctest::Approx(specular).epsilon(1e-6));
    }
  }
}
