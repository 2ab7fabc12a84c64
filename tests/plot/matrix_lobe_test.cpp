// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/matrix_lobe.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

using namespace openltc;
using namespace openltc::plot;

namespace {

LobeMatrix random_matrix(std::mt19937& engine) {
  std::uniform_real_distribution<double> spread(-1, 1);
  for (;;) {
    const LobeMatrix m{std::exp(2 * spread(engine) - 1), 1.5 * spread(engine),
                       std::exp(2 * spread(engine) - 1), 0.7 * spread(engine)};
    if (check_matrix(m, "m")) return m;
  }
}

} // namespace

TEST_CASE("every lobe integrates to 1 over the sphere of shading space") {
  std::mt19937 engine(1);
  for (int i = 0; i < 100; ++i) {
    const LobeMatrix m = random_matrix(engine);
    CAPTURE(m.a);
    CAPTURE(m.b);
    CAPTURE(m.c);
    CAPTURE(m.d);
    CHECK(std::abs(lobe_facts(lobe_of_matrix(m)).integral - 1) < 1e-8);
  }
  for (const LobeMatrix m : {LobeMatrix{0.01, 0, 0.01, 0}, LobeMatrix{1, 0, 0.01, 0},
                             LobeMatrix{0.01, 0, 1, 0}, LobeMatrix{10, 3, 0.1, 1}})
    CHECK(std::abs(lobe_facts(lobe_of_matrix(m)).integral - 1) < 1e-8);
}

TEST_CASE("the lobe of a matrix has that matrix") {
  std::mt19937 engine(2);
  for (int i = 0; i < 50; ++i) {
    const LobeMatrix m = random_matrix(engine);
    const f64::Lobe lobe = lobe_of_matrix(m);
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3d o(axis == 0, axis == 1, axis == 2);
      const Vec3d back = f64::to_cosine(lobe, column(m, axis));
      // M^-1 is known up to a scale: the middle row is 1, so the scale is c.
      CHECK(length(back - o * m.c) < 1e-12);
    }
    const auto again = matrix_of_lobe(lobe);
    REQUIRE(again.ok());
    CHECK(again->a == doctest::Approx(m.a));
    CHECK(again->b == doctest::Approx(m.b));
    CHECK(again->c == doctest::Approx(m.c));
    CHECK(again->d == doctest::Approx(m.d));
    CHECK(determinant(m) == doctest::Approx(dot(column(m, 0), cross(column(m, 1), column(m, 2)))));
  }
}

TEST_CASE("no direction is denser than the peak, which the facts name") {
  std::mt19937 engine(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 20; ++i) {
    const f64::Lobe lobe = lobe_of_matrix(random_matrix(engine));
    const LobeFacts facts = lobe_facts(lobe);
    CHECK(f64::eval_lobe(lobe, facts.peak_direction) == doctest::Approx(facts.peak));
    double densest = 0;
    for (int k = 0; k < 20000; ++k) {
      const Vec3d w = normalize(Vec3d(normal(engine), normal(engine), normal(engine)));
      densest = std::max(densest, f64::eval_lobe(lobe, w));
    }
    CHECK(densest <= facts.peak * (1 + 1e-9));
  }
  // Of the cosine everything is known.
  const LobeFacts cosine = lobe_facts(f64::cosine_lobe());
  CHECK(cosine.peak == doctest::Approx(f64::k_inv_pi));
  CHECK(cosine.above == doctest::Approx(1));
  CHECK(length(cosine.mean_direction - Vec3d(0, 0, 1)) < 1e-9);
}

TEST_CASE("matrices that make no lobe are refused by the name of their option") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const LobeMatrix m :
       {LobeMatrix{nan, 0, 1, 0}, LobeMatrix{1, infinity, 1, 0}, LobeMatrix{1, 0, -nan, 0},
        LobeMatrix{1, 0, 1, 1e9}, LobeMatrix{1, 1, 1, 1}, LobeMatrix{0, 0, 1, 0},
        LobeMatrix{1, 0, 0, 0}, LobeMatrix{-1, 0, 1, 0}, LobeMatrix{1, 0, -1, 0},
        LobeMatrix{-1, 0, -1, 0}, LobeMatrix{1e-9, 0, 1, 0}}) {
    const Status status = check_matrix(m, "--matrix x");
    REQUIRE(!status.ok());
    CHECK(status.error().message.rfind("--matrix x: ", 0) == 0);
    CHECK(status.error().message.find('\n') == std::string::npos);
  }
  CHECK(check_matrix({}, "m").ok());
}
