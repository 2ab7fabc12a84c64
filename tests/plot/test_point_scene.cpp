// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The figure of one point light: its scan lines are the renderer's pixels.

#include "openltc/fit/polynomial_fit.h"
#include "openltc/plot/point_scene.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace openltc;

namespace {

struct Lobes {
  fit::LobeFunction at;
  render::LobeSource source;
};

Lobes table_lobes() {
  return {fit::lobes_of(table::builtin_ggx_table()), table::builtin_ggx_table()};
}
Lobes polynomial_lobes() {
  return {fit::lobes_of(table::builtin_ggx_polynomial()), table::builtin_ggx_polynomial()};
}

plot::PointSetup setup_at(double theta_degrees, double metallic = 1) {
  plot::PointSetup setup;
  setup.theta_degrees = theta_degrees;
  setup.metallic = metallic;
  return setup;
}

// Largest relative distance between pixels and the scans along and across.
double farthest(const plot::PointSetup& setup, double roughness, const Lobes& lobes) {
  const plot::PointView view = plot::frame_highlight(setup, roughness);
  const auto pictures = plot::render_point(setup, view, roughness, lobes.source);
  REQUIRE(pictures);
  double most = 0;
  for (const plot::Scan scan : {plot::Scan::along, plot::Scan::across}) {
    const auto points = plot::scan_highlight(setup, view, scan, roughness, lobes.at);
    REQUIRE(int(points.size()) == (scan == plot::Scan::along ? view.height : view.width));
    for (const plot::ScanPoint& p : points) {
      const double exact = double(*pictures->exact.pixel(p.column, p.row));
      const double ltc = double(*pictures->ltc.pixel(p.column, p.row));
      REQUIRE(p.luminance.exact > 0);
      most = std::max(most, std::abs(exact / p.luminance.exact - 1));
      // A lobe may end above the horizon.
      const double size = std::max(p.luminance.ltc, 1e-3 * p.luminance.exact);
      most = std::max(most, std::abs(ltc - p.luminance.ltc) / size);
    }
  }
  return most;
}

} // namespace

TEST_CASE("scan lines are the renderer's pixels") {
  // Single precision moves a ray's point on the floor by 1e-7 or so; narrow lobes are steep.
  for (const double theta : {30.0, 60.0, 80.0})
    for (const double roughness : {0.1, 0.3, 0.7})
      for (const double metallic : {1.0, 0.4, 0.0}) {
        CAPTURE(theta);
        CAPTURE(roughness);
        CAPTURE(metallic);
        CHECK(farthest(setup_at(theta, metallic), roughness, table_lobes()) < 3e-4);
      }
  CHECK(farthest(setup_at(0), 0.5, table_lobes()) < 3e-4);
  CHECK(farthest(setup_at(60), 0.3, polynomial_lobes()) < 3e-4);
}

TEST_CASE("at the middle pixel the light comes from the mirror direction") {
  for (const double theta : {0.0, 45.0, 85.0})
    for (const double roughness : {0.05, 0.4}) {
      const plot::PointSetup setup = setup_at(theta);
      const plot::PointView view = plot::frame_highlight(setup, roughness);
      const Vec2d middle = plot::floor_at(setup, view, view.middle_column(), view.middle_row());
      CHECK(std::abs(middle.x) < 1e-9);
      CHECK(std::abs(middle.y) < 1e-9);
      // D V F cos I / r^2 with h = n: D = 1 / (pi alpha^2), and for both cosines alike
      // V = 1 / (4 cos sqrt(cos^2 (1 - alpha^2) + alpha^2)).
      const double alpha = roughness * roughness, c = std::cos(theta * f64::k_pi / 180);
      const double fresnel = setup.base_color + (1 - setup.base_color) * std::pow(1 - c, 5);
      const double expected = fresnel / (4 * f64::k_pi * alpha * alpha) /
                              std::sqrt(c * c * (1 - alpha * alpha) + alpha * alpha) *
                              setup.intensity_cd / (setup.distance_m * setup.distance_m);
      const auto there = plot::shade_floor(setup, roughness, table_lobes().at, middle);
      CHECK(there.exact == doctest::Approx(expected).epsilon(1e-9));
    }
}

TEST_CASE("the view holds the highlight and leaves the horizon out") {
  for (const double theta : {0.0, 50.0, 75.0, 89.0})
    for (const double roughness : {0.05, 0.2, 0.5, 1.0}) {
      CAPTURE(theta);
      CAPTURE(roughness);
      const plot::PointSetup setup = setup_at(theta);
      const plot::PointView view = plot::frame_highlight(setup, roughness);
      CHECK(view.width % 2 == 1);
      CHECK(view.height % 2 == 1);
      const auto along =
          plot::scan_highlight(setup, view, plot::Scan::along, roughness, table_lobes().at);
      double brightest = 0;
      for (std::size_t i = 0; i < along.size(); ++i) {
        if (i > 0) CHECK(along[i].position_m > along[i - 1].position_m);
        brightest = std::max(brightest, along[i].luminance.exact);
      }
      CHECK(along.front().position_m < 0);
      CHECK(along.back().position_m > 0);
      // Narrow highlights fade inside the picture.
      if (roughness <= 0.2 && theta <= 75) {
        CHECK(along.front().luminance.exact < 0.1 * brightest);
        CHECK(along.back().luminance.exact < 0.1 * brightest);
      }
      // The two sides of the plane of incidence are alike.
      const auto across =
          plot::scan_highlight(setup, view, plot::Scan::across, roughness, table_lobes().at);
      for (std::size_t i = 0; i < across.size(); ++i) {
        const auto& other = across[across.size() - 1 - i];
        CHECK(across[i].position_m == doctest::Approx(-other.position_m));
        CHECK(across[i].luminance.exact == doctest::Approx(other.luminance.exact));
        // Within 1e-4 of the normal the shading frame is any: lobes point there but for as much.
        CHECK(across[i].luminance.ltc == doctest::Approx(other.luminance.ltc).epsilon(3e-3));
      }
    }
}

TEST_CASE("on a diffuse floor both forms are Lambert's") {
  plot::PointSetup setup = setup_at(40, 0);
  setup.f0 = 0;
  setup.base_color = 0.6;
  const auto at = plot::shade_floor(setup, 1, table_lobes().at, Vec2d(0.3, -0.2));
  CHECK(at.ltc == doctest::Approx(at.exact).epsilon(0.01));
  CHECK(at.exact > 0);
}
