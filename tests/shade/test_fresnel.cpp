// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Which Fresnel reflectance the light of a polygon meets: that of its own direction, against the
// exact BRDF integrated over the polygon.

#include "openltc/table/lobe_table.h"
#include "polygon_fixture.h"
#include "random.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace openltc;
using testing::Random;
using testing::TestPolygon;

namespace {

// The specular integral over a rectangle of half sides a, b by midpoints; fine against the lobes
// used here, of roughness 0.2 and more.
double exact_specular(const f64::Surface& s, Vec3d center, Vec3d u, Vec3d v, double a, double b) {
  constexpr int n = 160;
  const Vec3d normal = cross(u, v);
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vec3d q =
          center + u * (a * (2 * (i + 0.5) / n - 1)) + v * (b * (2 * (j + 0.5) / n - 1));
      const Vec3d d = q - s.position;
      const double distance2 = dot(d, d);
      const Vec3d wi = d / std::sqrt(distance2);
      const double cos_light = -dot(wi, normal);
      if (cos_light <= 0) continue;
      sum += f64::eval_ggx(s.wo, f64::to_shading(s.frame, wi), s.alpha, s.f0, s.f90).x * cos_light /
             distance2;
    }
  return sum * 4 * a * b / (n * n);
}

// A point at the origin, normal up, without diffuse part.
f64::Surface surface(LobeTableView table, Vec3d wo, Vec3d f0, double roughness) {
  const f64::FittedLobe fitted = f64::fetch_lobe(table, f64::alpha_from_roughness(roughness), wo.z);
  return f64::make_surface(fitted, Vec3d(0.0), Vec3d(0, 0, 1), wo, Vec3d(0.0), f0, Vec3d(1.0),
                           roughness);
}

} // namespace

TEST_CASE("dielectrics: the Fresnel of the light's direction, not the lobe's average") {
  Random random(17);
  const LobeTableView table = table::builtin_ggx_table().view();
  const Vec3d none(0.0), f0(0.04), white(1.0);
  double spread_error = 0, own_error = 0, fit_error = 0, total = 0, fit_total = 0;
  for (int i = 0; i < 400; ++i) {
    const double theta = random.uniform(0.3, 1.45);
    const Vec3d wo(std::sin(theta), 0, std::cos(theta));
    const double roughness = random.uniform(0.2, 1.0);
    const f64::Surface s = surface(table, wo, f0, roughness);
    const f64::Surface metal = surface(table, wo, white, roughness);

    // A rectangle somewhere above, facing the point.
    const Vec3d towards = normalize(random.hemisphere() + Vec3d(0, 0, 0.2));
    const f64::Frame plane = f64::shading_frame(-towards, Vec3d(0, 0, 1));
    const double a = random.uniform(0.1, 0.8), b = random.uniform(0.1, 0.8);
    const Vec3d center = towards * 2.0;
    const testing::Ring ring = {Vec2d(-a, -b), Vec2d(a, -b), Vec2d(a, b), Vec2d(-a, b)};
    const TestPolygon polygon({ring}, center, plane.t1, plane.t2);

    const f64::LightIntegral integral =
        f64::integrate_polygon(polygon.view(), none, s.frame, s.fitted.lobe);
    const double exact = exact_specular(s, center, plane.t1, plane.t2, a, b);
    const double share = integral.specular * s.inv_share;
    const double own = f64::specular_reflectance(s, integral.specular_direction, share).x;
    const double spread = s.specular.x * share;
    own_error += std::abs(own - exact);
    spread_error += std::abs(spread - exact);
    total += exact;

    // What no choice of Fresnel can remove: the error of the same lobe with F = 1.
    const double exact_metal = exact_specular(metal, center, plane.t1, plane.t2, a, b);
    fit_error += std::abs(metal.specular.x * share - exact_metal);
    fit_total += exact_metal;
  }
  MESSAGE("error over the sum: average Fresnel ", spread_error / total, ", own direction ",
          own_error / total, ", the fit alone ", fit_error / fit_total);
  CHECK(own_error < 0.35 * spread_error);
  CHECK(own_error / total < 1.5 * fit_error / fit_total);
}

TEST_CASE("the whole lobe has the table's albedo, a small light the exact Fresnel") {
  const LobeTableView table = table::builtin_ggx_table().view();
  const Vec3d none(0.0), f0(0.04), white(1.0);
  for (const double theta : {0.1, 0.7, 1.2}) {
    for (const double roughness : {0.1, 0.4, 0.9}) {
      const Vec3d wo(std::sin(theta), 0, std::cos(theta));
      const f64::Surface s = surface(table, wo, f0, roughness);
      const Vec3d mean = f64::safe_direction(f64::mean_above_horizon(s.fitted.lobe));
      CHECK(f64::specular_reflectance(s, mean, 1.0).x == doctest::Approx(s.specular.x));

      const Vec3d wi = f64::safe_direction(Vec3d(-0.3, 0.2, 0.8));
      const Vec3d h = f64::safe_direction(wo + wi);
      const double fresnel = f64::schlick_fresnel(f0, white, dot(wo, h)).x;
      const double share = 1e-6;
      CHECK(f64::specular_reflectance(s, wi, share).x ==
            doctest::Approx(fresnel * s.fitted.n1 * share).epsilon(1e-4));
    }
  }
}
