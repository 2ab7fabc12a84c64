// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The formulas of the document that this project began with (docs/source_document.md), taken
// literally, fail the tests that the corrected ones pass. They are kept here and, for the figure of
// openltc plot literal, in openltc/plot/literal_formulas.h; nowhere else.

#include "openltc/target/shade_f64.h"
#include "tests/shade/sphere_quadrature.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace openltc;
using testing::SphereMap;

namespace {

// 0.1.1: G = 1 / (2 (lambda_o + lambda_i)), which already is G2 / (4 cos_o cos_i) ...
double literal_g(double cos_o, double cos_i, double alpha) {
  const double a2 = alpha * alpha;
  const double lambda_o = cos_i * std::sqrt((1 - a2) * cos_o * cos_o + a2);
  const double lambda_i = cos_o * std::sqrt((1 - a2) * cos_i * cos_i + a2);
  return 1 / (2 * (lambda_o + lambda_i));
}

const f64::Lobe k_lobe = f64::lobe_from_mirror(Vec4d(0.7, -0.4, 0.6, 1.3), 0.3, 0.7);

double integral_of(double (*f)(Vec3d)) {
  const Vec3d axis = normalize(f64::from_cosine(k_lobe, Vec3d(0, 0, 1)));
  return SphereMap(axis, 0.3).integrate(f, 500);
}

} // namespace

TEST_CASE("source: the denominator counted twice makes light") {
  const double alpha = 0.1, theta = 85 * f64::k_pi / 180;
  const Vec3d wo(std::sin(theta), 0, std::cos(theta));
  const SphereMap map(Vec3d(-wo.x, 0, wo.z), alpha);
  const double literal = map.integrate(
      [&](Vec3d wi) {
        if (wi.z <= 0) return 0.0;
        const Vec3d h = normalize(wo + wi);
        const double g = literal_g(wo.z, wi.z, alpha);
        return f64::ggx_distribution(h, alpha) * g / (4 * wo.z * wi.z) * wi.z;
      },
      800);
  const double correct =
      map.integrate([&](Vec3d wi) { return f64::eval_ggx_terms(wo, wi, alpha).scale; }, 800);
  CHECK(literal == doctest::Approx(14.7).epsilon(0.01));
  CHECK(correct == doctest::Approx(0.886).epsilon(0.001));
  // ... as the name "G" hides: the literal G is no share.
  CHECK(literal_g(0.1, 0.1, alpha) > 1);
  CHECK(literal_g(0.3, 0.6, alpha) ==
        doctest::Approx(f64::smith_visibility(0.3, 0.6, alpha)).epsilon(1e-12));
}

TEST_CASE("source: Schlick's exponent inside the bracket turns the curve over") {
  const double f0 = 0.04, cos_theta = 0.5;
  const double literal = f0 + (1 - f0) * (1 - std::pow(cos_theta, 5));
  const double correct = f64::schlick_fresnel(Vec3d(f0), Vec3d(1.0), cos_theta).x;
  CHECK(literal == doctest::Approx(0.970));
  CHECK(correct == doctest::Approx(0.070));
  // Both start at f0; at 40 degrees, where glass reflects 4 %, the literal curve is beyond 70 %.
  CHECK(f0 + (1 - f0) * (1 - std::pow(std::cos(0.7), 5)) > 0.7);
  CHECK(f64::schlick_fresnel(Vec3d(f0), Vec3d(1.0), std::cos(0.7)).x < 0.05);
}

TEST_CASE("source: k_s = F beside F in the numerator takes Fresnel twice") {
  const double f = f64::schlick_fresnel(Vec3d(0.04), Vec3d(1.0), 1.0).x;
  const Vec3d n(0, 0, 1);
  const double once = f64::eval_ggx(n, n, 0.3, Vec3d(0.04), Vec3d(1.0)).x;
  const double f1 = f64::eval_ggx_terms(n, n, 0.3).scale;
  CHECK(once == doctest::Approx(f * f1));
  CHECK(f * once == doctest::Approx(0.04 * 0.04 * f1)); // 25 times too dark at normal incidence
}

TEST_CASE("source: |M^-1| is the determinant; as a norm the lobe is no density") {
  const auto frobenius = [](Vec3d w) {
    const Vec3d o = f64::to_cosine(k_lobe, w);
    const double l = length(o);
    const f64::Lobe& m = k_lobe;
    const double norm =
        std::sqrt(m.m00 * m.m00 + m.m02 * m.m02 + 1 + m.m20 * m.m20 + m.m22 * m.m22);
    return std::max(0.0, o.z / l) / f64::k_pi * norm / (l * l * l);
  };
  const double with_norm = integral_of(frobenius);
  const double with_determinant = integral_of([](Vec3d w) { return f64::eval_lobe(k_lobe, w); });
  CHECK(with_norm > 3);
  CHECK(with_norm < 20);
  CHECK(with_determinant == doctest::Approx(1).epsilon(1e-4));
}

TEST_CASE("source: I_specular lacks 1/pi, and |M^-1 w| is no determinant either") {
  const double without_inv_pi = integral_of([](Vec3d w) {
    const Vec3d o = f64::to_cosine(k_lobe, w);
    const double l = length(o);
    return std::max(0.0, o.z) / l * k_lobe.det / (l * l * l);
  });
  CHECK(without_inv_pi == doctest::Approx(f64::k_pi).epsilon(1e-4));
  const double literal = integral_of([](Vec3d w) {
    const Vec3d o = f64::to_cosine(k_lobe, w);
    const double l = length(o);
    return std::max(0.0, o.z) / l * l / (l * l * l);
  });
  CHECK(literal > 3);
}

TEST_CASE("source: a linear map changes solid angles; what it keeps is the integral of the lobe") {
  // The part of the sphere within 20 degrees of the lobe's axis, before and after M^-1.
  const Vec3d axis = normalize(f64::from_cosine(k_lobe, Vec3d(0, 0, 1)));
  const double cos_cap = std::cos(0.35);
  const SphereMap map(axis, 0.3);
  const double solid_angle =
      map.integrate([&](Vec3d w) { return dot(w, axis) > cos_cap ? 1.0 : 0.0; }, 800);
  const double image = map.integrate(
      [&](Vec3d w) {
        const double l = length(f64::to_cosine(k_lobe, w));
        return dot(w, axis) > cos_cap ? k_lobe.det / (l * l * l) : 0.0;
      },
      800);
  CHECK(image > 3 * solid_angle);
  const double lobe_in_cap = map.integrate(
      [&](Vec3d w) { return dot(w, axis) > cos_cap ? f64::eval_lobe(k_lobe, w) : 0.0; }, 800);
  const double cosine_in_image =
      SphereMap(Vec3d(0, 0, 1), 0.7)
          .integrate(
              [&](Vec3d o) {
                const Vec3d w = normalize(f64::from_cosine(k_lobe, o));
                return dot(w, axis) > cos_cap ? f64::eval_lambert(o) : 0.0;
              },
              800);
  CHECK(lobe_in_cap == doctest::Approx(cosine_in_image).epsilon(2e-3));
}
