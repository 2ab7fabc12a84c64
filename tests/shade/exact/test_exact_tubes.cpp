// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Tubes lit by GGX itself, by integrals along their outline: against points of their surface, in
// double precision.

#include "openltc/table/lobe_table.h"
#include "openltc/target/shade_f32.h"
#include "openltc/target/shade_f64.h"
#include "tests/shade/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace openltc;
using testing::Random;

namespace {

constexpr double k_pi = std::numbers::pi;

// Without a diffuse part; white metal or a dielectric.
f64::Surface surface(double theta, double roughness, double f0) {
  const Vec3d normal(0, 0, 1), wo(std::sin(theta), 0, std::cos(theta));
  const f64::FittedLobe fitted = f64::fetch_lobe(table::builtin_ggx_table().view(),
                                                 f64::alpha_from_roughness(roughness), wo.z);
  return f64::make_exact(f64::make_surface(fitted, Vec3d(0.0), normal, wo, Vec3d(0.0), Vec3d(f0),
                                           Vec3d(1.0), roughness));
}

// By the middles of parts of its surface; what faces the origin is seen, as a tube is convex.
double midpoints(const f64::Surface& s, const f64::Tube& tube, int n) {
  const Vec3d span = tube.to - tube.from, axis = normalize(span);
  const Vec3d e1 = f64::any_perpendicular(axis), e2 = cross(axis, e1);
  double sum = 0;
  const auto add = [&](Vec3d p, Vec3d normal, double area) {
    const double distance2 = dot(p, p), facing = -dot(p, normal) / std::sqrt(distance2);
    const Vec3d wi = f64::to_shading(s.frame, normalize(p));
    const f64::GgxTerms terms = f64::eval_ggx_terms(s.wo, wi, s.alpha);
    const double reflected = s.f0.x * terms.scale + (1 - s.f0.x) * terms.bias;
    if (facing > 0) sum += reflected * facing * area / distance2;
  };
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const double phi = 2 * k_pi * (k + 0.5) / n, x = (i + 0.5) / n;
      const Vec3d around = e1 * std::cos(phi) + e2 * std::sin(phi);
      add(tube.from + span * x + around * tube.radius, around,
          2 * k_pi * tube.radius * length(span) / (n * n));
      for (const double way : {-1.0, 1.0}) {
        const Vec3d end = way < 0 ? tube.from : tube.to;
        if (tube.caps > 1.5) {
          const Vec3d out = around * std::sqrt(1 - x * x) + axis * (way * x);
          add(end + out * tube.radius, out, 2 * k_pi * tube.radius * tube.radius / (n * n));
        } else if (tube.caps > 0.5) {
          add(end + around * (std::sqrt(x) * tube.radius), axis * way,
              k_pi * tube.radius * tube.radius / (n * n));
        }
      }
    }
  return sum;
}

// Beside the origin, in front of it and across its horizon, thick and thin.
f64::Tube random_tube(double size, double caps, Random& random) {
  f64::Tube tube;
  do {
    const Vec3d center = random.hemisphere() * random.uniform(1, 4);
    const Vec3d part = random.sphere() * (size * random.log_uniform(0.1, 3));
    tube = {center - part, center + part, size * random.log_uniform(0.03, 1), caps};
  } while (f64::inside_tube({tube.from, tube.to, 1.1 * tube.radius, caps}, Vec3d(0.0)));
  return tube;
}

} // namespace

