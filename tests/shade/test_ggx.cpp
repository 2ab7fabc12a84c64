// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Physical properties of the GGX BRDF.

#include "openltc/target/shade_f32.h"
#include "openltc/target/shade_f64.h"
#include "tests/shade/random.h"
#include "tests/shade/sphere_quadrature.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace openltc;
using testing::Random;
using testing::SphereMap;

namespace {

Vec3d view(double theta_degrees) {
  const double theta = theta_degrees * f64::k_pi / 180;
  return Vec3d(std::sin(theta), 0, std::cos(theta));
}

// Directional albedo for F = 1 by quadrature over wi, points around the mirror direction.
double albedo_by_quadrature(Vec3d wo, double alpha, int n) {
  const SphereMap map(Vec3d(-wo.x, 0, wo.z), alpha);
  return map.integrate([&](Vec3d wi) { return f64::eval_ggx_terms(wo, wi, alpha).scale; }, n);
}

} // namespace

TEST_CASE("the projected area of the microfacets is 1") {
  for (const double alpha : {1e-4, 1e-3, 0.01, 0.1, 0.3, 0.7, 1.0}) {
    const SphereMap map(Vec3d(0, 0, 1), alpha);
    const double area = map.integrate(
        [&](Vec3d h) { return h.z > 0 ? f64::ggx_distribution(h, alpha) * h.z : 0.0; }, 600);
    CAPTURE(alpha);
    CHECK(area == doctest::Approx(1).epsilon(1e-4));
  }
}

TEST_CASE("white furnace: sampling and quadrature agree, and no light is made") {
  for (const double alpha : {0.01, 0.05, 0.1, 0.3, 0.6, 1.0}) {
    for (const double theta : {0.0, 20.0, 45.0, 70.0, 85.0}) {
      const Vec3d wo = view(theta);
      const double quadrature = albedo_by_quadrature(wo, alpha, 800);
      double sampled = 0;
      const int n = 256;
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const Vec3d wi = f64::sample_ggx(wo, alpha, Vec2d((i + 0.5) / n, (j + 0.5) / n));
          const double pdf = f64::pdf_ggx(wo, wi, alpha);
          if (pdf > 0) sampled += f64::eval_ggx_terms(wo, wi, alpha).scale / pdf;
        }
      }
      sampled /= double(n) * n;
      CAPTURE(alpha);
      CAPTURE(theta);
      CHECK(sampled == doctest::Approx(quadrature).epsilon(1e-3));
      CHECK(sampled <= 1.0);
      CHECK(quadrature <= 1.0 + 1e-4);
    }
  }
  CHECK(albedo_by_quadrature(view(85), 0.1, 800) == doctest::Approx(0.886).epsilon(1e-3));
}

TEST_CASE("exchanging the two directions leaves the BRDF as it is") {
  Random random(31);
  for (int i = 0; i < 10000; ++i) {
    const Vec3d a = random.hemisphere(), b = random.hemisphere();
    const double alpha = random.log_uniform(1e-4, 1);
    const Vec3d f0(0.04, 0.5, 0.9), f90(1, 1, 1);
    const Vec3d ab = f64::eval_ggx(a, b, alpha, f0, f90) / b.z;
    const Vec3d ba = f64::eval_ggx(b, a, alpha, f0, f90) / a.z;
    CHECK(ab.x == doctest::Approx(ba.x).epsilon(1e-10));
    CHECK(ab.z == doctest::Approx(ba.z).epsilon(1e-10));
  }
}

TEST_CASE("visibility is masking over its denominator, and masking is a share") {
  Random random(32);
  for (int i = 0; i < 10000; ++i) {
    const double cos_o = random.uniform(1e-3, 1), cos_i = random.uniform(1e-3, 1);
    const double alpha = random.log_uniform(1e-4, 1);
    const double g2 = f64::smith_g2(cos_o, cos_i, alpha);
    CHECK(g2 / (4 * cos_o * cos_i) ==
          doctest::Approx(f64::smith_visibility(cos_o, cos_i, alpha)).epsilon(1e-12));
    CHECK(g2 >= 0);
    CHECK(g2 <= 1 + 1e-12);
  }
}

TEST_CASE("the sampling density holds what the horizon leaves") {
  for (const double alpha : {0.05, 0.2, 0.5, 1.0}) {
    for (const double theta : {0.0, 40.0, 75.0, 88.0}) {
      const Vec3d wo = view(theta);
      const SphereMap map(Vec3d(-wo.x, 0, wo.z), alpha);
      const double mass = map.integrate([&](Vec3d wi) { return f64::pdf_ggx(wo, wi, alpha); }, 800);
      // Share of samples that stay above the horizon.
      int above = 0;
      const int n = 400;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          above += f64::sample_ggx(wo, alpha, Vec2d((i + 0.5) / n, (j + 0.5) / n)).z > 0;
      CAPTURE(alpha);
      CAPTURE(theta);
      CHECK(mass <= 1.0 + 1e-3);
      CHECK(mass == doctest::Approx(double(above) / (n * n)).epsilon(3e-3));
    }
  }
}

TEST_CASE("Schlick's Fresnel runs from f0 at normal to f90 at grazing") {
  const Vec3d f0(0.04, 0.2, 0.9), f90(1, 0.8, 1);
  CHECK(f64::schlick_fresnel(f0, f90, 1.0).x == doctest::Approx(0.04));
  CHECK(f64::schlick_fresnel(f0, f90, 0.0).y == doctest::Approx(0.8));
  CHECK(f64::schlick_fresnel(f0, f90, 0.5).x == doctest::Approx(0.04 + 0.96 / 32));
  CHECK(f64::schlick_fresnel(f0, f90, 1.0 + 1e-6).z == doctest::Approx(0.9));
}

TEST_CASE("single precision carries the BRDF down to the least alpha") {
  Random random(33);
  for (int i = 0; i < 100000; ++i) {
    const double alpha = random.log_uniform(1e-4, 1);
    const double theta = random.uniform(0, 1.5);
    const Vec3d wo(std::sin(theta), 0, std::cos(theta));
    const Vec3f wo32(float(wo.x), 0.0f, float(wo.z));
    const Vec2d u = random.square();
    const Vec3f wi32 = f32::sample_ggx(wo32, float(alpha), Vec2f(float(u.x), float(u.y)));
    const f32::GgxTerms terms = f32::eval_ggx_terms(wo32, wi32, float(alpha));
    const float pdf = f32::pdf_ggx(wo32, wi32, float(alpha));
    REQUIRE(std::isfinite(terms.scale));
    REQUIRE(terms.scale >= 0.0f);
    REQUIRE(terms.bias >= 0.0f);
    REQUIRE(terms.bias <= terms.scale);
    REQUIRE(std::isfinite(pdf));
    // The weight of a visible-normal sample is G2/G1, a share, whatever the rounding of D.
    if (pdf > 0) CHECK(terms.scale / pdf <= 1.001f);
  }
}
