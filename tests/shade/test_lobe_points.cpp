// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Points of polygons that are drawn as a lobe has them, against quadrature of the lobe over the
// polygon and over its parts (polygon_fixture.h), which shares nothing with the sampler but the
// lobe's density.

#include "openltc/target/shade_f32.h"
#include "tests/shade/chi_square.h"
#include "tests/shade/polygon_fixture.h"
#include "tests/shade/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

using namespace openltc;
using testing::Random;

namespace {

Vec3f narrow(Vec3d v) { return {float(v.x), float(v.y), float(v.z)}; }

/// A rectangle in two triangles, in single precision, around `center`.
struct QuadLight {
  Vec3d corner, u, v; ///< as they were rounded
  std::vector<float> triangles;
  PolygonView view;
  testing::TestPolygon outline;

  QuadLight(Vec3d center, Vec3d axis_u, Vec3d axis_v, double width, double height)
      : outline({testing::rectangle(width, height)}, center, axis_u, axis_v, true) {
    view = outline.view();
    const auto point = [&](int i) {
      const float* p = view.points + 4 * i;
      return Vec3d(double(p[0]), double(p[1]), double(p[2]));
    };
    corner = point(0);
    u = point(1) - corner;
    v = point(3) - corner;
    for (const Vec3d& p : {corner, u, u + v, corner, u + v, v})
      for (const double x : {p.x, p.y, p.z})
        triangles.push_back(float(x));
    view.triangles = triangles.data();
    view.triangle_count = 2;
  }
  QuadLight(const QuadLight&) = delete;
  QuadLight& operator=(const QuadLight&) = delete;
};

/// What is seen: a point with its frame and lobe, and the quad.
struct LobeCase {
  std::string name;
  f64::Frame frame;
  f64::Lobe lobe;
  Vec3d center, axis_u, axis_v;
  double width, height;
};

constexpr double k_widths[] = {0.01, 0.1, 0.4, 1.0};
const Vec3d k_axis_x(1, 0, 0), k_axis_y(0, 1, 0), k_axis_z(0, 0, 1);

/// The lobes of a few microfacet widths and views, and a plain cosine; each over quads overhead,
/// across the horizon, across both horizons, small, as large as a wall that stands on the surface,
/// and at random.
std::vector<LobeCase> lobe_cases() {
  Random random(71);
  std::vector<LobeCase> all;
  const f64::Frame frame{k_axis_x, k_axis_y, k_axis_z};
  std::vector<f64::Lobe> lobes = {f64::cosine_lobe()};
  for (const double alpha : k_widths)
    for (const double cosine : {0.95, 0.4, 0.1})
      lobes.push_back(f64::lobe_from_mirror(
          Vec4d(cosine + 0.1, 0.5 * cosine - 0.6, 0.4 - cosine, 2 * cosine + 0.1), alpha, cosine));
  for (const f64::Lobe& lobe : lobes) {
    if (!(lobe.det > 0)) continue;
    const Vec3d axis = normalize(f64::from_cosine(lobe, k_axis_z));
    const Vec3d across = normalize(cross(k_axis_y, axis));
    all.push_back({"overhead", frame, lobe, Vec3d(0.2, 0.1, 1.5), k_axis_x, k_axis_y, 1.5, 1});
    all.push_back({"around the lobe", frame, lobe, axis * 2.0, across, k_axis_y, 1, 2});
    all.push_back({"small, in the lobe", frame, lobe, axis * 2.0, across, k_axis_y, 0.04, 0.03});
    all.push_back(
        {"across the horizon", frame, lobe, Vec3d(1, 0.3, 0.1), k_axis_y, k_axis_z, 1.5, 1});
    all.push_back({"across both horizons", frame, lobe, Vec3d(-0.4, 0.6, 0.1), k_axis_x,
                   normalize(Vec3d(0, 0.3, 1)), 4, 3});
    all.push_back({"a wall on the floor", frame, lobe, Vec3d(0, 1, 1.5), k_axis_x, k_axis_z, 8, 3});
    all.push_back({"a wall ahead", frame, lobe, Vec3d(0.8, 0.5, 1.5), k_axis_y, k_axis_z, 8, 3});
  }
  for (int i = 0; i < 30; ++i) {
    const testing::Setting s = testing::random_setting(random, random.log_uniform(0.02, 1));
    if (!(s.lobe.det > 0)) continue;
    const f64::Frame plane = f64::shading_frame(random.sphere(), random.sphere());
    all.push_back({"at random", s.frame, s.lobe, random.sphere() * random.uniform(0.3, 2), plane.t1,
                   plane.t2, random.log_uniform(0.3, 5), random.log_uniform(0.3, 5)});
  }
  return all;
}

} // namespace

