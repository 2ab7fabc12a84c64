// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lobes without a table: their error, and the proof that none of them turns inside out.

#include "openltc/fit/polynomial_fit.h"
#include "openltc/table/polynomial_file.h"
#include "openltc/target/shade_f64.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

using namespace openltc;

namespace {

const brdf::Brdf& ggx() { return *brdf::find_brdf("ggx"); }

double mean_tv(const table::LobePolynomial& p, double from, double to) {
  fit::MeasureOptions options;
  options.roughness_from = from;
  options.roughness_to = to;
  options.horizon = fit::Horizon::clipped;
  return fit::measure_lobes(ggx(), fit::lobes_of(p), options)->mean.tv;
}

// Least A D - alpha B C on a grid, from the stored numbers by Chebyshev's recurrence in cosines.
double least_on_grid(const table::LobePolynomial& p, int n, bool second = false) {
  double least = 1e30;
  for (int a = 0; a <= n; ++a) {
    for (int b = 0; b <= n; ++b) {
      const double x = 0.01 + 0.99 * a / n, y = double(b) / n;
      const double s = std::acos(2 * x - 1), t = std::acos(2 * y - 1);
      double c[4] = {};
      int term = 0;
      for (int j = 0; j <= p.degree; ++j)
        for (int i = 0; i <= p.degree - j; ++i, ++term)
          for (int k = 0; k < 4; ++k)
            c[k] += double(second ? p.second_term(term)[k] : p.term(term)[k]) * std::cos(i * s) *
                    std::cos(j * t);
      least = std::min(least, c[0] * c[3] - x * x * c[1] * c[2]);
    }
  }
  return least;
}

} // namespace

TEST_CASE("polynomials of degree 3 to 6: error and certificate") {
  for (int degree = 3; degree <= 6; ++degree) {
    fit::PolynomialFitOptions options;
    options.degree = degree;
    const Result<fit::PolynomialFit> fitted = fit::fit_polynomial(ggx(), options);
    REQUIRE(fitted);
    const table::LobePolynomial& p = fitted->polynomial;
    CHECK(p.coefficients.size() == std::size_t(table::polynomial_terms(degree)) * 8);
    const double rough = mean_tv(p, 0.06, 1), sharp = mean_tv(p, 0.01, 0.06);
    MESSAGE("degree ", degree, ": mean TV ", rough, ", low roughness ", sharp,
            ", determinant at least ", fitted->certificate.lower_bound, " by ",
            fitted->certificate.boxes, " boxes");
    CHECK(rough < (degree == 3 ? 0.050 : 0.045));
    CHECK(sharp < (degree == 3 ? 0.014 : degree < 6 ? 0.0070 : 0.0075));
    // The bound is proven, so no value lies below it, and sharp, so one comes close.
    const double seen = least_on_grid(p, 300);
    CHECK(fitted->certificate.lower_bound > 0);
    CHECK(seen >= fitted->certificate.lower_bound);
    CHECK(fitted->certificate.lower_bound > 0.8 * fitted->certificate.smallest_seen);
    CHECK(fitted->certificate.smallest_seen >= fitted->certificate.lower_bound);
  }
}

TEST_CASE("polynomials of two lobes: error and certificate of both") {
  const double most[] = {0.0225, 0.0195, 0.0185, 0.0185},
               most_sharp[] = {0.005, 0.003, 0.003, 0.004};
  for (int degree = 3; degree <= 6; ++degree) {
    fit::PolynomialFitOptions options;
    options.degree = degree;
    options.two_lobes = true;
    const Result<fit::PolynomialFit> fitted = fit::fit_polynomial(ggx(), options);
    REQUIRE(fitted);
    const table::LobePolynomial& p = fitted->polynomial;
    REQUIRE(p.second.size() == std::size_t(table::polynomial_terms(degree)) * 4);
    const double rough = mean_tv(p, 0.06, 1), sharp = mean_tv(p, 0.01, 0.06);
    MESSAGE("degree ", degree, ": mean TV ", rough, ", low roughness ", sharp,
            ", determinants at least ", fitted->certificate.lower_bound);
    CHECK(rough < most[degree - 3]);
    CHECK(sharp < most_sharp[degree - 3]);
    const double seen = std::min(least_on_grid(p, 200), least_on_grid(p, 200, true));
    CHECK(fitted->certificate.lower_bound > 0);
    CHECK(seen >= fitted->certificate.lower_bound);
  }
}

