// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The polygon integral against brute force, and the properties that any exact integral has.

#include "tests/shade/lights/light_fixture.h"
#include "tests/shade/polygon_fixture.h"
#include "tests/shade/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace openltc;
using testing::brute_force_integral;
using testing::Plane;
using testing::Random;
using testing::random_plane;
using testing::random_setting;
using testing::Ring;
using testing::Setting;
using testing::shape;
using testing::TestPolygon;

TEST_CASE("polygon integrals equal brute-force quadrature, both horizons honoured") {
  Random random(1);
  int straddling = 0;
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    const Setting s = random_setting(random, random.log_uniform(0.08, 1.0));
    const Plane p = random_plane(random, s.position);
    const TestPolygon polygon(shape(i % 5), p.origin, p.u, p.v);
    const f64::LightIntegral integral =
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
      const f64::LightIntegral integral =
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

TEST_CASE("the parts of a polygon add up to the whole") {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Setting s = random_setting(random, random.log_uniform(0.02, 1.0));
    const Plane p = random_plane(random, s.position);
    // Cut a rectangle at x = cut, and an L into a foot and a leg.
    const double cut = random.uniform(-0.7, 0.7);
    const TestPolygon whole({testing::rectangle(1.5, 0.8)}, p.origin, p.u, p.v);
    const TestPolygon left({testing::rectangle(cut + 0.75, 0.8, {(cut - 0.75) / 2, 0})}, p.origin,
                           p.u, p.v);
    const TestPolygon right({testing::rectangle(0.75 - cut, 0.8, {(cut + 0.75) / 2, 0})}, p.origin,
                            p.u, p.v);
    const f64::LightIntegral w = f64::integrate_polygon(whole.view(), s.position, s.frame, s.lobe);
    const f64::LightIntegral l = f64::integrate_polygon(left.view(), s.position, s.frame, s.lobe);
    const f64::LightIntegral r = f64::integrate_polygon(right.view(), s.position, s.frame, s.lobe);
    // Corners are single precision; a cut of the plane moves by 1e-7.
    CHECK(l.diffuse + r.diffuse == doctest::Approx(w.diffuse).epsilon(1e-6));
    CHECK(l.specular + r.specular == doctest::Approx(w.specular).epsilon(1e-5));
  }
}

TEST_CASE("a quad's sums are those of any polygon") {
  Random random(21);
  int cut = 0;
  for (int i = 0; i < 2000; ++i) {
    const Setting s = random_setting(random, random.log_uniform(0.01, 1.0));
    const Plane p = random_plane(random, s.position);
    const std::vector<Ring> rings = {
        i % 2 == 0 ? testing::rectangle(2, 0.7)
                   : Ring{Vec2d(-1, -1), Vec2d(1, 0), Vec2d(-1, 1), Vec2d(-0.6, 0)}}; // a dart
    const TestPolygon polygon(rings, p.origin, p.u, p.v);
    const double h =
        dot(f64::polygon_origin(polygon.view()) - s.position, f64::polygon_normal(polygon.view()));
    const f64::EdgeSums any = f64::sum_edges(polygon.view(), s.position, s.frame, s.lobe, h);
    const f64::EdgeSums quad = f64::sum_quad_edges(polygon.view(), s.position, s.frame, s.lobe, h);
    CAPTURE(i);
    // They close what is cut by other arcs; the fit of an angle is good to 1e-9.
    CHECK(length(quad.diffuse - any.diffuse) < 2e-8);
    CHECK(length(quad.specular - any.specular) < 2e-8);
    bool up = false, down = false;
    for (int k = 0; k < polygon.view().point_count; ++k)
      (f64::to_shading(s.frame, f64::polygon_point(polygon.view(), k) - s.position).z > 0 ? up
                                                                                          : down) =
          true;
    cut += up && down ? 1 : 0;
  }
  CHECK(cut > 500);
}

TEST_CASE("in a polygon's plane there is no light, whatever rounding makes of the distance") {
  Random random(22);
  const f32::FittedLobe fitted{f32::cosine_lobe(), 1, 0};
  int lit = 0;
  for (int i = 0; i < 2000; ++i) {
    const Plane p = random_plane(random, Vec3d(random.uniform(-9, 9), 0, 0));
    const TestPolygon polygon({testing::rectangle(2, 2)}, p.origin, p.u, p.v, i % 2 == 0);
    const Vec3d on_it = p.origin + p.u * random.uniform(-2, 2) + p.v * random.uniform(-1, 1);
    const auto shade = [&](Vec3d position) {
      const Vec3f normal = to_float(random.sphere());
      return f32::shade_polygon(f32::make_surface(fitted, to_float(position), normal, normal,
                                                  Vec3f(0.5f), Vec3f(0.04f), Vec3f(1.0f), 0.5f),
                                polygon.view());
    };
    CHECK(length(shade(on_it)) == 0);
    if (length(shade(on_it + cross(p.u, p.v) * 1e-3)) > 0) ++lit;
  }
  CHECK(lit > 500);
}

TEST_CASE("a hole takes away what its outline would give") {
  Random random(3);
  const Ring outer = testing::rectangle(1.8, 1.6), inner = testing::star(5, 0.6, 0.3);
  for (int i = 0; i < 200; ++i) {
    const Setting s = random_setting(random, random.log_uniform(0.02, 1.0));
    const Plane p = random_plane(random, s.position);
    const TestPolygon both({outer, testing::reversed(inner)}, p.origin, p.u, p.v);
    const TestPolygon full({outer}, p.origin, p.u, p.v);
    const TestPolygon hole({inner}, p.origin, p.u, p.v);
    const f64::LightIntegral b = f64::integrate_polygon(both.view(), s.position, s.frame, s.lobe);
    const f64::LightIntegral f = f64::integrate_polygon(full.view(), s.position, s.frame, s.lobe);
    const f64::LightIntegral h = f64::integrate_polygon(hole.view(), s.position, s.frame, s.lobe);
    CHECK(b.diffuse == doctest::Approx(f.diffuse - h.diffuse).epsilon(1e-9));
    CHECK(b.specular == doctest::Approx(f.specular - h.specular).epsilon(1e-9));
  }
}