TEST_CASE("polygons are sampled as a lobe has them: counts in their parts, and the integral") {
  constexpr int parts = 6, count = 40000;
  Random random(72);
  int tested = 0, clipped = 0;
  for (const LobeCase& c : lobe_cases()) {
    const QuadLight quad(c.center, c.axis_u, c.axis_v, c.width, c.height);
    const double whole =
        testing::brute_force_integral(quad.view, Vec3d(0.0), c.frame, c.lobe, 1e-9);
    const f64::PolygonByLobe seen = f64::polygon_by_lobe(quad.view, Vec3d(0.0), c.frame, c.lobe);
    if (!seen.known) {
      // What is not sampled so is little.
      CHECK(whole < 0.01);
      continue;
    }
    CAPTURE(c.name);
    CAPTURE(c.lobe.m00);
    CAPTURE(c.lobe.m22);
    CAPTURE(whole);
    CHECK(seen.total / (2 * f64::k_pi) == doctest::Approx(whole).epsilon(2e-5));
    std::vector<double> expected, observed(parts * parts);
    double above = 0;
    for (int i = 0; i < parts; ++i)
      for (int j = 0; j < parts; ++j) {
        const QuadLight part(c.center + c.axis_u * (c.width * ((i + 0.5) / parts - 0.5)) +
                                 c.axis_v * (c.height * ((j + 0.5) / parts - 0.5)),
                             c.axis_u, c.axis_v, c.width / parts, c.height / parts);
        const double integral =
            testing::brute_force_integral(part.view, Vec3d(0.0), c.frame, c.lobe, 1e-7 * whole);
        expected.push_back(count * integral / whole);
        above += integral > 0 ? 1 : 0;
      }
    double smallest = 1e300, largest = 0;
    int beside = 0;
    for (int k = 0; k < count; ++k) {
      const f64::LightPoint point = f64::sample_polygon_by_lobe(quad.view, seen, Vec3d(0.0),
                                                                c.frame, c.lobe, random.square());
      if (!point.hit) {
        ++beside;
        continue;
      }
      const Vec3d on = point.direction * point.distance - quad.corner;
      const double x = dot(on, quad.u) / dot(quad.u, quad.u) * parts,
                   y = dot(on, quad.v) / dot(quad.v, quad.v) * parts;
      REQUIRE(std::abs(x - 0.5 * parts) < 0.5 * parts + 1e-3);
      REQUIRE(std::abs(y - 0.5 * parts) < 0.5 * parts + 1e-3);
      observed[std::size_t(std::clamp(int(x), 0, parts - 1) * parts +
                           std::clamp(int(y), 0, parts - 1))] += 1;
      // The density that is stated is the lobe's over its integral.
      const Vec3d wi = f64::to_shading(c.frame, point.direction);
      const double share = f64::eval_lobe(c.lobe, wi) * point.solid_angle / whole;
      smallest = std::min(smallest, share);
      largest = std::max(largest, share);
    }
    // The outline and the triangles are rounded to single precision each by itself.
    CHECK(beside < 5);
    CHECK(smallest > 1 - 3e-5);
    CHECK(largest < 1 + 3e-5);
    CHECK(testing::p_of_counts(expected, observed) > 1e-4);
    ++tested;
    clipped += above < parts * parts ? 1 : 0;
  }
  MESSAGE(tested << " cases, " << clipped << " of them clipped");
  CHECK(tested > 80);
  CHECK(clipped > 30);
}