TEST_CASE("the built-in polynomial of two lobes regenerates byte for byte, on any threads") {
  const table::LobePolynomial& builtin = table::builtin_ggx_two_lobe_polynomial();
  for (const std::size_t count : {1, 4}) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, count);
    fit::PolynomialFitOptions options;
    options.two_lobes = true;
    Result<fit::PolynomialFit> fitted = fit::fit_polynomial(ggx(), options);
    REQUIRE(fitted);
    fitted->polynomial.metadata = builtin.metadata;
    const bool same = table::to_json(fitted->polynomial) == table::to_json(builtin);
    CHECK_MESSAGE(same, "run tools/make_builtin_lobes.sh, or undo what changed the fit");
  }
  fit::MeasureOptions region;
  region.horizon = fit::Horizon::clipped;
  const auto error = fit::measure_lobes(ggx(), fit::lobes_of(builtin), region);
  REQUIRE(error);
  CHECK(builtin.metadata.mean_tv == doctest::Approx(error->mean.tv).epsilon(1e-3));
}

TEST_CASE("polynomials of two lobes fit every kind of BRDF better than those of one") {
  for (const char* name : {"charlie", "eon", "beckmann"}) {
    CAPTURE(std::string(name));
    const brdf::Brdf& brdf = *brdf::find_brdf(name);
    fit::MeasureOptions region;
    region.horizon = fit::Horizon::clipped;
    region.points = 12;
    double tv[2] = {};
    for (int k = 0; k < 2; ++k) {
      fit::PolynomialFitOptions options;
      options.two_lobes = k == 1;
      const Result<fit::PolynomialFit> fitted = fit::fit_polynomial(brdf, options);
      REQUIRE(fitted);
      CHECK(fitted->certificate.lower_bound > 0);
      tv[k] = fit::measure_lobes(brdf, fit::lobes_of(fitted->polynomial), region)->mean.tv;
    }
    CHECK(tv[1] < 0.9 * tv[0]);
  }
}

TEST_CASE("the certificate denies what is not so") {
  Result<fit::PolynomialFit> fitted = fit::fit_polynomial(ggx(), {});
  REQUIRE(fitted);
  table::LobePolynomial& p = fitted->polynomial;
  p.term(0)[3] -= 0.02f; // D a little too small: wrong only near grazing angles
  const fit::Certificate denied = fit::certify_determinant(p);
  CHECK(least_on_grid(p, 300) < 0);
  CHECK(denied.lower_bound < 0);
  CHECK(denied.smallest_seen < 0);

  // Of a second lobe alone.
  table::LobePolynomial two = table::builtin_ggx_two_lobe_polynomial();
  CHECK(fit::certify_determinant(two).lower_bound > 0);
  two.second[7] -= 0.5f;
  two.second[3] -= 1.0f;
  CHECK(least_on_grid(two, 300, true) < 0);
  CHECK(fit::certify_determinant(two).lower_bound < 0);
}

TEST_CASE("polynomial amplitudes are albedos, of dielectrics too") {
  for (const int degree : {4, 6}) {
    fit::PolynomialFitOptions options;
    options.degree = degree;
    const Result<fit::PolynomialFit> fitted = fit::fit_polynomial(ggx(), options);
    REQUIRE(fitted);
    const fit::LobeFunction lobes = fit::lobes_of(fitted->polynomial);
    double mean1 = 0, mean5 = 0, mean = 0, most = 0;
    int count = 0;
    for (double roughness = 0.03; roughness < 1; roughness += 0.06) {
      for (double y = 0.03; y < 0.955; y += 0.06) { // to 85 degrees
        const double c = 1 - y * y;
        const fit::Quadrature q = *fit::make_quadrature(ggx(), roughness, c, {20, 20});
        const f64::FittedLobe lobe = lobes(roughness, c);
        const double albedo = 0.04 * q.n1 + 0.96 * q.n5;
        const double relative = std::abs(0.04 * lobe.n1 + 0.96 * lobe.n5 - albedo) / albedo;
        mean1 += std::abs(lobe.n1 - q.n1);
        mean5 += std::abs(lobe.n5 - q.n5);
        mean += relative;
        most = std::max(most, relative);
        ++count;
      }
    }
    MESSAGE("degree ", degree, ": mean error of n1 ", mean1 / count, ", of n5 ", mean5 / count,
            "; albedo at F0 = .04: mean ", mean / count, ", largest ", most, " of it");
    CHECK(mean1 / count < 0.012);
    CHECK(mean5 / count < 0.012);
    CHECK(mean / count < 0.03);
    CHECK(most < 0.2);
  }
}

TEST_CASE("wrong degrees and wrong BRDFs are refused in one line") {
  for (const int degree : {-1, 0, 2, 7}) {
    fit::PolynomialFitOptions options;
    options.degree = degree;
    const Result<fit::PolynomialFit> fitted = fit::fit_polynomial(ggx(), options);
    REQUIRE_FALSE(fitted);
    CHECK(fitted.error().message.find("degree") != std::string::npos);
  }
  const auto nothing =
      brdf::brdf_from_function("nothing", [](Vec3d, Vec3d, double) { return 0.0; });
  const Result<fit::PolynomialFit> fitted = fit::fit_polynomial(nothing, {});
  REQUIRE_FALSE(fitted);
  CHECK(fitted.error().message.find("reflects nothing") != std::string::npos);
}
