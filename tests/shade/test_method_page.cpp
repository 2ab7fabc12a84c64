// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The numbers of the example that docs/method.md works through: roughness 0.5, cos theta = 7/16.

#include "openltc/target/shade_f64.h"
#include "tests/shade/polygon_fixture.h"
#include "tests/shade/sphere_quadrature.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace openltc;
using testing::SphereMap;
using testing::TestPolygon;

namespace {

constexpr double k_alpha = 0.25, k_cos = 0.4375;
const Vec3d k_wo(std::sqrt(1 - k_cos * k_cos), 0, k_cos);
const Vec3d k_mirror(-k_wo.x, 0, k_wo.z);
const Vec3d k_up(0, 0, 1), k_origin(0.0), k_glass(0.04), k_white(1.0);

// The 18th texel that `openltc fit --size 5 --refine off` writes.
f64::FittedLobe example() {
  f64::FittedLobe fitted;
  fitted.lobe =
      f64::lobe_from_mirror(Vec4d(0.535271, -0.389188, 1.05757, 0.876323), k_alpha, k_cos);
  fitted.n1 = 0.848729;
  fitted.n5 = 0.0326748;
  return fitted;
}

f64::Surface surface(Vec3d f0) {
  return f64::make_surface(example(), k_origin, k_up, k_wo, k_origin, f0, k_white, 0.5);
}

double over_square(double half, Vec3d center, Vec3d u, Vec3d v, double (*f)(Vec3d)) {
  constexpr int n = 600;
  const Vec3d normal = cross(u, v);
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vec3d p =
          center + u * (half * (2 * (i + 0.5) / n - 1)) + v * (half * (2 * (j + 0.5) / n - 1));
      const double d2 = dot(p, p);
      sum += f(p / std::sqrt(d2)) * std::abs(dot(p, normal)) / (d2 * std::sqrt(d2));
    }
  return sum * 4 * half * half / (double(n) * n);
}

} // namespace

TEST_CASE("method: visibility and Fresnel of the example") {
  CHECK(1 / (4 * k_cos * k_cos) == doctest::Approx(1.306).epsilon(1e-3));
  const double overhead =
      f64::schlick_fresnel(k_glass, k_white, std::sqrt(0.5 + 0.5 * dot(k_wo, k_up))).x;
  CHECK(overhead == doctest::Approx(0.0401).epsilon(1e-3));
  const f64::FittedLobe fitted = example();
  const double albedo = f64::specular_amplitude(fitted, k_glass, k_white).x;
  CHECK(albedo == doctest::Approx(0.0653).epsilon(1e-3));
  CHECK(albedo / fitted.n1 == doctest::Approx(0.0770).epsilon(1e-3));
  CHECK(albedo / fitted.n1 / overhead == doctest::Approx(1.92).epsilon(1e-3));
}

TEST_CASE("method: matrix, amplitudes and share of the example") {
  const f64::FittedLobe fitted = example();
  const f64::Lobe& lobe = fitted.lobe;
  CHECK(lobe.m00 == doctest::Approx(0.3217).epsilon(1e-3));
  CHECK(lobe.m02 == doctest::Approx(0.4388).epsilon(1e-3));
  CHECK(lobe.m20 == doctest::Approx(-0.0813).epsilon(1e-3));
  CHECK(lobe.m22 == doctest::Approx(0.3336).epsilon(1e-3));
  CHECK(lobe.det == doctest::Approx(0.1430).epsilon(1e-3));
  CHECK(lobe.m22 / lobe.m00 == doctest::Approx(1.0371).epsilon(1e-4));
  CHECK(-lobe.m02 / lobe.m00 == doctest::Approx(-1.3640).epsilon(1e-4));
  CHECK(lobe.det / lobe.m00 == doctest::Approx(0.4445).epsilon(2e-4));
  CHECK(-lobe.m20 / lobe.m00 == doctest::Approx(0.2528).epsilon(3e-4));

  const SphereMap map(k_mirror, k_alpha);
  const auto integral = [&](auto part) {
    return map.integrate([&](Vec3d wi) { return part(f64::eval_ggx_terms(k_wo, wi, k_alpha)); },
                         500);
  };
  CHECK(integral([](f64::GgxTerms t) { return t.scale; }) ==
        doctest::Approx(fitted.n1).epsilon(1e-4));
  CHECK(integral([](f64::GgxTerms t) { return t.bias; }) ==
        doctest::Approx(fitted.n5).epsilon(1e-3));

  CHECK(f64::share_above_horizon(lobe) == doctest::Approx(0.98475).epsilon(1e-5));
  const double g = std::acos(f64::horizon_normal_cosine(lobe).z) * 180 / f64::k_pi;
  CHECK(g == doctest::Approx(14.19).epsilon(1e-3));

  // Read literally: a norm for the determinant, and |M^-1 w| for it.
  const double norm = std::sqrt(f64::lobe_stretch2(lobe));
  CHECK(norm / lobe.det == doctest::Approx(8.3).epsilon(5e-3));
  const Vec3d axis = normalize(f64::from_cosine(lobe, k_up));
  const double literal = SphereMap(axis, k_alpha)
                             .integrate(
                                 [&](Vec3d w) {
                                   const Vec3d o = f64::to_cosine(lobe, w);
                                   return std::max(0.0, o.z) / (length(o) * dot(o, o));
                                 },
                                 500);
  CHECK(literal == doctest::Approx(8.6).epsilon(5e-3));
}