TEST_CASE("in single precision lobes are sampled with the same density") {
  Random random(73);
  double worst = 0;
  for (const LobeCase& c : lobe_cases()) {
    const QuadLight quad(c.center, c.axis_u, c.axis_v, c.width, c.height);
    const f32::Frame frame{narrow(c.frame.t1), narrow(c.frame.t2), narrow(c.frame.n)};
    const f32::Lobe lobe =
        f32::make_lobe(float(c.lobe.m00), float(c.lobe.m02), float(c.lobe.m20), float(c.lobe.m22));
    const f32::PolygonByLobe seen = f32::polygon_by_lobe(quad.view, Vec3f(0.0f), frame, lobe);
    if (!seen.known) continue;
    const double whole =
        testing::brute_force_integral(quad.view, Vec3d(0.0), c.frame, c.lobe, 1e-9);
    double sum = 0;
    constexpr int count = 2000;
    for (int k = 0; k < count; ++k) {
      const Vec2d u = random.square();
      const f32::LightPoint point = f32::sample_polygon_by_lobe(
          quad.view, seen, Vec3f(0.0f), frame, lobe,
          Vec2f(std::min(float(u.x), 0.9999999f), std::min(float(u.y), 0.9999999f)));
      if (!point.hit) continue;
      const Vec3f wi = f32::to_shading(frame, point.direction);
      sum += f64::eval_lobe(c.lobe, Vec3d(double(wi.x), double(wi.y), double(wi.z))) *
             double(point.solid_angle);
    }
    CAPTURE(c.name);
    CAPTURE(c.lobe.m00);
    CAPTURE(c.lobe.m22);
    CHECK(sum / count == doctest::Approx(whole).epsilon(2e-4));
    worst = std::max(worst, std::abs(sum / count / whole - 1));
  }
  MESSAGE("worst mean of the estimates: off by " << worst);
}

TEST_CASE("what a lobe has nothing of is not sampled, and nothing is NaN") {
  const f32::Frame frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const f32::Lobe narrow_lobe = f32::lobe_from_mirror(Vec4f(1, 0, 0, 2), 1e-4f, 1.0f);
  struct Place {
    Vec3d center, u, v;
    double width, height;
  };
  const Place places[] = {
      {{0, 0, 0}, k_axis_x, k_axis_y, 2, 2},       // around the point
      {{0, 0, 0}, k_axis_x, k_axis_z, 2, 2},       // through it
      {{0.5, 0, 0}, k_axis_x, k_axis_y, 1, 1},     // in the horizon, a corner in the point
      {{0, 0, -1}, k_axis_x, k_axis_y, 3, 3},      // below
      {{0, 2, 1}, k_axis_x, k_axis_y, 1e-9, 1},    // without area
      {{0, 2, 1}, k_axis_x, k_axis_y, 0, 0},       // a point
      {{0, 0, 1e7}, k_axis_x, k_axis_y, 1, 1},     // far
      {{0, 0, 1e-6}, k_axis_x, k_axis_y, 1e6, 1e6} // all there is
  };
  for (const Place& place : places)
    for (const f32::Lobe& lobe :
         {f32::cosine_lobe(), narrow_lobe, f32::make_lobe(nan, 0.0f, 0.0f, 1.0f)}) {
      const QuadLight quad(place.center, place.u, place.v, place.width, place.height);
      const f32::PolygonByLobe seen = f32::polygon_by_lobe(quad.view, Vec3f(0.0f), frame, lobe);
      for (const float u : {0.0f, 0.3f, 0.9999999f})
        for (const float v : {0.0f, 0.5f, 0.9999999f}) {
          const f32::LightPoint point =
              f32::sample_polygon_by_lobe(quad.view, seen, Vec3f(0.0f), frame, lobe, Vec2f(u, v));
          if (!point.hit) continue;
          CHECK(seen.known);
          CHECK(std::isfinite(point.solid_angle));
          CHECK(point.solid_angle >= 0);
          CHECK(double(length(point.direction)) == doctest::Approx(1).epsilon(1e-5));
          CHECK(point.direction.z > 0);
        }
    }
}

TEST_CASE("latitudes are spread as the square of their cosine") {
  for (int i = -1000; i <= 1000; ++i) {
    const double k = f64::k_pi * i / 1000;
    const Vec2d latitude = f64::latitude_of(k);
    CHECK(std::hypot(latitude.x, latitude.y) == doctest::Approx(1).epsilon(1e-6));
    const double l = std::atan2(latitude.y, latitude.x);
    CHECK(std::abs(2 * l + std::sin(2 * l) - k) < 1e-5);
  }
}
