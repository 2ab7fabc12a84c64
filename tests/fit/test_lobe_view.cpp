// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lobes seen from above: the disc keeps solid angles, and the window holds the lobe.

#include "openltc/fit/measure/error.h"
#include "openltc/fit/report/lobe_view.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace openltc;

namespace {

constexpr int k_side = 400;

fit::Quadrature ggx_at(double roughness, double theta_degrees) {
  const auto rule =
      fit::make_quadrature(*brdf::find_brdf("ggx"), roughness,
                           std::cos(theta_degrees * f64::k_pi / 180), fit::QuadratureSize{40, 32});
  REQUIRE(rule);
  return *rule;
}

// The integral over the solid angle of what a window shows: the unit disc is 2 pi steradians.
double energy_in(const std::vector<double>& disc, const fit::DiscWindow& window) {
  const double pixel = 2 * std::pow(2 * window.half / k_side, 2);
  double sum = 0;
  for (const double density : disc)
    sum += density > 0 ? density * pixel : 0;
  return sum;
}

} // namespace

TEST_CASE("the whole disc holds a lobe's whole energy") {
  const fit::DiscWindow whole;
  CHECK_FALSE(whole.is_zoomed());
  for (const double theta : {0.0, 30.0, 60.0}) {
    const fit::Quadrature rule = ggx_at(0.7, theta);
    const auto brdf = fit::density_of(*brdf::find_brdf("ggx"), rule);
    CHECK(energy_in(fit::sample_disc(brdf, whole, k_side), whole) ==
          doctest::Approx(1).epsilon(1e-3));
    const auto lobe = fit::lobes_of(table::builtin_ggx_table())(0.7, rule.cos_theta).lobe;
    for (const fit::Horizon horizon : {fit::Horizon::leaking, fit::Horizon::clipped}) {
      const auto density = fit::density_of(lobe, horizon);
      const double expected = f64::share_above_horizon(lobe) * fit::horizon_scale(lobe, horizon);
      CHECK(energy_in(fit::sample_disc(density, whole, k_side), whole) ==
            doctest::Approx(expected).epsilon(1e-3));
    }
  }
}

TEST_CASE("the window of a narrow lobe is zoomed and holds nearly all of it") {
  for (const double theta : {0.0, 45.0, 70.0}) {
    const fit::Quadrature rule = ggx_at(0.2, theta);
    const fit::DiscWindow window = fit::window_of_lobe(rule);
    CHECK(window.is_zoomed());
    CHECK(std::abs(window.center_x - fit::mirror_in_disc(rule.cos_theta)) < window.half);
    const auto brdf = fit::density_of(*brdf::find_brdf("ggx"), rule);
    const double energy = energy_in(fit::sample_disc(brdf, window, k_side), window);
    CHECK(energy > 0.9);
    CHECK(energy < 1.01);
  }
  CHECK_FALSE(fit::window_of_lobe(ggx_at(1, 30)).is_zoomed());
}

TEST_CASE("discs have the mirror direction on their right and nothing beyond the horizon") {
  const fit::Quadrature rule = ggx_at(0.15, 50);
  const fit::DiscWindow whole;
  const auto disc = fit::sample_disc(fit::density_of(*brdf::find_brdf("ggx"), rule), whole, k_side);
  const std::size_t brightest =
      std::size_t(std::max_element(disc.begin(), disc.end()) - disc.begin());
  const double x = whole.half * (2 * (double(brightest % k_side) + 0.5) / k_side - 1);
  const double y = whole.half * (1 - 2 * (double(brightest / k_side) + 0.5) / k_side);
  CHECK(x == doctest::Approx(fit::mirror_in_disc(rule.cos_theta)).epsilon(0.02));
  CHECK(std::abs(y) < 0.01);
  // sqrt(2) sin(theta / 2) in closed form.
  CHECK(fit::mirror_in_disc(rule.cos_theta) ==
        doctest::Approx(std::sqrt(2.0) * std::sin(25 * f64::k_pi / 180)));
  CHECK(disc.front() == -1);
  CHECK(disc.back() == -1);
}
