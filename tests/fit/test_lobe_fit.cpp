// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// One node: derivatives, the leak, and fits whose answer is known.

#include "openltc/fit/lobe_fit.h"
#include "openltc/fit/lobe_sums.h"
#include "openltc/fit/measure/error.h"
#include "openltc/target/shade_f64.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <vector>

using namespace openltc;

namespace {

// Lambert's BRDF, whose best lobe is the cosine, whatever the roughness.
const brdf::Brdf k_lambert =
    brdf::brdf_from_function("lambert", [](Vec3d, Vec3d, double) { return f64::k_inv_pi; });

double& component(Vec4d& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : k == 2 ? v.z : v.w; }

} // namespace

TEST_CASE("the analytic Jacobian equals finite differences") {
  int compared = 0;
  for (const double alpha : {1e-3, 0.05, 0.5, 1.0}) {
    for (int i = 0; i < 200; ++i) {
      // A spread of directions around the mirror direction, width alpha.
      const double r = alpha * (0.05 + 0.02 * i), phi = 0.37 * i;
      const Vec3d w = normalize(Vec3d(r * std::cos(phi), r * std::sin(phi), 1));
      const Vec4d at(0.7, -0.4, 0.6, 1.3);
      const fit::LobeDensity d = fit::lobe_density(at, alpha, w);
      if (d.value <= 0) continue;
      for (int k = 0; k < 4; ++k) {
        const double h = 1e-5;
        Vec4d up = at, down = at;
        component(up, k) += h;
        component(down, k) -= h;
        const double difference =
            (fit::lobe_density(up, alpha, w).value - fit::lobe_density(down, alpha, w).value) /
            (2 * h);
        CHECK(std::abs(d.derivative[k] - difference) < 1e-6 * (d.value + std::abs(difference)));
        ++compared;
      }
    }
  }
  CHECK(compared > 1000);
}

TEST_CASE("the objective's gradient equals finite differences, clipped and leaking") {
  const brdf::Brdf& ggx = *brdf::find_brdf("ggx");
  for (const fit::Horizon horizon : {fit::Horizon::clipped, fit::Horizon::leaking}) {
    for (const char* name : fit::k_objective_names) {
      for (const double roughness : {0.05, 0.4, 1.0}) {
        for (const double c : {0.9, 0.3, 0.02}) {
          const fit::Quadrature q = *fit::make_quadrature(ggx, roughness, c, {20, 20});
          fit::Objective objective = *fit::find_objective(name);
          objective.horizon = horizon;
          const Vec4d at(1.1 * c, -0.6 * (1 - c), 1.2 * (1 - c), 2.3 * c);
          const fit::ObjectiveValue here = fit::evaluate_objective(q, at, objective);
          REQUIRE(std::isfinite(here.value));
          for (int k = 0; k < 4; ++k) {
            const double h = 1e-6 * c;
            Vec4d up = at, down = at;
            component(up, k) += h;
            component(down, k) -= h;
            const double difference = (fit::evaluate_objective(q, up, objective).value -
                                       fit::evaluate_objective(q, down, objective).value) /
                                      (2 * h);
            CAPTURE(name);
            CAPTURE(k);
            CHECK(std::abs(here.gradient[k] - difference) <
                  1e-5 * (1 + std::abs(difference) + here.value / c));
          }
        }
      }
    }
  }
}

TEST_CASE("every instruction set gives the same bits") {
  const std::vector<fit::LobeSums> variants = fit::all_lobe_sums();
  const brdf::Brdf& ggx = *brdf::find_brdf("ggx");
  const fit::Quadrature q = *fit::make_quadrature(ggx, 0.37, 0.21, {21, 17});
  fit::LobeSumsInput in;
  in.x = q.x_mirror.data();
  in.y = q.y.data();
  in.z = q.z_mirror.data();
  in.weight = q.weight.data();
  in.density = q.density.data();
  in.count = q.size();
  const double m[4] = {0.3, -0.04, 0.15, 0.06}, slope[4] = {2.1, -4.3, 1.2, 9.0};
  for (int k = 0; k < 4; ++k) {
    in.m[k] = m[k];
    in.log_slope[k] = slope[k];
  }
  in.det = 0.00764;
  in.tv = 1;
  in.squares = 0.2;
  in.cubes = 0.1;
  in.rounding = 0.05;
  in.floor = 1e-3;
  fit::LobeDistances first;
  fit::LobeDerivatives first_slopes;
  variants.front().distances(in, first);
  variants.front().derivatives(in, first_slopes);
  CHECK(first.missing > 0);
  for (const fit::LobeSums& variant : variants) {
    fit::LobeDistances other;
    fit::LobeDerivatives other_slopes;
    variant.distances(in, other);
    variant.derivatives(in, other_slopes);
    CHECK(std::memcmp(&first, &other, sizeof(first)) == 0);
    CHECK(std::memcmp(&first_slopes, &other_slopes, sizeof(first_slopes)) == 0);
  }
  MESSAGE("variants compared: ", variants.size());
}

