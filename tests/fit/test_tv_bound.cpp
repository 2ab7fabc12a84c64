// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Total variation and the amplitude's error bound the error of every light; and the integrals that
// this is tested with.

#include "openltc/fit/measure/light_error.h"
#include "openltc/fit/polynomial_fit.h"
#include "openltc/fit/table_fit.h"
#include "published_table.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace openltc;
using fit::Horizon;

namespace {

const brdf::Brdf& ggx() { return *brdf::find_brdf("ggx"); }

const brdf::Brdf k_lambert = brdf::brdf_from_function(
    "lambert", [](Vec3d, Vec3d, double) { return f64::k_inv_pi; }, brdf::LobeWidth::one);

// Phong's lobe about the mirror direction, with the cosine.
const brdf::Brdf k_phong = brdf::brdf_from_function("phong", [](Vec3d wo, Vec3d wi, double r) {
  const double alpha = f64::alpha_from_roughness(r);
  const double mirror = wo.z * wi.z - wo.x * wi.x - wo.y * wi.y;
  return std::pow(std::max(mirror, 0.0), std::min(2 / (alpha * alpha), 1e5));
});

// With amplitude `n1`, whatever the BRDF's albedo.
fit::LobeFunction cosine(double n1 = 1) {
  return [n1](double, double) {
    f64::FittedLobe fitted;
    fitted.lobe = f64::cosine_lobe();
    fitted.n1 = n1;
    fitted.n5 = 0;
    return fitted;
  };
}

// Sum over a fine grid of the rectangle: nothing in common with the fan of triangles.
double by_grid(const brdf::Brdf& brdf, double roughness, double cos_theta,
               const std::array<Vec3d, 4>& corners, int n) {
  const Vec3d u = corners[1] - corners[0], v = corners[3] - corners[0];
  const Vec3d normal = cross(u, v);
  const Vec3d wo(std::sqrt(1 - cos_theta * cos_theta), 0, cos_theta);
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Vec3d x = corners[0] + u * ((i + 0.5) / n) + v * ((j + 0.5) / n);
      const double r = length(x);
      if (x.z > 0)
        sum += brdf.eval(wo, x / r, roughness).scale * std::abs(dot(x, normal)) / (r * r * r);
    }
  }
  return sum / (double(n) * n);
}

// Rectangles for one point to be lit by: a member of the family, one that leaves next to nothing of
// the hemisphere free, half of the hemisphere from a plane through the point at any angle, and a
// strip of it. All but the first are as large as 1e5 times their distance.
std::vector<std::array<Vec3d, 4>> polygons_of(const fit::LightCase& at, int index) {
  const double far = 1e5;
  const auto lid = [&](double x0, double x1) {
    // x0, x1: slopes from the normal along one direction of the tangent plane.
    const double turn = 2.399963 * index; // the golden angle: no two alike
    const Vec3d u(std::cos(turn), std::sin(turn), 0), v(-std::sin(turn), std::cos(turn), 0);
    const Vec3d up(0, 0, 1);
    return std::array<Vec3d, 4>{up + u * x0 - v * far, up + u * x1 - v * far, up + u * x1 + v * far,
                                up + u * x0 + v * far};
  };
  const double slope = std::tan(1.5 * std::sin(12.9898 * index));
  return {at.corners, lid(-far, far), lid(slope, far), lid(slope, slope + 0.5)};
}

// What is compared: the look-ups that shading has, and a few bad ones.
struct BoundedLobes {
  table::LobeTable native16, native8;
  fit::PolynomialFit polynomial;
  std::vector<fit::MeasuredLobes> all;
  std::size_t own_count = 0; ///< the first of them, fitted to GGX

