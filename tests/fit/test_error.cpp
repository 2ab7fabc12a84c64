// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The measured errors against lobes whose distance has a closed form, and what a map promises.

#include "openltc/fit/measure/error.h"
#include "openltc/target/shade_f64.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>

using namespace openltc;
using fit::Horizon;

namespace {

const brdf::Brdf k_lambert =
    brdf::brdf_from_function("lambert", [](Vec3d, Vec3d, double) { return f64::k_inv_pi; });

fit::Quadrature lambert_rule(double cos_theta) {
  return *fit::make_quadrature(k_lambert, 0.7, cos_theta, {96, 96});
}

// The cosine turned by an angle towards +x: M^-1 is a rotation.
f64::Lobe tilted_cosine(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return f64::make_lobe(c, -s, s, c);
}

fit::LobeFunction constant(const f64::Lobe& lobe) {
  return [lobe](double, double) {
    f64::FittedLobe fitted;
    fitted.lobe = lobe;
    fitted.n1 = 1;
    fitted.n5 = 0;
    return fitted;
  };
}

} // namespace

TEST_CASE("the cosine has no distance from Lambert, in either reading of the horizon") {
  for (const Horizon horizon : {Horizon::leaking, Horizon::clipped}) {
    for (const double c : {1.0, 0.6, 0.1}) {
      const fit::LobeError e = fit::measure_lobe(lambert_rule(c), f64::cosine_lobe(), horizon);
      for (const fit::LobeErrorField& field : fit::lobe_error_fields()) {
        CAPTURE(field.name);
        CHECK(std::abs(e.*field.member) < 1e-6);
      }
    }
  }
}

TEST_CASE("a stretched cosine has total variation |s - 1|/(s + 1)") {
  // D = s^2 z/(pi (1 + (s^2 - 1) z^2)^2) crosses z/pi at z^2 = 1/(s + 1), below which D holds s z^2
  // and the cosine z^2.
  for (const double s : {0.2, 0.5, 0.9, 1.5, 4.0}) {
    const fit::LobeError e =
        fit::measure_lobe(lambert_rule(0.7), f64::make_lobe(1, 0, 0, s), Horizon::leaking);
    CAPTURE(s);
    CHECK(e.tv == doctest::Approx(std::abs(s - 1) / (s + 1)).epsilon(2e-3));
    CHECK(e.leak == doctest::Approx(0));
    CHECK(e.l1 == doctest::Approx(2 * e.tv));
  }
}

TEST_CASE("two cosines an angle g apart have total variation sin(g/2), leak sin(g/2)^2") {
  // The one exceeds the other on a half-space with normal a - b, of which each axis has the sine.
  for (const double angle : {0.1, -0.4, 0.9, 1.4}) {
    const fit::LobeError e =
        fit::measure_lobe(lambert_rule(0.7), tilted_cosine(angle), Horizon::leaking);
    const double half_sine = std::sin(0.5 * std::abs(angle));
    CAPTURE(angle);
    CHECK(e.tv == doctest::Approx(half_sine).epsilon(3e-3));
    CHECK(e.leak == doctest::Approx(half_sine * half_sine).epsilon(1e-9));
    CHECK(e.l1 == doctest::Approx(2 * e.tv - e.leak));
  }
}

TEST_CASE("a clipped lobe integrates to 1 over the hemisphere, and its TV is half its L1") {
  for (const double angle : {0.0, 0.5, -1.2}) {
    const f64::Lobe lobe = tilted_cosine(angle);
    const fit::Quadrature q = lambert_rule(0.7);
    double sum = 0;
    for (std::size_t i = 0; i < q.size(); ++i) {
      const double s = std::sqrt(1 - q.cos_theta * q.cos_theta);
      const Vec3d wi(q.cos_theta * q.x_mirror[i] - s * q.z_mirror[i], q.y[i],
                     s * q.x_mirror[i] + q.cos_theta * q.z_mirror[i]);
      sum += q.weight[i] * f64::eval_lobe(lobe, wi);
    }
    CAPTURE(angle);
    CHECK(sum * fit::horizon_scale(lobe, Horizon::clipped) == doctest::Approx(1).epsilon(3e-4));
    CHECK(fit::horizon_scale(lobe, Horizon::leaking) == 1);
    const fit::LobeError e = fit::measure_lobe(q, lobe, Horizon::clipped);
    CHECK(e.tv == doctest::Approx(0.5 * e.l1));
    // The leak is the lobe's own, whatever the reading.
    CHECK(e.leak == fit::measure_lobe(q, lobe, Horizon::leaking).leak);
  }
}

