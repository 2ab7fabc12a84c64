// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The lobe's share above the horizon, and that dividing by it leaves nothing to leak: light from
// the whole hemisphere reflects the albedo, whatever the lobe.

#include "openltc/table/lobe_polynomial.h"
#include "openltc/table/lobe_table.h"
#include "tests/shade/polygon_fixture.h"
#include "tests/shade/random.h"
#include "tests/shade/sphere_quadrature.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace openltc;
using testing::Random;
using testing::SphereMap;
using testing::TestPolygon;

namespace {

const Vec3d k_origin(0.0), k_up(0, 0, 1), k_white(1.0);

// A ceiling so wide that what it leaves of the hemisphere is 1e-12 high.
const TestPolygon& whole_hemisphere() {
  static const TestPolygon ceiling({testing::rectangle(2e12, 2e12)}, Vec3d(0, 0, 1), Vec3d(1, 0, 0),
                                   Vec3d(0, -1, 0));
  return ceiling;
}

f64::Surface surface(f64::FittedLobe fitted, double roughness, double cos_theta, Vec3d f0) {
  const Vec3d wo(std::sqrt(1 - cos_theta * cos_theta), 0, cos_theta);
  return f64::make_surface(fitted, k_origin, k_up, wo, k_origin, f0, k_white, roughness);
}

// Lobes as fits give them, from either form, over the whole domain.
template <class Check> void for_fitted_lobes(Check check) {
  const LobeTableView table = table::builtin_ggx_table().view();
  const LobePolynomialView polynomial = table::builtin_ggx_polynomial().view();
  for (const double roughness : {0.0, 0.02, 0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 0.9, 1.0})
    for (const double theta : {0.0, 0.01, 0.3, 0.7, 1.1, 1.4, 1.5, 1.55, 1.5707}) {
      const double alpha = f64::alpha_from_roughness(roughness), cos_theta = std::cos(theta);
      CAPTURE(roughness);
      CAPTURE(theta);
      check(f64::fetch_lobe(table, alpha, cos_theta), roughness, cos_theta);
      check(f64::eval_lobe_polynomial(polynomial, alpha, cos_theta), roughness, cos_theta);
    }
}

} // namespace

TEST_CASE("share_above_horizon is the integral of the lobe over the upper hemisphere") {
  Random random(81);
  for (int i = 0; i < 40; ++i) {
    const f64::Lobe lobe = f64::make_lobe(random.uniform(-0.5, 2), random.uniform(-1.5, 1.5),
                                          random.uniform(-1.5, 1.5), random.uniform(-0.5, 2));
    if (lobe.det < 0.3) continue;
    const Vec3d axis = normalize(f64::from_cosine(lobe, k_up));
    const auto above = [&](Vec3d w) { return w.z > 0 ? f64::eval_lobe(lobe, w) : 0.0; };
    const double share = SphereMap(axis, 0.7).integrate(above, 600);
    CHECK(f64::share_above_horizon(lobe) == doctest::Approx(share).epsilon(2e-3));
  }
  CHECK(f64::share_above_horizon(f64::cosine_lobe()) == 1);
}

TEST_CASE("a light over the whole hemisphere meets the share and the mean direction above it") {
  const f64::Frame frame = f64::shading_frame(k_up, k_up);
  for_fitted_lobes([&](const f64::FittedLobe& fitted, double, double) {
    const f64::LightIntegral integral =
        f64::integrate_polygon(whole_hemisphere().view(), k_origin, frame, fitted.lobe);
    CHECK(std::abs(integral.diffuse - 1) < 1e-8);
    CHECK(std::abs(integral.specular - f64::share_above_horizon(fitted.lobe)) < 1e-8);
    const Vec3d mean = f64::safe_direction(f64::mean_above_horizon(fitted.lobe));
    CHECK(length(integral.specular_direction - mean) < 1e-6);
  });
}

