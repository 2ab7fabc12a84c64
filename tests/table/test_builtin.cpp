// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What every reader of the built-in table relies on, between the nodes as well as at them.

#include "openltc/table/lobe_table.h"
#include "openltc/target/shade_f32.h"
#include "openltc/target/shade_f64.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace openltc;

namespace {

// Integral of the lobe over a half circle through both poles of the y axis, at the angle psi about
// it: w = cos l (sin psi, 0, cos psi) + sin l y. With k = |M^-1 (sin psi, 0, cos psi)| and
// tan l = k tan m the integrand is smooth in m however narrow the lobe.
double meridian(const f64::Lobe& lobe, double psi) {
  const double x = std::sin(psi), z = std::cos(psi);
  const double k = std::hypot(lobe.m00 * x + lobe.m02 * z, lobe.m20 * x + lobe.m22 * z);
  const int n = 32;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double t = std::tan(((i + 0.5) / n - 0.5) * f64::k_pi);
    const double cos_l = 1 / std::sqrt(1 + k * k * t * t);
    const Vec3d w(cos_l * x, cos_l * k * t, cos_l * z);
    // d omega = cos l dl dpsi, dl = k (1 + tan^2 m) cos^2 l dm
    sum += f64::eval_lobe(lobe, w) * cos_l * cos_l * cos_l * k * (1 + t * t);
  }
  return sum * f64::k_pi / n;
}

double simpson(const f64::Lobe& lobe, double a, double fa, double b, double fb, double c, double fc,
               double tolerance, int depth) {
  const double ac = (a + c) / 2, cb = (c + b) / 2;
  const double fac = meridian(lobe, ac), fcb = meridian(lobe, cb);
  const double whole = (b - a) / 6 * (fa + 4 * fc + fb);
  const double left = (c - a) / 6 * (fa + 4 * fac + fc), right = (b - c) / 6 * (fc + 4 * fcb + fb);
  if (depth == 0 || std::abs(left + right - whole) < tolerance) return left + right;
  return simpson(lobe, a, fa, c, fc, ac, fac, tolerance / 2, depth - 1) +
         simpson(lobe, c, fc, b, fb, cb, fcb, tolerance / 2, depth - 1);
}

// Integral of the lobe over the sphere: the half circle where o.z > 0 between its two ends, split
// at the lobe's axis.
double mass(const f64::Lobe& lobe) {
  const Vec3d axis = f64::from_cosine(lobe, Vec3d(0, 0, 1));
  double middle = std::atan2(axis.x, axis.z);
  double end = std::atan2(-lobe.m22, lobe.m20); // o.z = 0
  while (end < middle)
    end += f64::k_pi;
  double sum = 0, from = end - f64::k_pi;
  for (const double to : {middle, end}) {
    for (int i = 0; i < 8; ++i) {
      const double a = from + (to - from) * i / 8, b = from + (to - from) * (i + 1) / 8;
      const double c = (a + b) / 2;
      sum +=
          simpson(lobe, a, meridian(lobe, a), b, meridian(lobe, b), c, meridian(lobe, c), 1e-8, 30);
    }
    from = to;
  }
  return sum;
}

} // namespace

TEST_CASE("the built-in table says what it is") {
  const table::LobeTable& t = table::builtin_ggx_table();
  CHECK(t.columns == 64);
  CHECK(t.texels.size() == std::size_t(64 * 64 * 8));
  CHECK(t.metadata.brdf == "ggx");
  CHECK(t.metadata.command.find("openltc fit") == 0);
  CHECK(t.metadata.mean_tv > 0);
}

TEST_CASE("every interpolated lobe is finite with a positive determinant") {
  const table::LobeTable& t = table::builtin_ggx_table();
  const int n = 1009; // no multiple of the nodes' spacing
  double least = 1e9;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double alpha = f64::alpha_from_roughness(double(i) / (n - 1));
      const double y = double(j) / (n - 1);
      const double cos_theta = 1 - y * y;
      const f64::FittedLobe f = f64::fetch_lobe(t.view(), alpha, cos_theta);
      least = std::min(least, f.lobe.det / alpha);
      REQUIRE(f.lobe.det > 0);
      REQUIRE(std::isfinite(f.lobe.m00 + f.lobe.m02 + f.lobe.m20 + f.lobe.m22));
      REQUIRE(f.n1 > 0);
      REQUIRE(f.n1 <= 1.0);
      REQUIRE(f.n5 >= 0);
      REQUIRE(f.n5 <= f.n1);
      const f32::FittedLobe g = f32::fetch_lobe(t.view(), float(alpha), float(cos_theta));
      REQUIRE(g.lobe.det > 0.0f);
      REQUIRE(std::isfinite(f32::eval_lobe(g.lobe, Vec3f(0.6f, 0.0f, 0.8f))));
    }
  }
  MESSAGE("least determinant over alpha: ", least);
}

TEST_CASE("every interpolated lobe is a density: its integral over the sphere is 1") {
  const table::LobeTable& t = table::builtin_ggx_table();
  for (const double roughness : {0.0, 0.013, 0.05, 0.11, 0.234, 0.4, 0.571, 0.77, 0.995}) {
    for (const double theta : {0.0, 17.0, 38.0, 55.5, 71.0, 80.0, 86.0, 89.0, 89.9}) {
      const double alpha = f64::alpha_from_roughness(roughness);
      const double cos_theta = std::cos(theta * f64::k_pi / 180);
      const f64::FittedLobe f = f64::fetch_lobe(t.view(), alpha, cos_theta);
      CAPTURE(roughness);
      CAPTURE(theta);
      CHECK(mass(f.lobe) == doctest::Approx(1).epsilon(1e-6));
    }
  }
}

TEST_CASE(
    "the mirror end: the lobe is narrow, points to the mirror direction and keeps all light") {
  const table::LobeTable& t = table::builtin_ggx_table();
  for (const double theta : {0.0, 30.0, 60.0, 80.0}) {
    const double cos_theta = std::cos(theta * f64::k_pi / 180);
    const double alpha = f64::alpha_from_roughness(0.0);
    const f64::FittedLobe f = f64::fetch_lobe(t.view(), alpha, cos_theta);
    const Vec3d axis = normalize(f64::from_cosine(f.lobe, Vec3d(0, 0, 1)));
    CHECK(axis.x == doctest::Approx(-std::sin(theta * f64::k_pi / 180)).epsilon(1e-3));
    CHECK(f.n1 == doctest::Approx(1).epsilon(1e-3));
    CHECK(f.n5 == doctest::Approx(std::pow(1 - cos_theta, 5)).epsilon(5e-3));
  }
}