TEST_CASE("turning everything together changes nothing; turning the light about n keeps diffuse") {
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    const Setting s = random_setting(random, random.log_uniform(0.05, 1.0));
    const Plane p = random_plane(random, s.position);
    const TestPolygon polygon(shape(i % 5), p.origin, p.u, p.v);
    const f64::LightIntegral before =
        f64::integrate_polygon(polygon.view(), s.position, s.frame, s.lobe);

    // A rotation given by an orthonormal basis.
    const f64::Frame basis = f64::shading_frame(random.sphere(), random.sphere());
    const auto turn = [&](Vec3d v) { return f64::to_world(basis, v); };
    const f64::Frame frame = {turn(s.frame.t1), turn(s.frame.t2), turn(s.frame.n)};
    const TestPolygon turned(shape(i % 5), turn(p.origin), turn(p.u), turn(p.v));
    const f64::LightIntegral after =
        f64::integrate_polygon(turned.view(), turn(s.position), frame, s.lobe);
    CHECK(after.diffuse == doctest::Approx(before.diffuse).epsilon(2e-6));
    CHECK(after.specular == doctest::Approx(before.specular).epsilon(1e-5));

    const double angle = random.uniform(0, 6.28);
    const f64::Frame about_n = {s.frame.t1 * std::cos(angle) + s.frame.t2 * std::sin(angle),
                                s.frame.t2 * std::cos(angle) - s.frame.t1 * std::sin(angle),
                                s.frame.n};
    const f64::LightIntegral other =
        f64::integrate_polygon(polygon.view(), s.position, about_n, f64::cosine_lobe());
    CHECK(other.diffuse == doctest::Approx(before.diffuse).epsilon(2e-8));
    CHECK(other.specular == doctest::Approx(before.diffuse).epsilon(2e-8));
  }
}

TEST_CASE("a polygon shines to its front, a two-sided one to both sides alike") {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const Setting s = random_setting(random, random.log_uniform(0.05, 1.0));
    const Plane p = random_plane(random, s.position);
    const TestPolygon front(shape(i % 5), p.origin, p.u, p.v, false);
    const TestPolygon both(shape(i % 5), p.origin, p.u, p.v, true);
    // The same outlines seen from behind: mirrored in u, with the normal reversed.
    std::vector<Ring> mirrored = shape(i % 5);
    for (Ring& ring : mirrored) {
      for (Vec2d& x : ring)
        x.x = -x.x;
      ring = testing::reversed(ring);
    }
    const TestPolygon back(mirrored, p.origin, p.u * -1.0, p.v, false);
    const TestPolygon back_both(mirrored, p.origin, p.u * -1.0, p.v, true);
    const auto integral = [&](const TestPolygon& polygon) {
      return f64::integrate_polygon(polygon.view(), s.position, s.frame, s.lobe);
    };
    CHECK(integral(back).diffuse == 0);
    CHECK(integral(back).specular == 0);
    CHECK(integral(both).specular == integral(front).specular);
    CHECK(integral(back_both).diffuse == doctest::Approx(integral(front).diffuse).epsilon(1e-9));
    CHECK(integral(back_both).specular == doctest::Approx(integral(front).specular).epsilon(1e-9));
  }
}

TEST_CASE("a polygon below the surface gives exactly nothing, whatever the lobe") {
  Random random(6);
  for (int i = 0; i < 1000; ++i) {
    Setting s = random_setting(random, random.log_uniform(1e-4, 1.0));
    const Plane p = random_plane(random, s.position);
    const TestPolygon polygon(shape(i % 5), p.origin, p.u, p.v, true);
    // Lift the point along its normal until every corner lies below.
    double highest = -1e9;
    for (int k = 0; k < polygon.view().point_count; ++k)
      highest = std::max(highest, dot(f64::polygon_point(polygon.view(), k), s.frame.n));
    s.position += s.frame.n * (highest - dot(s.position, s.frame.n) + random.log_uniform(1e-3, 1));
    const f64::LightIntegral d =
        f64::integrate_polygon(polygon.view(), s.position, s.frame, s.lobe);
    CHECK(d.diffuse == 0);
    CHECK(d.specular == 0);
  }
}

TEST_CASE("a huge ceiling covers the whole hemisphere") {
  Random random(7);
  for (int i = 0; i < 50; ++i) {
    Setting s = random_setting(random, random.log_uniform(0.05, 1.0));
    s.position = Vec3d(0, 0, 0);
    const Vec3d origin = s.frame.n * 1.0;
    const TestPolygon ceiling({testing::rectangle(2e4, 2e4)}, origin, s.frame.t2, s.frame.t1);
    const f64::LightIntegral d =
        f64::integrate_polygon(ceiling.view(), s.position, s.frame, s.lobe);
    // The rest of the hemisphere: everything within 1e-4 of the horizon.
    CHECK(d.diffuse == doctest::Approx(1).epsilon(1e-6));
    // The lobe's share above the surface, from its definition in cosine space (fit/lobe_fit.cpp).
    const double above =
        0.5 * (1 + s.lobe.m00 / std::sqrt(s.lobe.m00 * s.lobe.m00 + s.lobe.m20 * s.lobe.m20));
    CHECK(d.specular == doctest::Approx(above).epsilon(2e-3));
  }
}