TEST_CASE("method: the roughest GGX seen from above has the albedo 1 - ln 2") {
  const double albedo = SphereMap(k_up, 1).integrate(
      [&](Vec3d wi) { return f64::eval_ggx_terms(k_up, wi, 1).scale; }, 500);
  CHECK(albedo == doctest::Approx(1 - std::log(2.0)).epsilon(1e-4));
}

TEST_CASE("method: the distribution of GGX is a cosine under diag(alpha, alpha, 1)") {
  // M^-1 = diag(1/alpha, 1/alpha, 1), times alpha.
  const f64::Lobe round = f64::make_lobe(1, 0, 0, k_alpha);
  for (const Vec3d v : {Vec3d(0.2, 0.1, 0.9), Vec3d(0, 0, 1), Vec3d(-0.7, 0.4, 0.2)}) {
    const Vec3d h = normalize(v);
    CHECK(f64::eval_lobe(round, h) ==
          doctest::Approx(f64::ggx_distribution(h, k_alpha) * h.z).epsilon(1e-12));
  }
}

TEST_CASE("method: the limit of a mirror is GGX itself") {
  const double alpha = 1e-4;
  const f64::Lobe lobe = f64::lobe_from_mirror(Vec4d(k_cos, 0, 0.7, 2 * k_cos), alpha, k_cos);
  const Vec3d x(k_cos, 0, k_wo.x), y(0, 1, 0);
  for (const Vec2d e : {Vec2d(0, 0), Vec2d(0.5, 0.3), Vec2d(-2, 1), Vec2d(3, -4)}) {
    const Vec3d w = normalize(k_mirror + x * (alpha * e.x) + y * (alpha * e.y));
    CHECK(f64::eval_lobe(lobe, w) ==
          doctest::Approx(f64::eval_ggx_terms(k_wo, w, alpha).scale).epsilon(2e-3));
  }
}

TEST_CASE("method: the square overhead") {
  const TestPolygon square({testing::rectangle(2, 2)}, k_up, Vec3d(1, 0, 0), Vec3d(0, -1, 0));
  const f64::Surface metal = surface(k_white), glass = surface(k_glass);
  const f64::LightIntegral integral =
      f64::integrate_polygon(square.view(), k_origin, metal.frame, metal.fitted.lobe);
  CHECK(integral.diffuse ==
        doctest::Approx(4 * std::acos(1.0 / 3) / (2 * f64::k_pi * std::sqrt(2.0))));
  CHECK(integral.diffuse == doctest::Approx(0.5541).epsilon(1e-4));
  CHECK(integral.specular == doctest::Approx(0.3242).epsilon(2e-4));
  CHECK(f64::shade_integral(metal, integral).specular.x == doctest::Approx(0.2794).epsilon(3e-4));

  const Vec3d x(1, 0, 0), y(0, 1, 0);
  const double density =
      over_square(1, k_up, x, y, [](Vec3d w) { return f64::eval_lobe(example().lobe, w); });
  CHECK(density == doctest::Approx(integral.specular).epsilon(1e-5));
  const double truth = over_square(
      1, k_up, x, y, [](Vec3d w) { return f64::eval_ggx_terms(k_wo, w, k_alpha).scale; });
  CHECK(truth == doctest::Approx(0.2800).epsilon(5e-4));

  const double share = integral.specular * glass.inv_share;
  CHECK(f64::shade_integral(glass, integral).specular.x == doctest::Approx(0.0130).epsilon(5e-3));
  CHECK(glass.specular.x * share == doctest::Approx(0.0215).epsilon(3e-3));
  const double glass_truth = over_square(
      1, k_up, x, y, [](Vec3d w) { return f64::eval_ggx(k_wo, w, k_alpha, k_glass, k_white).x; });
  CHECK(glass_truth == doctest::Approx(0.0123).epsilon(4e-3));
}

TEST_CASE("method: a square in the mirror direction shrinks to a point light") {
  const f64::Surface metal = surface(k_white);
  const f64::Lobe& lobe = metal.fitted.lobe;
  const f64::Frame facing = f64::shading_frame(-k_mirror, k_up);
  const double expected[4][2] = {{0.3, 0.470}, {0.1, 0.874}, {0.03, 0.987}, {0.01, 0.9985}};
  for (const double(&pair)[2] : expected) {
    const double half = pair[0], ratio = pair[1];
    const TestPolygon square({testing::rectangle(2 * half, 2 * half)}, k_mirror, facing.t1,
                             facing.t2);
    const double solid_angle = 4 * std::asin(half * half / (1 + half * half));
    const double integral =
        f64::integrate_polygon(square.view(), k_origin, metal.frame, lobe).specular;
    CAPTURE(half);
    CHECK(integral / (f64::eval_lobe(lobe, k_mirror) * solid_angle) ==
          doctest::Approx(ratio).epsilon(1e-3));
  }
  CHECK(f64::eval_surface(metal, k_mirror).x == doctest::Approx(2.589).epsilon(3e-4));
  CHECK(f64::eval_surface_ltc(metal, k_mirror).x == doctest::Approx(2.603).epsilon(3e-4));
  CHECK(f64::eval_surface(metal, k_up).x == doctest::Approx(0.101).epsilon(5e-3));
  CHECK(f64::eval_surface_ltc(metal, k_up).x == doctest::Approx(0.142).epsilon(5e-3));
}