  void add(const std::string& label, const fit::LobeFunction& lobes) {
    all.push_back({label, lobes, Horizon::leaking});
    all.push_back({label + ", clipped", lobes, Horizon::clipped});
  }
  BoundedLobes() {
    fit::TableFitOptions options;
    options.size = 16;
    native16 = *fit::fit_table(ggx(), options);
    options.size = 8;
    native8 = *fit::fit_table(ggx(), options);
    polynomial = *fit::fit_polynomial(ggx(), {});
    REQUIRE(polynomial.polynomial.degree == 4);
    add("native 64", fit::lobes_of(table::builtin_ggx_table()));
    add("native 16", fit::lobes_of(native16));
    add("native 8", fit::lobes_of(native8));
    add("polynomial", fit::lobes_of(polynomial.polynomial));
    own_count = all.size();
    all.push_back({"cosine", cosine(), Horizon::leaking});
    all.push_back({"cosine of too little light", cosine(0.7), Horizon::leaking});
    all.push_back({"inside out",
                   [](double, double) {
                     f64::FittedLobe fitted;
                     fitted.lobe = f64::make_lobe(-1, 0.4, 0.2, 0.8);
                     fitted.n1 = 1.1;
                     fitted.n5 = 0;
                     return fitted;
                   },
                   Horizon::leaking});
    if (const auto published = testing::published_lobes())
      add("published", *published);
    else
      MESSAGE("skipped the published table: ", OPENLTC_SHARED_DIR, "/tables is not there");
  }
  BoundedLobes(const BoundedLobes&) = delete; // the look-ups point into it
};

const BoundedLobes& bounded_lobes() {
  static const BoundedLobes lobes;
  return lobes;
}

} // namespace

TEST_CASE("the BRDF's integral over a polygon: Lambert's has a closed form") {
  double worst = 0;
  for (int i = 0; i < 500; ++i) {
    const fit::LightCase at = fit::light_case({}, i);
    const double scale = fit::find_half_vectors(k_lambert, at.roughness).scale;
    worst =
        std::max(worst, std::abs(fit::integrate_brdf_over_polygon(k_lambert, at.roughness,
                                                                  at.cos_theta, scale, at.corners) -
                                 fit::integrate_lobe_over_polygon(f64::cosine_lobe(), at.corners)));
  }
  MESSAGE("largest difference ", worst);
  CHECK(worst < 1e-5);
}

TEST_CASE("the BRDF's integral over a polygon equals a sum over a fine grid") {
  double worst = 0;
  int lit = 0;
  for (int i = 0; i < 60; ++i) {
    fit::LightFamily family;
    family.roughness_from = 0.3;
    const fit::LightCase at = fit::light_case(family, i);
    const double scale = fit::find_half_vectors(ggx(), at.roughness).scale;
    const double value =
        fit::integrate_brdf_over_polygon(ggx(), at.roughness, at.cos_theta, scale, at.corners);
    worst = std::max(worst,
                     std::abs(value - by_grid(ggx(), at.roughness, at.cos_theta, at.corners, 300)));
    lit += value > 0.01;
  }
  MESSAGE("largest difference ", worst, ", lit ", lit, " of 60");
  CHECK(worst < 1e-3);
  CHECK(lit > 15);
}

TEST_CASE("over the whole sky the BRDF's integral is the albedo") {
  // A lid of which 1e-6 is missing at the horizon.
  const std::array<Vec3d, 4> lid = {Vec3d(-1e6, -1e6, 1), Vec3d(1e6, -1e6, 1), Vec3d(1e6, 1e6, 1),
                                    Vec3d(-1e6, 1e6, 1)};
  for (const double r : {0.06, 0.2, 0.6, 1.0}) {
    for (const double c : {1.0, 0.5, 0.1, 0.02, 0.0053}) {
      const fit::HalfVectors half_vectors = fit::find_half_vectors(ggx(), r);
      const double albedo = fit::make_quadrature(ggx(), r, c, half_vectors, {160, 128})->n1;
      CAPTURE(r);
      CAPTURE(c);
      CHECK(fit::integrate_brdf_over_polygon(ggx(), r, c, half_vectors.scale, lid) ==
            doctest::Approx(albedo).epsilon(2e-5));
      CHECK(fit::integrate_lobe_over_polygon(f64::cosine_lobe(), lid) ==
            doctest::Approx(1).epsilon(1e-5));
    }
  }
}

TEST_CASE("the family's quadrature is as accurate as its header says") {
  double worst = 0;
  for (int i = 0; i < 400; ++i) {
    const fit::LightCase at = fit::light_case({}, i);
    const double scale = fit::find_half_vectors(ggx(), at.roughness).scale;
    const auto integral = [&](const fit::PolygonRule& rule) {
      return fit::integrate_brdf_over_polygon(ggx(), at.roughness, at.cos_theta, scale, at.corners,
                                              rule);
    };
    worst = std::max(worst, std::abs(integral({}) - integral({64, 1e-8})));
  }
  MESSAGE("largest difference ", worst);
  CHECK(worst < 2e-5);
}

