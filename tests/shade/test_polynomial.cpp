// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lobes from polynomials: the sum that is meant, close to the table they were made from, and safe
// for every input.

#include "openltc/target/shade_f32.h"
#include "openltc/target/shade_f64.h"
#include "tests/shade/polynomial_fixture.h"
#include "tests/shade/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace openltc;
using testing::Random;

TEST_CASE("the sum of terms T_i(u) T_j(v), by the cosine definition of T") {
  Random random(91);
  for (int degree = table::LobePolynomial::k_min_degree;
       degree <= table::LobePolynomial::k_max_degree; ++degree) {
    const table::LobePolynomial p =
        testing::polynomial_of_table(table::builtin_ggx_table(), degree);
    REQUIRE(int(p.coefficients.size()) == 8 * (degree + 1) * (degree + 2) / 2);
    for (int k = 0; k < 200; ++k) {
      const double roughness = random.uniform(0.01, 1), y = random.uniform();
      const double alpha = roughness * roughness, cos_theta = 1 - y * y;
      double sum[6] = {};
      for (int j = 0, term = 0; j <= degree; ++j)
        for (int i = 0; i <= degree - j; ++i, ++term)
          for (int channel = 0; channel < 6; ++channel)
            sum[channel] += double(p.term(term)[channel]) *
                            std::cos(i * std::acos(2 * roughness - 1)) *
                            std::cos(j * std::acos(2 * y - 1));
      const f64::FittedLobe f = f64::eval_lobe_polynomial(p.view(), alpha, cos_theta);
      const Vec4d abcd = f64::mirror_from_lobe(f.lobe, alpha, cos_theta);
      CHECK(std::abs(abcd.x - sum[0]) < 1e-9);
      CHECK(std::abs(abcd.y - sum[1]) < 1e-9);
      CHECK(std::abs(abcd.z - sum[2]) < 1e-9);
      CHECK(std::abs(abcd.w - sum[3]) < 1e-9);
      CHECK(std::abs(f.n1 - std::clamp(sum[4], 0.0, 1.0)) < 1e-12);
      CHECK(std::abs(f.n5 - f.n1 * std::pow(std::clamp(sum[5], 0.0, 1.0), 5)) < 1e-12);
      CHECK(f.lobe.det == doctest::Approx(f.lobe.m00 * f.lobe.m22 - f.lobe.m02 * f.lobe.m20)
                              .epsilon(1e-6)
                              .scale(alpha));
    }
  }
}

TEST_CASE("the second lobe: its own sum, and a weight of the tangent") {
  Random random(93);
  table::LobePolynomial p = table::builtin_ggx_two_lobe_polynomial();
  for (int k = 0; k < 200; ++k) {
    const double roughness = random.uniform(0.01, 1), y = random.uniform();
    const double alpha = roughness * roughness, cos_theta = 1 - y * y;
    double sum[5] = {};
    for (int j = 0, term = 0; j <= p.degree; ++j)
      for (int i = 0; i <= p.degree - j; ++i, ++term)
        for (int channel = 0; channel < 5; ++channel)
          sum[channel] += double(channel < 4 ? p.second_term(term)[channel] : p.term(term)[6]) *
                          std::cos(i * std::acos(2 * roughness - 1)) *
                          std::cos(j * std::acos(2 * y - 1));
    const f64::SecondLobe f = f64::eval_second_lobe_polynomial(p.view(), alpha, cos_theta);
    const Vec4d abcd = f64::mirror_from_lobe(f.lobe, alpha, cos_theta);
    CHECK(std::abs(abcd.x - sum[0]) < 1e-9);
    CHECK(std::abs(abcd.y - sum[1]) < 1e-9);
    CHECK(std::abs(abcd.z - sum[2]) < 1e-9);
    CHECK(std::abs(abcd.w - sum[3]) < 1e-9);
    CHECK(f.weight == doctest::Approx(0.5 + 0.5 * std::sin(std::atan(sum[4]))).epsilon(1e-12));
    const f32::SecondLobe g =
        f32::eval_second_lobe_polynomial(p.view(), float(alpha), float(cos_theta));
    CHECK(std::abs(double(g.weight) - f.weight) < 1e-5);
    CHECK(double(g.lobe.det) > 0);
  }
  CHECK(f64::lobe_polynomial_has_second(p.view()));
  CHECK_FALSE(f64::lobe_polynomial_has_second(table::builtin_ggx_polynomial().view()));
}

TEST_CASE("higher degrees come closer to the table's albedo") {
  const LobeTableView table = table::builtin_ggx_table().view();
  double before = 1;
  for (int degree = 3; degree <= 6; ++degree) {
    const table::LobePolynomial p =
        testing::polynomial_of_table(table::builtin_ggx_table(), degree);
    double error = 0;
    for (int i = 0; i < 40; ++i)
      for (int j = 0; j < 40; ++j) {
        const double alpha = f64::alpha_from_roughness((i + 0.5) / 40);
        const double cos_theta = 1 - std::pow((j + 0.5) / 40, 2);
        error += std::abs(f64::eval_lobe_polynomial(p.view(), alpha, cos_theta).n1 -
                          f64::fetch_lobe(table, alpha, cos_theta).n1) /
                 1600;
      }
    MESSAGE("degree " << degree << ": mean error of n1 " << error);
    CHECK(error < before);
    before = error;
  }
  CHECK(before < 0.005);
}

TEST_CASE("the built-in polynomial keeps its determinant away from 0") {
  const LobePolynomialView p = table::builtin_ggx_polynomial().view();
  double least = 1;
  for (int i = 0; i <= 500; ++i)
    for (int j = 0; j <= 500; ++j) {
      const double y = j / 500.0, alpha = f64::alpha_from_roughness(i / 500.0);
      least = std::min(least, f64::eval_lobe_polynomial(p, alpha, 1 - y * y).lobe.det / alpha);
    }
  MESSAGE("least determinant over alpha " << least);
  CHECK(least > 1e-7);
}

TEST_CASE("no input and no coefficients make NaN, infinities or amplitudes out of range") {
  Random random(92);
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inputs[] = {nan, -inf, -1, -0.0, 0, 1e-30, 1e-4, 0.3, 1, 1 + 1e-9, 7, inf};
  for (int round = 0; round < 50; ++round) {
    table::LobePolynomial p = table::builtin_ggx_two_lobe_polynomial();
    // Anything but a fit.
    if (round > 0)
      for (std::vector<float>* of : {&p.coefficients, &p.second})
        for (float& c : *of)
          c = float(random.uniform(-3, 3));
    for (const double alpha : inputs)
      for (const double cos_theta : inputs) {
        const auto check = [&](const auto& f, double smallest) {
          for (const double x : {double(f.lobe.m00), double(f.lobe.m02), double(f.lobe.m20),
                                 double(f.lobe.m22), double(f.lobe.det)})
            CHECK(std::isfinite(x));
          CHECK(double(f.lobe.det) >= smallest);
          CHECK((f.n1 >= 0 && f.n1 <= 1));
          CHECK((f.n5 >= 0 && f.n5 <= f.n1));
        };
        check(f64::eval_lobe_polynomial(p.view(), alpha, cos_theta), 1e-30);
        check(f32::eval_lobe_polynomial(p.view(), float(alpha), float(cos_theta)), 0.9e-30);
        const f64::SecondLobe second = f64::eval_second_lobe_polynomial(p.view(), alpha, cos_theta);
        CHECK((second.lobe.det >= 1e-30 && std::isfinite(second.lobe.det)));
        CHECK((second.weight >= 0 && second.weight <= 1));
      }
  }
}
