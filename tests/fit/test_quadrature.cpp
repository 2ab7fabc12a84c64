// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The fitter's quadrature against finer rules and against another method.

#include "openltc/fit/quadrature.h"
#include "openltc/target/shade_f64.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>

using namespace openltc;

namespace {

const brdf::Brdf& ggx() { return *brdf::find_brdf("ggx"); }

double radians(double degrees) { return degrees * f64::k_pi / 180; }

// n1 and n5 by a plain product rule over the angles of wi, without any importance.
brdf::BrdfValue product_rule(double roughness, double theta, int n) {
  const Vec3d wo(std::sin(theta), 0, std::cos(theta));
  brdf::BrdfValue sum;
  for (int i = 0; i < n; ++i) {
    const double ti = (i + 0.5) / n * f64::k_pi / 2;
    for (int j = 0; j < n; ++j) {
      const double phi = (j + 0.5) / n * f64::k_pi;
      const Vec3d wi(std::sin(ti) * std::cos(phi), std::sin(ti) * std::sin(phi), std::cos(ti));
      const brdf::BrdfValue value = ggx().eval(wo, wi, roughness);
      const double area = std::sin(ti) * f64::k_pi * f64::k_pi / (double(n) * n);
      sum.scale += value.scale * area;
      sum.bias += value.bias * area;
    }
  }
  return sum;
}

} // namespace

TEST_CASE("the registry finds what it has") {
  CHECK(brdf::find_brdf("ggx") != nullptr);
  CHECK(brdf::find_brdf("no such") == nullptr);
  for (const brdf::Brdf& b : brdf::all_brdfs())
    CHECK(brdf::find_brdf(b.name) == &b);
}

TEST_CASE("n1 and n5 agree with a product rule over angles") {
  for (const double roughness : {0.4, 0.6, 0.8, 1.0}) {
    for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
      const fit::Quadrature q =
          *fit::make_quadrature(ggx(), roughness, std::cos(radians(degrees)), {24, 24});
      const brdf::BrdfValue exact = product_rule(roughness, radians(degrees), 1500);
      CAPTURE(roughness);
      CAPTURE(degrees);
      CHECK(std::abs(q.n1 - exact.scale) < 2e-5);
      CHECK(std::abs(q.n5 - exact.bias) < 2e-5);
    }
  }
}

TEST_CASE("accuracy of n1 and n5, whole range") {
  double worst1 = 0, worst5 = 0, mean1 = 0;
  int count = 0;
  for (const double roughness : {0.0, 0.02, 0.1, 0.35, 0.7, 1.0}) {
    for (const double degrees : {0.0, 35.0, 75.0, 88.0, 89.9}) {
      const double c = std::cos(radians(degrees));
      const fit::Quadrature coarse = *fit::make_quadrature(ggx(), roughness, c, {20, 20});
      const fit::Quadrature fine = *fit::make_quadrature(ggx(), roughness, c, {200, 200});
      worst1 = std::max(worst1, std::abs(coarse.n1 - fine.n1));
      worst5 = std::max(worst5, std::abs(coarse.n5 - fine.n5));
      mean1 += std::abs(coarse.n1 - fine.n1);
      ++count;
    }
  }
  MESSAGE("20 x 20 points: n1 largest ", worst1, ", mean ", mean1 / count, "; n5 largest ", worst5);
  CHECK(worst1 < 2e-5);
  CHECK(mean1 / count < 1e-6);
  CHECK(worst5 < 2e-5);
}

TEST_CASE("the quadrature's points lie above the surface and their density is normalised") {
  for (const double roughness : {0.0, 0.3, 1.0}) {
    for (const double c : {1.0, 0.5, 0.01}) {
      const fit::Quadrature q = *fit::make_quadrature(ggx(), roughness, c, {24, 24});
      const double s = std::sqrt(1 - c * c);
      double mass = 0;
      for (std::size_t i = 0; i < q.size(); ++i) {
        REQUIRE(q.weight[i] >= 0);
        REQUIRE(q.y[i] >= 0);
        CHECK(s * q.x_mirror[i] + c * q.z_mirror[i] > 0);
        mass += q.weight[i] * q.density[i];
      }
      CHECK(mass == doctest::Approx(1).epsilon(1e-12));
    }
  }
}

TEST_CASE("every built-in BRDF settles, and what cannot be found is refused") {
  for (const brdf::Brdf& b : brdf::all_brdfs()) {
    CAPTURE(b.name);
    CHECK(fit::choose_quadrature(b).ok());
  }
  CHECK(fit::choose_quadrature(ggx())->radial == 20);
  // A narrow retroreflection lies nowhere near the half vectors that the rule crowds around.
  const auto retro = brdf::brdf_from_function("retro", [](Vec3d wo, Vec3d wi, double) {
    return std::pow(std::max(dot(wo, wi), 0.0), 4000.0);
  });
  const Result<fit::QuadratureSize> refused = fit::choose_quadrature(retro);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message.find("brdf retro: ") == 0);
}

TEST_CASE("a BRDF that throws or has no function becomes an error") {
  const auto throws = brdf::brdf_from_function(
      "throws", [](Vec3d, Vec3d, double) -> double { throw std::runtime_error("no such file"); });
  const Result<fit::Quadrature> thrown = fit::make_quadrature(throws, 0.5, 0.5, {8, 8});
  REQUIRE_FALSE(thrown);
  CHECK(thrown.error().message.find("no such file") != std::string::npos);
  brdf::Brdf empty;
  empty.name = "empty";
  CHECK_FALSE(fit::make_quadrature(empty, 0.5, 0.5, {8, 8}).ok());
  CHECK_FALSE(fit::choose_quadrature(empty).ok());
}

TEST_CASE("a BRDF of batches is asked once for all directions above the surface") {
  int calls = 0;
  const auto lambert = brdf::brdf_from_batch(
      "lambert", [&](Vec3d wo, std::span<const Vec3d> wi, double, std::span<double> values) {
        ++calls;
        REQUIRE(values.size() == wi.size());
        for (std::size_t i = 0; i < wi.size(); ++i)
          values[i] = wo.z > 0 && wi[i].z > 0 ? f64::k_inv_pi : -1;
      });
  const fit::HalfVectors half_vectors = fit::find_half_vectors(lambert, 0.5);
  calls = 0;
  const Result<fit::Quadrature> rule =
      fit::make_quadrature(lambert, 0.5, std::cos(radians(50)), half_vectors, {20, 32});
  REQUIRE(rule);
  CHECK(calls == 1);
  CHECK(rule->n1 == doctest::Approx(1).epsilon(1e-4)); // it reflects all
  CHECK(lambert.eval(Vec3d(0, 0, 1), Vec3d(0.6, 0, 0.8), 0.5).scale ==
        doctest::Approx(0.8 * f64::k_inv_pi));
}
