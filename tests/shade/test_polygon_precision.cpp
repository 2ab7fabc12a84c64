// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What rounding does to the polygon integral: single precision against double, and inputs made to
// break it.

#include "openltc/target/shade_f32.h"
#include "tests/shade/polygon_fixture.h"
#include "tests/shade/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace openltc;
using testing::Plane;
using testing::Random;
using testing::Ring;
using testing::Setting;
using testing::TestPolygon;

namespace {

f32::Frame to_float(const f64::Frame& f) { return {to_float(f.t1), to_float(f.t2), to_float(f.n)}; }
f64::Frame to_double(const f32::Frame& f) {
  return {to_double(f.t1), to_double(f.t2), to_double(f.n)};
}
f32::Lobe to_float(const f64::Lobe& l) {
  return f32::make_lobe(float(l.m00), float(l.m02), float(l.m20), float(l.m22));
}
f64::Lobe to_double(const f32::Lobe& l) {
  return f64::make_lobe(double(l.m00), double(l.m02), double(l.m20), double(l.m22));
}

bool in_range(float x) { return x >= 0.0f && x <= 1.0f; }

} // namespace

TEST_CASE("theta over sine is accurate to 1.1e-9 in double") {
  long double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const long double x = -1 + 2 * (i + 0.5L) / 200000;
    const long double sin2 = (1 - x) * (1 + x);
    const long double exact = std::acos(x) / std::sqrt(sin2);
    const long double value = (long double)f64::theta_over_sin(double(x), double(sin2));
    worst = std::max(worst, std::abs(value / exact - 1));
  }
  MESSAGE("largest relative error ", double(worst));
  CHECK(worst < 1.1e-9L);
  CHECK(f64::theta_over_sin(1.0, 0.0) == doctest::Approx(1).epsilon(1.1e-9));
}

TEST_CASE("single precision follows double") {
  Random random(11);
  double worst_diffuse = 0, worst_specular = 0, sum_diffuse = 0, sum_specular = 0;
  const int count = 100000;
  for (int i = 0; i < count; ++i) {
    // Both get the same rounded numbers; what differs is the arithmetic.
    const Setting s = random_setting(random, random.log_uniform(0.01, 1.0));
    const Plane p = random_plane(random, s.position);
    const TestPolygon polygon(testing::shape(i % 5), p.origin, p.u, p.v, i % 3 == 0);
    const f32::Frame frame = to_float(s.frame);
    const f32::Lobe lobe = to_float(s.lobe);
    const Vec3f position = to_float(s.position);
    const f32::LightIntegral single = f32::integrate_polygon(polygon.view(), position, frame, lobe);
    const f64::LightIntegral exact = f64::integrate_polygon(polygon.view(), to_double(position),
                                                            to_double(frame), to_double(lobe));
    const double diffuse = std::abs(double(single.diffuse) - exact.diffuse);
    const double specular = std::abs(double(single.specular) - exact.specular);
    worst_diffuse = std::max(worst_diffuse, diffuse);
    worst_specular = std::max(worst_specular, specular);
    sum_diffuse += diffuse;
    sum_specular += specular;
  }
  MESSAGE("diffuse: mean ", sum_diffuse / count, ", largest ", worst_diffuse, "; specular: mean ",
          sum_specular / count, ", largest ", worst_specular);
  // Distances are about 1, so corners carry 1e-7. A lobe of width alpha magnifies that by 1/alpha
  // where its edge is crossed: 100 at the least alpha drawn here.
  CHECK(worst_diffuse < 3e-6);
  CHECK(worst_specular < 1e-4);
  CHECK(sum_diffuse / count < 2e-7);
  CHECK(sum_specular / count < 2e-7);
}

// The sums before they are clamped, which would hide a NaN.
static bool sums_are_finite(const PolygonView& polygon, Vec3f position, const f32::Frame& frame,
                            const f32::Lobe& lobe) {
  for (const float h : {-1.0f, 1.0f}) {
    const f32::EdgeSums sums = f32::sum_edges(polygon, position, frame, lobe, h);
    const f32::EdgeSums quad =
        polygon.point_count == 5 ? f32::sum_quad_edges(polygon, position, frame, lobe, h) : sums;
    for (const Vec3f& v : {sums.diffuse, sums.specular, quad.diffuse, quad.specular})
      if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return false;
  }
  return true;
}

static bool is_unit(Vec3f v) { return std::abs(length(v) - 1) < 1e-5f; }

