// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The figure of fits shows the numbers and discs of the report of `openltc fit`.

#include "openltc/fit/report/report.h"
#include "openltc/plot/fit_cells.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace openltc;

namespace {

fit::MeasuredLobes builtin() {
  return {"built-in", fit::lobes_of(table::builtin_ggx_table()), fit::Horizon::clipped};
}

} // namespace

TEST_CASE("fit cells have the report's errors, windows and discs") {
  const brdf::Brdf& ggx = *brdf::find_brdf("ggx");
  fit::Candidate candidate;
  candidate.label = "built-in";
  candidate.lobes = builtin().lobes;
  candidate.horizon = builtin().horizon;
  fit::ReportOptions options;
  options.regions.resize(1);
  options.regions[0].points = 5;
  options.lights.count = 1;
  options.worst_cells = 2;
  const auto report = fit::make_report(ggx, {candidate}, options);
  REQUIRE(report);
  const fit::ErrorMap& map = report->regions[0].maps[0];

  const auto cells = plot::make_fit_cells(ggx, builtin(), map.axes, fit::WorstCell::k_side);
  REQUIRE(cells);
  REQUIRE(cells->size() == map.cells.size());
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const plot::FitCell& cell = (*cells)[i];
    CHECK(cell.roughness == map.axes.roughness[i % map.columns()]);
    CHECK(cell.theta_degrees == map.axes.theta_degrees[i / map.columns()]);
    CHECK(cell.albedo == map.albedo[i]);
    for (const fit::LobeErrorField& field : fit::lobe_error_fields())
      CHECK(cell.error.*field.member == map.cells[i].*field.member);
    for (const fit::WorstCell& worst : report->worst) {
      if (worst.roughness != cell.roughness || worst.theta_degrees != cell.theta_degrees) continue;
      CHECK(cell.window.half == worst.window.half);
      CHECK(cell.window.center_x == worst.window.center_x);
      CHECK(cell.brdf == worst.brdf.disc);
      CHECK(cell.lobe == worst.lobes[0].disc);
    }
  }
  CHECK(report->worst.size() == 2);
}

TEST_CASE("what a lobe has too much in one place it lacks in another") {
  const auto cells =
      plot::make_fit_cells(*brdf::find_brdf("ggx"), builtin(), {{0.5, 0.8, 1}, {0, 40, 60}}, 300);
  REQUIRE(cells);
  for (const plot::FitCell& cell : *cells) {
    const std::vector<double> difference = plot::relative_difference(cell);
    REQUIRE(difference.size() == cell.brdf.size());
    // Half the integral of |D - rho/E| over the disc is the total variation printed beside it.
    const double pixel = 2 * std::pow(2 * cell.window.half / 300, 2);
    double sum = 0, size = 0;
    for (std::size_t i = 0; i < difference.size(); ++i) {
      if (cell.brdf[i] < 0) CHECK(difference[i] == 0);
      sum += difference[i] * cell.brightest * pixel;
      size += std::abs(difference[i]) * cell.brightest * pixel;
    }
    CHECK(std::abs(sum) < 2e-3);
    CHECK(size / 2 == doctest::Approx(cell.error.tv).epsilon(0.05));
    CHECK(cell.brightest == *std::max_element(cell.brdf.begin(), cell.brdf.end()));
  }
}

TEST_CASE("a lobe that is not finite is refused") {
  const fit::MeasuredLobes broken = {"broken.json",
                                     [](double, double) {
                                       f64::FittedLobe f;
                                       f.lobe = f64::cosine_lobe();
                                       f.lobe.m00 = std::numeric_limits<double>::quiet_NaN();
                                       f.n1 = f.n5 = 1;
                                       return f;
                                     },
                                     fit::Horizon::clipped};
  const auto cells = plot::make_fit_cells(*brdf::find_brdf("ggx"), broken, {{0.5}, {30}}, 8);
  REQUIRE_FALSE(cells);
  CHECK(cells.error().message.find("broken.json") != std::string::npos);
}