TEST_CASE("white furnace: a light over the whole hemisphere reflects exactly the albedo") {
  double largest_leak = 0;
  for_fitted_lobes([&](const f64::FittedLobe& fitted, double roughness, double cos_theta) {
    const f64::Surface metal = surface(fitted, roughness, cos_theta, k_white);
    CHECK(std::abs(f64::shade_polygon(metal, whole_hemisphere().view()).x - fitted.n1) < 1e-6);
    const Vec3d f0(0.04);
    const f64::Surface glossy = surface(fitted, roughness, cos_theta, f0);
    const double albedo = f64::specular_amplitude(fitted, f0, k_white).x;
    CHECK(std::abs(f64::shade_polygon(glossy, whole_hemisphere().view()).x - albedo) < 1e-6);
    largest_leak = std::max(largest_leak, 1 - f64::share_above_horizon(fitted.lobe));
  });
  MESSAGE("largest leak that is made up for: " << largest_leak);
  CHECK(largest_leak > 0.01);
}

TEST_CASE("white furnace: many lights around the point reflect the albedo together") {
  // A box of five walls, those at the sides reaching below the horizon.
  Random random(82);
  for (int i = 0; i < 50; ++i) {
    const double roughness = random.uniform(0.05, 1), cos_theta = random.uniform(0.02, 1);
    const Vec3d position(random.uniform(-1, 1), random.uniform(-1, 1), 0);
    const Vec3d wo(std::sqrt(1 - cos_theta * cos_theta), 0, cos_theta);
    const f64::FittedLobe fitted = f64::fetch_lobe(table::builtin_ggx_table().view(),
                                                   f64::alpha_from_roughness(roughness), cos_theta);
    const f64::Surface s =
        f64::make_surface(fitted, position, k_up, wo, k_origin, k_white, k_white, roughness);
    double sum = 0;
    const Vec3d x(1, 0, 0), y(0, 1, 0);
    for (const auto& [center, u] : {std::pair(x * 2.0, y), std::pair(x * -2.0, -y),
                                    std::pair(y * 2.0, -x), std::pair(y * -2.0, x)}) {
      // The normal, u x v, faces the middle of the box.
      const TestPolygon wall({testing::rectangle(4, 4)}, center, u, -k_up);
      CHECK(dot(cross(u, -k_up), center) == -2);
      sum += f64::shade_polygon(s, wall.view()).x;
    }
    const TestPolygon ceiling({testing::rectangle(4, 4)}, k_up * 2.0, x, -y);
    sum += f64::shade_polygon(s, ceiling.view()).x;
    CHECK(std::abs(sum - fitted.n1) < 1e-6);
  }
}

TEST_CASE("the density form integrates to the same albedo") {
  for (const double roughness : {0.2, 0.5, 1.0})
    for (const double theta : {0.2, 0.9, 1.3}) {
      const double cos_theta = std::cos(theta);
      const f64::FittedLobe fitted = f64::fetch_lobe(
          table::builtin_ggx_table().view(), f64::alpha_from_roughness(roughness), cos_theta);
      const f64::Surface s = surface(fitted, roughness, cos_theta, k_white);
      const Vec3d axis = normalize(f64::from_cosine(fitted.lobe, k_up));
      const double albedo =
          SphereMap(axis, roughness * roughness)
              .integrate([&](Vec3d wi) { return f64::eval_surface_ltc(s, wi).x; }, 800);
      CHECK(albedo == doctest::Approx(fitted.n1).epsilon(2e-3));
    }
}

TEST_CASE("a lobe that lies below the horizon gives no infinite light") {
  f64::FittedLobe fitted;
  fitted.lobe = f64::make_lobe(-1, 1e-9, 1e-9, -1);
  fitted.n1 = 1;
  fitted.n5 = 0.1;
  CHECK(f64::share_above_horizon(fitted.lobe) < 1e-6);
  const f64::Surface s = surface(fitted, 1, 0.5, k_white);
  const double light = f64::shade_polygon(s, whole_hemisphere().view()).x;
  CHECK(std::isfinite(light));
  CHECK(light >= 0);
  CHECK(light <= 1);
}