TEST_CASE("degenerate outlines and positions give finite values in range") {
  Random random(12);
  const std::vector<std::vector<Ring>> outlines = {
      {{Vec2d(0, 0), Vec2d(0, 0), Vec2d(0, 0)}},                           // a point
      {{Vec2d(0, 0), Vec2d(1, 0), Vec2d(0, 0), Vec2d(1, 0)}},              // a line
      {{Vec2d(0, 0), Vec2d(1, 0), Vec2d(1, 0), Vec2d(1, 1), Vec2d(0, 1)}}, // a repeated corner
      {testing::rectangle(1, 1), testing::reversed(testing::rectangle(1, 1))},
      {testing::rectangle(1e-20, 1e-20)},
      {testing::rectangle(1e-6, 1e6)},
      {testing::rectangle(1e8, 1e8)}};
  for (const std::vector<Ring>& rings : outlines) {
    for (int i = 0; i < 2000; ++i) {
      const Setting s = random_setting(random, random.log_uniform(1e-4, 1.0));
      const Plane p = random_plane(random, s.position);
      const TestPolygon polygon(rings, p.origin, p.u, p.v, i % 2 == 0);
      // At random, on the plane, at a corner, on an edge, just off the plane.
      Vec3d position = s.position;
      const Vec2d c = rings[0][0], d = rings[0][1];
      const Vec3d n = cross(p.u, p.v);
      if (i % 5 == 1)
        position = p.origin + p.u * random.uniform(-2, 2) + p.v * random.uniform(-1, 1);
      if (i % 5 == 2) position = p.origin + p.u * c.x + p.v * c.y;
      if (i % 5 == 3) position = p.origin + p.u * ((c.x + d.x) / 2) + p.v * ((c.y + d.y) / 2);
      if (i % 5 == 4) position = p.origin + p.u * 0.1 + n * random.log_uniform(1e-12, 1e-3);
      const f32::LightIntegral single = f32::integrate_polygon(polygon.view(), to_float(position),
                                                               to_float(s.frame), to_float(s.lobe));
      const f64::LightIntegral d64 =
          f64::integrate_polygon(polygon.view(), position, s.frame, s.lobe);
      CAPTURE(i);
      CHECK(
          sums_are_finite(polygon.view(), to_float(position), to_float(s.frame), to_float(s.lobe)));
      CHECK(is_unit(single.specular_direction));
      CHECK(in_range(single.diffuse));
      CHECK(in_range(single.specular));
      // In the plane there is no side, whatever rounding makes of the distance.
      if (i % 5 == 1 || i % 5 == 2 || i % 5 == 3) {
        f32::Surface surface;
        surface.position = to_float(position);
        surface.position_error2 = f32::k_position_rounding * f32::k_position_rounding *
                                  dot(surface.position, surface.position);
        CHECK_FALSE(f32::has_side(surface, f32::polygon_origin(polygon.view()),
                                  f32::polygon_normal(polygon.view())));
      }
      CHECK((d64.diffuse >= 0 && d64.diffuse <= 1));
      CHECK((d64.specular >= 0 && d64.specular <= 1));
    }
  }
}

TEST_CASE("an outline of no area gives next to nothing") {
  Random random(13);
  for (int i = 0; i < 1000; ++i) {
    const Setting s = random_setting(random, random.log_uniform(0.05, 1.0));
    const Plane p = random_plane(random, s.position);
    const TestPolygon line({{Vec2d(0, 0), Vec2d(1, 0), Vec2d(0.4, 0), Vec2d(1, 0)}}, p.origin, p.u,
                           p.v);
    const f32::LightIntegral d = f32::integrate_polygon(line.view(), to_float(s.position),
                                                        to_float(s.frame), to_float(s.lobe));
    CHECK(d.diffuse < 1e-6f);
    CHECK(d.specular < 1e-4f);
  }
}

TEST_CASE("adversarial numbers never give NaN, infinity or a negative value") {
  Random random(14);
  const double magnitudes[] = {0, 1e-30, 1e-12, 1e-6, 1e-3, 1, 1e3, 1e6, 1e9};
  const auto pick = [&] {
    const double m = magnitudes[random.integer(9)];
    return random.uniform() < 0.5 ? m : -m;
  };
  for (int i = 0; i < 100000; ++i) {
    const int corners = 3 + random.integer(4);
    Ring ring;
    for (int k = 0; k < corners; ++k)
      ring.push_back(Vec2d(pick(), pick()));
    const f64::Frame plane = f64::shading_frame(random.sphere(), random.sphere());
    const bool aligned = random.uniform() < 0.5;
    const Vec3d u = aligned ? Vec3d(1, 0, 0) : plane.t1, v = aligned ? Vec3d(0, 0, 1) : plane.t2;
    const TestPolygon polygon({ring}, Vec3d(pick(), pick(), pick()), u, v, true);
    const f64::Frame frame = aligned ? f64::Frame{Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)}
                                     : f64::shading_frame(random.sphere(), random.sphere());
    const double cos_theta = random.uniform() < 0.3 ? 1.0 : random.uniform();
    const double alpha = random.log_uniform(1e-4, 1);
    const f32::Lobe lobe =
        to_float(f64::lobe_from_mirror(Vec4d(cos_theta + 1e-3, random.uniform(-1, 0),
                                             random.uniform(0, 1.5), 2 * cos_theta + 1e-3),
                                       alpha, cos_theta));
    const Vec3f position{float(pick()), float(pick()), float(pick())};
    const f32::LightIntegral d =
        f32::integrate_polygon(polygon.view(), position, to_float(frame), lobe);
    CAPTURE(i);
    CHECK(sums_are_finite(polygon.view(), position, to_float(frame), lobe));
    CHECK(is_unit(d.specular_direction));
    CHECK(in_range(d.diffuse));
    CHECK(in_range(d.specular));
  }
}