TEST_CASE("the parts of a rectangle add up to the whole") {
  for (int i = 0; i < 200; ++i) {
    const fit::LightCase at = fit::light_case({}, i);
    const std::array<Vec3d, 4>& p = at.corners;
    const Vec3d low = p[0] + (p[1] - p[0]) * 0.3, high = p[3] + (p[2] - p[3]) * 0.3;
    const std::array<Vec3d, 4> left = {p[0], low, high, p[3]}, right = {low, p[1], p[2], high};
    const double scale = fit::find_half_vectors(ggx(), at.roughness).scale;
    const auto integral = [&](const std::array<Vec3d, 4>& corners) {
      return fit::integrate_brdf_over_polygon(ggx(), at.roughness, at.cos_theta, scale, corners);
    };
    CHECK(std::abs(integral(left) + integral(right) - integral(p)) < 3e-5);
    const f64::Lobe lobe =
        fit::lobes_of(table::builtin_ggx_table())(at.roughness, at.cos_theta).lobe;
    CHECK(std::abs(fit::integrate_lobe_over_polygon(lobe, left) +
                   fit::integrate_lobe_over_polygon(lobe, right) -
                   fit::integrate_lobe_over_polygon(lobe, p)) < 1e-7);
  }
}

TEST_CASE("no light errs by more than (E TV + |n1 - E|) L_max, the sky included") {
  // The light as it is rendered, n1 D, against that of the BRDF itself; no figure of
  // light_error.cpp takes part. The tolerance is for the quadratures: of E, of TV and of the BRDF
  // over the polygon.
  constexpr double tolerance = 5e-5;
  constexpr int points = 400;
  const std::vector<fit::MeasuredLobes>& lobes = bounded_lobes().all;
  int beyond_e_tv = 0, drawn = 0;
  double most_used = 0, worst_excess = -1;
  for (const brdf::Brdf* brdf : {&ggx(), &k_phong, &k_lambert}) {
    for (int i = 0; i < points; ++i) {
      fit::LightFamily family;
      family.seed = 11;
      family.roughness_from = 0.03;
      const fit::LightCase at = fit::light_case(family, i);
      const fit::HalfVectors half_vectors = fit::find_half_vectors(*brdf, at.roughness);
      const fit::Quadrature rule =
          *fit::make_quadrature(*brdf, at.roughness, at.cos_theta, half_vectors, {64, 64});
      std::vector<f64::FittedLobe> fitted;
      std::vector<fit::LobeError> errors;
      for (const fit::MeasuredLobes& candidate : lobes) {
        fitted.push_back(candidate.lobes(at.roughness, at.cos_theta));
        errors.push_back(fit::measure_lobe(rule, fitted.back(), candidate.horizon));
      }
      for (const auto& corners : polygons_of(at, i)) {
        ++drawn;
        const double truth = fit::integrate_brdf_over_polygon(*brdf, at.roughness, at.cos_theta,
                                                              half_vectors.scale, corners);
        for (std::size_t k = 0; k < lobes.size(); ++k) {
          const double above = fit::integrate_lobe_over_polygon(fitted[k].lobe, corners);
          const double scale = fit::horizon_scale(fitted[k].lobe, lobes[k].horizon);
          const double error = std::abs(fitted[k].n1 * std::min(scale * above, 1.0) - truth);
          const double excess = error - errors[k].bound;
          if (excess > tolerance) {
            CAPTURE(brdf->name);
            CAPTURE(lobes[k].label);
            CAPTURE(at.roughness);
            CAPTURE(at.cos_theta);
            CHECK(error <= errors[k].bound + tolerance);
          }
          worst_excess = std::max(worst_excess, excess);
          // Of the lobes that were fitted to this very BRDF.
          if (brdf == &ggx() && k < bounded_lobes().own_count)
            beyond_e_tv += error > rule.n1 * errors[k].tv + tolerance;
          if (errors[k].bound > 0.01) most_used = std::max(most_used, error / errors[k].bound);
        }
      }
    }
  }
  MESSAGE(drawn, " polygons, each with ", lobes.size(), " lobes; the largest excess is ",
          worst_excess, ", the most of its bound that one uses ", most_used, "; ", beyond_e_tv,
          " of the fitted lobes lie beyond E TV alone");
  CHECK(worst_excess <= tolerance);
  CHECK(most_used > 0.95);
  // Without the amplitude the bound would be false, and this test would see it.
  CHECK(beyond_e_tv > 0);
}