TEST_CASE("the measure divides by the share above the horizon exactly as shading does") {
  const Vec3d up(0, 0, 1), wo(0.6, 0, 0.8), none(0, 0, 0), one(1, 1, 1);
  double smallest_share = 1;
  for (const double angle : {0.0, 0.4, -1.5, 2.5, 2.9, 3.1, -3.14}) {
    f64::FittedLobe fitted;
    fitted.lobe = tilted_cosine(angle);
    fitted.n1 = 1;
    fitted.n5 = 0;
    const f64::Surface surface = f64::make_surface(fitted, none, up, wo, none, one, one, 0.7);
    CAPTURE(angle);
    CHECK(fit::horizon_scale(fitted.lobe, Horizon::clipped) == surface.inv_share);
    smallest_share = std::min(smallest_share, f64::share_above_horizon(fitted.lobe));
    // However little of it lies above, what is measured stays in its range.
    for (const Horizon horizon : {Horizon::leaking, Horizon::clipped}) {
      const fit::LobeError e = fit::measure_lobe(lambert_rule(0.7), fitted.lobe, horizon);
      CHECK(e.tv >= 0);
      CHECK(e.tv < 1.0001);
      CHECK(e.l1 <= 2 * e.tv);
    }
  }
  CHECK(smallest_share < f64::k_min_share); // where the two would differ
  CHECK(fit::horizon_scale(tilted_cosine(3.1), Horizon::clipped) == 1 / f64::k_min_share);
}

TEST_CASE("a lobe whose determinant is not positive counts as all wrong, and not as more") {
  const f64::Lobe mirrored = f64::make_lobe(-1, 0, 0, 1), flat = f64::make_lobe(1, 1, 1, 1),
                  folded = f64::make_lobe(0.3, 2, 1.5, -0.4);
  for (const f64::Lobe& lobe : {mirrored, flat, folded}) {
    REQUIRE(lobe.det <= 0);
    for (const Horizon horizon : {Horizon::leaking, Horizon::clipped}) {
      const fit::LobeError e = fit::measure_lobe(lambert_rule(0.7), lobe, horizon);
      CHECK(e.tv == 1);
      CHECK(e.l1 == 2);
      CHECK(e.l2 == 1);
      CHECK(e.l3 == 1);
      CHECK(e.peak == 1);
      CHECK(e.leak == 0);
    }
  }
  // In a map as well, and the bound is then the whole albedo.
  const fit::MeasuredLobes candidate{"mirrored", constant(mirrored), Horizon::leaking};
  const auto maps = *fit::measure_maps(k_lambert, {&candidate, 1}, {{0.5}, {30}}, {40, 32});
  CHECK(maps[0].cells[0].tv == 1);
  CHECK(maps[0].cells[0].bound == doctest::Approx(1).epsilon(1e-3));
}

TEST_CASE("the bound is E TV plus the amplitude's own error") {
  const fit::Quadrature q = *fit::make_quadrature(*brdf::find_brdf("ggx"), 0.8, 0.4, {40, 32});
  REQUIRE(q.n1 < 0.95); // else E would not show
  f64::FittedLobe fitted;
  fitted.lobe = f64::cosine_lobe();
  fitted.n5 = 0;
  for (const double n1 : {0.5, q.n1, 1.2}) {
    fitted.n1 = n1;
    const fit::LobeError e = fit::measure_lobe(q, fitted);
    CHECK(e.tv == fit::measure_lobe(q, fitted.lobe).tv);
    CHECK(e.n1 == std::abs(n1 - q.n1));
    CHECK(e.bound == doctest::Approx(q.n1 * e.tv + std::abs(n1 - q.n1)));
  }
  CHECK(fit::measure_lobe(q, fitted.lobe).bound == 0);
  const fit::MeasuredLobes candidate{"cosine", constant(f64::cosine_lobe()), Horizon::leaking};
  const fit::ErrorMap map =
      fit::measure_maps(*brdf::find_brdf("ggx"), {&candidate, 1}, {{0.3, 0.8}, {10, 70}}, {24, 24})
          ->front();
  for (std::size_t i = 0; i < map.cells.size(); ++i)
    CHECK(map.cells[i].bound ==
          doctest::Approx(map.albedo[i] * map.cells[i].tv + std::abs(1 - map.albedo[i])));
}

TEST_CASE("total variation is seen although a lobe hides between the points") {
  // A lobe far narrower than the quadrature's spacing, away from the BRDF's: almost no point sees
  // it, yet nearly all of its energy is in the wrong place.
  const fit::Quadrature q = *fit::make_quadrature(*brdf::find_brdf("ggx"), 0.3, 0.5, {40, 32});
  const f64::Lobe narrow = f64::lobe_from_mirror(Vec4d(0.97, 0, 0, 1.94), 1e-4, 0.97);
  CHECK(fit::measure_lobe(q, narrow).tv > 0.97);
  CHECK(fit::measure_lobe(q, narrow).tv < 1.0001);
}

TEST_CASE("total variation has converged at the default quadrature, grazing angles included") {
  const brdf::Brdf& ggx = *brdf::find_brdf("ggx");
  const fit::LobeFunction lobes = fit::lobes_of(table::builtin_ggx_table());
  const auto measure = [&](double r, double c, fit::QuadratureSize size) {
    return fit::measure_lobe(*fit::make_quadrature(ggx, r, c, size), lobes(r, c).lobe).tv;
  };
  double worst = 0;
  for (const double r : {0.03, 0.1, 0.214, 0.5, 0.9})
    for (const double c : {0.95, 0.5, 0.1, 0.02, 0.008})
      worst = std::max(worst, std::abs(measure(r, c, {40, 32}) - measure(r, c, {160, 128})));
  MESSAGE("largest difference ", worst);
  // The positive part has an edge where the lobes cross: 1e-5 in the mean over a map.
  CHECK(worst < 6e-3);
}

