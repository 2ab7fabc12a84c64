// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Two lobes beside each other. Where the Fresnel reflectance is 1, light by both is the weighted
// mean of light by each of them alone.

#include "openltc/table/lobe_table.h"
#include "polygon_fixture.h"
#include "random.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace openltc;
using testing::Random;
using testing::TestPolygon;

namespace {

f64::FittedLobe table_lobe(double roughness, double cos_theta) {
  return f64::fetch_lobe(table::builtin_ggx_table().view(), f64::alpha_from_roughness(roughness),
                         cos_theta);
}

// White metal at the origin, normal up.
f64::Surface surface(f64::FittedLobe fitted, Vec3d wo, double roughness) {
  return f64::make_surface(fitted, Vec3d(0.0), Vec3d(0, 0, 1), wo, Vec3d(0.0), Vec3d(1.0),
                           Vec3d(1.0), roughness);
}

// Three surfaces of the same n1: one lobe, another, and both.
struct Trio {
  f64::Surface first, second, both;
  double weight;
};

Trio trio(Random& random) {
  const double theta = random.uniform(0.1, 1.5), roughness = random.uniform(0.1, 0.8);
  const Vec3d wo(std::sin(theta), 0, std::cos(theta));
  f64::FittedLobe one = table_lobe(roughness, wo.z), other = one;
  other.lobe = table_lobe(std::min(1.0, roughness + 0.2), 0.9 * wo.z).lobe;
  Trio t;
  t.weight = random.uniform(0.05, 0.6);
  t.first = surface(one, wo, roughness);
  t.second = surface(other, wo, roughness);
  f64::SecondLobe second;
  second.lobe = other.lobe;
  second.weight = t.weight;
  t.both = f64::add_second_lobe(t.first, second);
  return t;
}

template <class Shade> void check_mean(const Trio& t, Shade shade) {
  const double a = shade(t.first), b = shade(t.second), both = shade(t.both);
  CHECK(both == doctest::Approx((1 - t.weight) * a + t.weight * b).epsilon(1e-12));
}

} // namespace

TEST_CASE("two lobes: light of every shape is the mean of the light by each of them") {
  Random random(11);
  for (int i = 0; i < 300; ++i) {
    const Trio t = trio(random);
    const Vec3d center = random.hemisphere() * random.uniform(1, 3) + Vec3d(0, 0, 0.1);
    const f64::Frame frame = f64::shading_frame(normalize(center) * -1.0, Vec3d(0.1, 0.2, 1));
    const double a = random.uniform(0.01, 1.5), b = random.uniform(0.01, 1.5);
    const TestPolygon quad({testing::rectangle(2 * a, 2 * b)}, center, frame.t1, frame.t2);
    check_mean(t, [&](const f64::Surface& s) { return f64::shade_polygon(s, quad.view()).y; });
    f64::Ellipse ellipse;
    ellipse.center = center;
    ellipse.half_u = frame.t1 * a;
    ellipse.half_v = frame.t2 * b;
    ellipse.two_sided = 0;
    check_mean(t, [&](const f64::Surface& s) { return f64::shade_ellipse(s, ellipse).y; });
    f64::Sphere sphere;
    sphere.center = center;
    sphere.radius = 0.6 * a;
    check_mean(t, [&](const f64::Surface& s) { return f64::shade_sphere(s, sphere).y; });
    f64::Line line;
    line.from = center - frame.t1 * a;
    line.to = center + frame.t1 * a;
    check_mean(t, [&](const f64::Surface& s) { return f64::shade_line(s, line).y; });
    f64::Tube tube;
    tube.from = line.from;
    tube.to = line.to;
    tube.radius = 0.2 * b;
    tube.caps = 1;
    check_mean(t, [&](const f64::Surface& s) { return f64::shade_tube(s, tube).y; });
    const Vec3d wi = random.hemisphere();
    check_mean(t, [&](const f64::Surface& s) { return f64::eval_surface_ltc(s, wi).y; });
  }
}

TEST_CASE("two lobes: a light on all sides reflects the albedo, with the ratio too") {
  Random random(12);
  for (int i = 0; i < 50; ++i) {
    const Trio t = trio(random);
    // A ceiling so wide and near that next to nothing passes beside it.
    const TestPolygon ceiling({testing::rectangle(2e4, 2e4)}, Vec3d(0, 0, 0.01), Vec3d(0, 1, 0),
                              Vec3d(1, 0, 0));
    CHECK(f64::shade_polygon(t.both, ceiling.view()).x ==
          doctest::Approx(t.both.fitted.n1).epsilon(1e-4));
    CHECK(f64::shade_polygon(f64::correct_at_mean(t.both), ceiling.view()).x ==
          doctest::Approx(t.both.fitted.n1).epsilon(1e-4));
  }
}

TEST_CASE("two lobes: a second one of no weight changes nothing") {
  Random random(13);
  for (int i = 0; i < 50; ++i) {
    const Trio t = trio(random);
    f64::SecondLobe none;
    none.lobe = t.second.fitted.lobe;
    none.weight = 0;
    const f64::Surface s = f64::add_second_lobe(t.first, none);
    const Vec3d center = random.hemisphere() * 2.0;
    const f64::Frame frame = f64::shading_frame(normalize(center) * -1.0, Vec3d(0.1, 0.2, 1));
    const TestPolygon quad({testing::rectangle(1, 1)}, center, frame.t1, frame.t2);
    CHECK(f64::shade_polygon(s, quad.view()).x ==
          doctest::Approx(f64::shade_polygon(t.first, quad.view()).x).epsilon(1e-12));
    CHECK(s.axis_weight == doctest::Approx(t.first.axis_weight).epsilon(1e-12));
  }
}