TEST_CASE("exact tubes: open, closed and round ones of every size, against points of them") {
  const struct {
    double size, metal, dielectric; // bounds of the sum of errors over the light
  } cases[] = {{1, 1e-3, 6e-3}, {0.25, 3e-4, 8e-4}, {0.03, 3e-4, 4e-4}};
  for (const double f0 : {1.0, 0.04})
    for (const double caps : {0.0, 1.0, 2.0})
      for (const auto& one : cases) {
        Random random(41);
        double errors = 0, of_lobe = 0, light = 0, worst = 0;
        for (int i = 0; i < 100; ++i) {
          // What the points resolve.
          const double roughness = random.uniform(std::min(0.4, 0.15 + 0.25 * one.size), 1);
          const f64::Surface s = surface(random.uniform(0, 88.0 / 180 * k_pi), roughness, f0);
          const f64::Tube tube = random_tube(one.size, caps, random);
          const double truth = midpoints(s, tube, 200);
          const double found = f64::shade_tube(s, tube).x;
          f64::Surface plain = s;
          plain.exact = false;
          errors += std::abs(found - truth);
          of_lobe += std::abs(f64::shade_tube(plain, tube).x - truth);
          light += truth;
          worst = std::max(worst, std::abs(found - truth));
        }
        MESSAGE("F0 ", f0, ", caps ", caps, ", size ", one.size, ": ", errors / light,
                " of the light (ratio ", of_lobe / light, "), worst ", worst);
        CHECK(errors / light < (f0 < 1 ? one.dielectric : one.metal));
        CHECK(worst < 2e-3);
        CHECK(errors < 0.25 * of_lobe);
      }
}

TEST_CASE("exact tubes: cut by the horizon, in it and below it") {
  for (const double caps : {0.0, 1.0, 2.0}) {
    Random random(47);
    double errors = 0, light = 0;
    for (int i = 0; i < 100; ++i) {
      const f64::Surface s =
          surface(random.uniform(0, 88.0 / 180 * k_pi), random.uniform(0.4, 1), 1);
      f64::Tube tube = random_tube(0.5, caps, random);
      // From wholly below to wholly above, along the surface or out of it.
      const double z = random.uniform(-1.2, 1.2) * tube.radius;
      tube.from.z = z;
      tube.to.z = i % 2 ? z : z + random.uniform(-1, 1);
      if (f64::inside_tube({tube.from, tube.to, 1.1 * tube.radius, caps}, Vec3d(0.0))) continue;
      const double truth = midpoints(s, tube, 300), found = f64::shade_tube(s, tube).x;
      errors += std::abs(found - truth);
      light += truth;
      if (std::max(tube.from.z, tube.to.z) < -tube.radius) CHECK(found == 0);
    }
    MESSAGE("caps ", caps, ": ", errors / light, " of the light");
    CHECK(errors / light < 3e-3);
  }
}

TEST_CASE("exact tubes: single precision, and nothing that is not a number") {
  Random random(53);
  double sum = 0, worst = 0;
  int count = 0;
  for (int i = 0; i < 20000; ++i) {
    // Every tenth at a limit.
    const double theta = i % 10 == 0 ? 0.5 * k_pi : i % 10 == 1 ? 0 : random.uniform(0, 1.57);
    const double roughness = i % 10 == 2 ? 0 : i % 10 == 3 ? 1 : random.uniform();
    f64::Tube tube = random_tube(random.log_uniform(1e-4, 3), double(i % 3), random);
    if (i % 10 == 4) tube.from.z = tube.to.z = 0;
    if (i % 10 == 5) tube.to = tube.from;
    if (i % 10 == 6) tube.to = tube.from * 2.0; // towards the point
    if (i % 10 == 7) tube.radius = 0;
    const double precise = f64::shade_tube(surface(theta, roughness, 1), tube).x;
    const Vec3f wo = to_float(Vec3d(std::sin(theta), 0, std::cos(theta)));
    const f32::FittedLobe fitted = f32::fetch_lobe(
        table::builtin_ggx_table().view(), f32::alpha_from_roughness(float(roughness)), wo.z);
    const f32::Surface s =
        f32::make_exact(f32::make_surface(fitted, Vec3f(0.0f), Vec3f(0, 0, 1), wo, Vec3f(0.0f),
                                          Vec3f(1.0f), Vec3f(1.0f), float(roughness)));
    const double single = double(f32::shade_tube(s, {to_float(tube.from), to_float(tube.to),
                                                     float(tube.radius), float(tube.caps)})
                                     .x);
    CHECK(std::isfinite(precise));
    CHECK(std::isfinite(single));
    CHECK(single >= 0);
    CHECK(single <= 1.001);
    if (roughness < 0.05 || theta > 1.56) continue;
    sum += std::abs(single - precise);
    worst = std::max(worst, std::abs(single - precise));
    ++count;
  }
  MESSAGE("mean ", sum / count, ", worst ", worst);
  CHECK(sum / count < 2e-6);
  CHECK(worst < 2e-3);
}