TEST_CASE("a map's statistics are those of its cells, for any number of threads") {
  const brdf::Brdf& ggx = *brdf::find_brdf("ggx");
  const fit::LobeFunction lobes = fit::lobes_of(table::builtin_ggx_table());
  fit::MeasureOptions options;
  options.points = 9;
  const fit::MeasuredLobes both[] = {{"leaking", lobes, Horizon::leaking},
                                     {"clipped", lobes, Horizon::clipped}};
  const auto maps = *fit::measure_maps(ggx, both, fit::midpoint_axes(options), {24, 24});
  REQUIRE(maps.size() == 2);
  REQUIRE(maps[0].cells.size() == 81);
  for (std::size_t i = 0; i < 81; ++i) {
    CHECK(maps[0].albedo[i] > 0);
    CHECK(maps[0].albedo[i] < 1.001);
    CHECK(maps[0].cells[i].n1 == maps[1].cells[i].n1);
  }
  const fit::TableError e = fit::summarise(maps[0]);
  double sum = 0, largest = 0;
  for (const fit::LobeError& cell : maps[0].cells) {
    sum += cell.tv;
    largest = std::max(largest, cell.tv);
  }
  CHECK(e.mean.tv == doctest::Approx(sum / 81).epsilon(1e-12));
  CHECK(e.max.tv == largest);
  CHECK(e.median.tv <= e.p95.tv);
  CHECK(e.p95.tv <= e.max.tv);

  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto again = *fit::measure_maps(ggx, both, fit::midpoint_axes(options), {24, 24});
  bool same = true;
  for (std::size_t m = 0; m < 2; ++m)
    for (std::size_t i = 0; i < 81; ++i)
      for (const fit::LobeErrorField& field : fit::lobe_error_fields())
        same = same && maps[m].cells[i].*field.member == again[m].cells[i].*field.member;
  CHECK(same);
}

TEST_CASE("axes lie inside their region, on midpoints and on nodes") {
  fit::MeasureOptions options;
  options.points = 10;
  for (const auto axis : {table::AngleAxis::theta, table::AngleAxis::sqrt_one_minus_cos}) {
    options.angle_axis = axis;
    const fit::MeasureAxes axes = fit::midpoint_axes(options);
    CHECK(axes.roughness.front() == doctest::Approx(0.06 + 0.047));
    CHECK(axes.roughness.back() == doctest::Approx(1 - 0.047));
    CHECK(axes.theta_degrees.front() > 0);
    CHECK(axes.theta_degrees.back() < options.theta_to_degrees);
    CHECK(fit::theta_at(1, 89.7, axis) == doctest::Approx(89.7));
    CHECK(fit::theta_at(0, 89.7, axis) == 0);
  }
  const fit::MeasureAxes nodes = fit::node_axes(table::builtin_ggx_table(), options);
  CHECK(nodes.roughness.front() == doctest::Approx(4.0 / 63));
  CHECK(nodes.roughness.back() == 1);
  CHECK(nodes.theta_degrees.front() == 0);
  // The last row is the grazing limit, 90 degrees.
  CHECK(nodes.theta_degrees.size() == 63);
}

TEST_CASE("second differences: none of a linear field, the curvature of a square") {
  const auto field = [](auto m00) {
    return fit::LobeFunction([m00](double roughness, double cos_theta) {
      f64::FittedLobe fitted;
      fitted.lobe = f64::make_lobe(m00(roughness, std::sqrt(1 - cos_theta)), 0, 0, 1);
      return fitted;
    });
  };
  CHECK(fit::mean_second_difference(field([](double x, double y) { return 1 + x - 2 * y; }), 33) <
        1e-13);
  // x^2 has second difference 2 h^2 along x, one of four entries and one of two axes.
  const double h = 1.0 / 32;
  CHECK(fit::mean_second_difference(field([](double x, double) { return 1 + x * x; }), 33) ==
        doctest::Approx(2 * h * h / 8));
}

TEST_CASE("a lobe that is not finite is refused, with its place") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const fit::MeasuredLobes broken{"broken.dds", constant(f64::make_lobe(1, nan, 0, 1)),
                                  Horizon::leaking};
  fit::MeasureOptions options;
  options.points = 2;
  const auto maps = fit::measure_maps(k_lambert, {&broken, 1}, fit::midpoint_axes(options), {8, 8});
  REQUIRE_FALSE(maps.ok());
  CHECK(maps.error().message.find("broken.dds") != std::string::npos);
  CHECK(maps.error().message.find("roughness 0.295") != std::string::npos);
  CHECK(maps.error().message.find('\n') == std::string::npos);
  CHECK_FALSE(fit::measure_maps(k_lambert, {&broken, 1}, {}, {8, 8}).ok());
}