TEST_CASE("a lobe that lies across the horizon: what is above and below add up to 1") {
  const f64::Lobe lobe = f64::lobe_from_mirror(Vec4d(0.2, -0.5, 0.9, 0.3), 0.4, 0.15);
  CHECK(fit::above_horizon(lobe) < 0.99);
  CHECK(fit::above_horizon(lobe) + fit::lobe_leak(Vec4d(0.2, -0.5, 0.9, 0.3), 0.4, 0.15) ==
        doctest::Approx(1));
}

TEST_CASE("the density here is the density of the shading maths") {
  for (int i = 0; i < 500; ++i) {
    const double theta = 0.003 * i, alpha = 0.02 + 0.0019 * i;
    const double c = std::cos(theta), s = std::sin(theta);
    const Vec4d abcd(0.3 + 0.5 * c, -0.5 * s, 0.8 * s, 0.1 + 1.5 * c);
    const double a = 0.7 * i, b = 0.3 + 0.005 * i;
    const Vec3d w(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b));
    const Vec3d mirror(c * w.x + s * w.z, w.y, c * w.z - s * w.x);
    CHECK(fit::lobe_density(abcd, alpha, mirror).value ==
          doctest::Approx(f64::eval_lobe(f64::lobe_from_mirror(abcd, alpha, c), w)).epsilon(1e-9));
  }
}

TEST_CASE("the leak is what the lobe holds below the horizon") {
  for (const double theta : {0.0, 0.5, 1.0, 1.4}) {
    const double c = std::cos(theta), alpha = 0.4;
    const Vec4d abcd(0.3 + 0.5 * c, -0.5, 0.8, 0.1 + 1.5 * c);
    const f64::Lobe lobe = f64::lobe_from_mirror(abcd, alpha, c);
    // By samples of the lobe on a grid.
    const int n = 800;
    int below = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        below += f64::sample_lobe(lobe, Vec2d((i + 0.5) / n, (j + 0.5) / n)).z < 0;
    CHECK(fit::lobe_leak(abcd, alpha, c) == doctest::Approx(double(below) / (n * n)).epsilon(2e-3));
  }
}

TEST_CASE("a lobe fitted to Lambert is the cosine") {
  for (const double c : {1.0, 0.8, 0.3, 0.05}) {
    const fit::Quadrature q = *fit::make_quadrature(k_lambert, 0.7, c, {32, 32});
    Vec4d start = fit::cosine_start(q.width, c);
    start.x *= 1.3;
    start.w *= 0.7;
    const fit::LobeFit f = fit::fit_lobe(q, start, {});
    const f64::Lobe lobe = f64::lobe_from_mirror(f.mirror, q.width, c);
    CAPTURE(c);
    CHECK(f.converged);
    CHECK(lobe.m00 == doctest::Approx(1).epsilon(1e-5));
    CHECK(lobe.m22 == doctest::Approx(1).epsilon(1e-5));
    CHECK(std::abs(lobe.m02) < 1e-5);
    CHECK(std::abs(lobe.m20) < 1e-5);
    CHECK(fit::measure_lobe(q, lobe).tv < 1e-4);
  }
}

// Within a thousandth: sums of norms have shallow dents.
TEST_CASE("no single coefficient can be changed for the better") {
  const brdf::Brdf& ggx = *brdf::find_brdf("ggx");
  for (const double roughness : {0.1, 0.4, 0.9}) {
    for (const double c : {0.9, 0.4, 0.05}) {
      const fit::Quadrature q = *fit::make_quadrature(ggx, roughness, c, {32, 32});
      const fit::LobeFit best = fit::fit_lobe(q, fit::cosine_start(q.width, c), {});
      for (int k = 0; k < 4; ++k) {
        for (const double change : {-0.01, 0.01}) {
          Vec4d other = best.mirror;
          component(other, k) += change;
          // A single trial step from there must come back below.
          fit::LobeFitOptions one;
          one.max_iterations = 1;
          CHECK(fit::fit_lobe(q, other, one).objective >= 0.999 * best.objective);
        }
      }
    }
  }
}

TEST_CASE("each objective is the best in its own norm") {
  const brdf::Brdf& ggx = *brdf::find_brdf("ggx");
  const fit::Quadrature q = *fit::make_quadrature(ggx, 0.5, 0.3, {40, 32});
  const Vec4d start = fit::cosine_start(q.width, q.cos_theta);
  const auto measure = [&](const char* name) {
    fit::LobeFitOptions options;
    options.objective = *fit::find_objective(name);
    options.objective.horizon = fit::Horizon::leaking;
    const fit::LobeFit f = fit::fit_lobe(q, start, options);
    CHECK(f.converged);
    return fit::measure_lobe(q, f64::lobe_from_mirror(f.mirror, q.width, q.cos_theta));
  };
  const fit::LobeError tv = measure("tv"), balanced = measure("balanced");
  const fit::LobeError l2 = measure("l2"), l3 = measure("l3");
  CHECK(tv.tv < balanced.tv);
  CHECK(balanced.tv < l2.tv);
  CHECK(l2.l2 < balanced.l2);
  CHECK(l2.l2 < l3.l2);
  CHECK(balanced.l2 < tv.l2);
  CHECK(l3.l3 < l2.l3);
  CHECK(l2.l3 < tv.l3);
}
