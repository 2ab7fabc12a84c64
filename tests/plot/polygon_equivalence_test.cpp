// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/fit/measure/polygon_integral.h"
#include "openltc/plot/matrix_lobe.h"
#include "openltc/plot/polygon_equivalence.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace openltc;
using namespace openltc::plot;

namespace {

const f64::Lobe& skewed_lobe() {
  static const f64::Lobe lobe = lobe_of_matrix({1.0, -0.95, 0.6, 0.2});
  return lobe;
}

// Reaches below both horizons.
const std::vector<Vec3d> k_card = {
    {-1.6, -0.2, -0.5}, {0.6, -1.4, -0.5}, {0.6, -1.4, 1.0}, {-1.6, -0.2, 1.0}};

std::string error_of(const std::vector<Vec3d>& corners) {
  const auto result = compare_spaces(skewed_lobe(), corners, "--points");
  return result.ok() ? "" : result.error().message;
}

} // namespace

TEST_CASE("both integrals agree for random lobes and polygons, and with what shading computes") {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> spread(-1, 1);
  const auto random = [&] { return Vec3d(spread(engine), spread(engine), spread(engine)); };
  int compared = 0;
  while (compared < 60) {
    const LobeMatrix m{std::exp(1.5 * spread(engine) - 0.7), spread(engine),
                       std::exp(1.5 * spread(engine) - 0.7), 0.5 * spread(engine)};
    const Vec3d o = random() * 2.0, u = random(), v = random();
    const std::vector<Vec3d> corners = {o, o + u, o + u * 0.6 + v * 0.3, o + v}; // not convex
    if (!check_matrix(m, "m")) continue;
    const f64::Lobe lobe = lobe_of_matrix(m);
    const auto result = compare_spaces(lobe, corners, "polygon");
    if (!result) continue;
    ++compared;
    CHECK(std::abs(result->shading.integral - result->cosine.integral) < 1e-8);
    CHECK(std::abs(result->shading.integral - fit::integrate_lobe_over_polygon(lobe, corners)) <
          1e-8);
    CHECK(result->shading.inside == result->cosine.inside);
  }
}

TEST_CASE("samples inside are as many on both sides and as many as the integral says") {
  const auto result = compare_spaces(skewed_lobe(), k_card, "polygon", {20000, 7});
  REQUIRE(result.ok());
  CHECK(result->shading.inside_count == result->cosine.inside_count);
  CHECK(result->shading.inside == result->cosine.inside);
  const double share = double(result->shading.inside_count) / 20000;
  const double deviation = std::sqrt(share * (1 - share) / 20000);
  CHECK(std::abs(share - result->shading.integral) < 3 * deviation);
  // Both ways round, the same.
  std::vector<Vec3d> turned(k_card.rbegin(), k_card.rend());
  const auto other = compare_spaces(skewed_lobe(), turned, "polygon", {20000, 7});
  REQUIRE(other.ok());
  CHECK(other->shading.inside == result->shading.inside);
  CHECK(other->shading.integral == doctest::Approx(result->shading.integral));
}

TEST_CASE("what is kept lies above both horizons in both spaces") {
  const auto result = compare_spaces(skewed_lobe(), k_card, "polygon");
  REQUIRE(result.ok());
  CHECK(result->shading.kept.size() == 5); // both cut the lower edge and meet below it
  REQUIRE(result->shading.kept.size() == result->cosine.kept.size());
  for (const Vec3d& corner : result->shading.kept) {
    CHECK(corner.z > -1e-12);
    CHECK(dot(corner, result->horizon_normal_shading) > -1e-12);
  }
  for (const Vec3d& corner : result->cosine.kept) {
    CHECK(corner.z > -1e-12);
    CHECK(dot(corner, result->horizon_normal_cosine) > -1e-12);
  }
}

TEST_CASE("polygons that bound nothing are refused by name, in one line") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::vector<Vec3d>, std::string>> cases = {
      {{}, "three corners"},
      {{{1, 0, 1}, {0, 1, 1}}, "three corners"},
      {{{1, 0, 1}, {0, 1, 1}, {nan, 0, 1}}, "corner 3 is not finite"},
      {{{1, 0, 1}, {2, 0, 2}, {3, 0, 3}}, "on a line"},
      {{{1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1.2}}, "plane of the others"},
      {{{1, 0, 1}, {2, 0, 1}, {2, 0, 2}}, "holds the shaded point"},
      {{{1, 0, -1}, {0, 1, -1}, {-1, 0, -1}}, "below the surface's horizon"},
      {{{3, 0.2, 0.1}, {3, -0.2, 0.1}, {3, 0, 0.3}}, "below the cosine's horizon"},
      {{{-1, -1, 1}, {1, 1, 1}, {1, -1, 1}, {-1, 1.5, 1}}, "cross"},
  };
  for (const auto& [corners, part] : cases) {
    const std::string message = error_of(corners);
    CAPTURE(message);
    CHECK(message.rfind("--points: ", 0) == 0);
    CHECK(message.find(part) != std::string::npos);
    CHECK(message.find('\n') == std::string::npos);
  }
}