TEST_CASE("a light that errs by more than E TV: a perfect lobe of a wrong amplitude") {
  const fit::MeasuredLobes dim{"dim", cosine(0.9), Horizon::leaking};
  fit::LightFamily family;
  family.count = 200;
  const fit::LightError e = fit::measure_lights(k_lambert, {&dim, 1}, family)->front();
  CHECK(e.max < 1e-4); // of albedo 1: the lobe is Lambert's
  CHECK(e.violations == 0);
  CHECK(e.of_bound > 0.5); // the light itself is a tenth too dim
  CHECK(e.of_bound < 1.001);
}

TEST_CASE("the families of the report hold no light beyond its bound") {
  const std::vector<fit::MeasuredLobes>& lobes = bounded_lobes().all;
  int drawn = 0;
  double most_used = 0;
  for (const brdf::Brdf* brdf : {&ggx(), &k_phong, &k_lambert}) {
    // Far and small lights, lights that surround the point, and nearly specular lobes.
    fit::LightFamily near, sharp;
    near.seed = 7;
    near.distance_from = 0.1;
    near.distance_to = 1.5;
    sharp.seed = 8;
    sharp.roughness_from = 0.03;
    sharp.roughness_to = 0.3;
    for (fit::LightFamily family : {fit::LightFamily{}, near, sharp}) {
      family.count = 800;
      const auto errors = *fit::measure_lights(*brdf, lobes, family);
      for (std::size_t k = 0; k < lobes.size(); ++k) {
        CAPTURE(brdf->name);
        CAPTURE(lobes[k].label);
        CAPTURE(family.seed);
        CHECK(errors[k].violations == 0);
        CHECK(errors[k].rmse <= errors[k].max);
        most_used = std::max(most_used, errors[k].of_bound);
      }
      drawn += family.count;
    }
  }
  CHECK(drawn >= 5000);
  // The bound is not an idle one: some light comes near it, so one a little too small would show.
  MESSAGE(drawn, " lights, each with ", lobes.size(), " lobes; the largest uses ", most_used,
          " of its bound");
  CHECK(most_used > 0.9);
}

TEST_CASE("the figures of a family of lights are the same for any number of threads and runs") {
  const fit::MeasuredLobes own{"built-in", fit::lobes_of(table::builtin_ggx_table()),
                               Horizon::leaking};
  fit::LightFamily family;
  family.count = 100;
  const fit::LightError many = fit::measure_lights(ggx(), {&own, 1}, family)->front();
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const fit::LightError single = fit::measure_lights(ggx(), {&own, 1}, family)->front();
  CHECK(many.rmse == single.rmse);
  CHECK(many.max == single.max);
  CHECK(many.bias == single.bias);
  family.seed = 3;
  CHECK(fit::measure_lights(ggx(), {&own, 1}, family)->front().rmse != single.rmse);
}

TEST_CASE("the family holds lights above, across and beside the horizon") {
  int across = 0, lit = 0;
  fit::LightFamily family;
  for (int i = 0; i < 1000; ++i) {
    const fit::LightCase at = fit::light_case(family, i);
    CHECK(at.roughness >= family.roughness_from);
    CHECK(at.roughness <= family.roughness_to);
    CHECK(at.cos_theta > 0);
    bool above = false, below = false;
    for (const Vec3d& c : at.corners)
      (c.z > 0 ? above : below) = true;
    across += above && below;
    lit += above;
    // A rectangle: equal diagonals, right angles.
    CHECK(length(at.corners[2] - at.corners[0]) ==
          doctest::Approx(length(at.corners[3] - at.corners[1])));
  }
  CHECK(across > 150);
  CHECK(lit > 990);
}
