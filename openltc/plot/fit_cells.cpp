// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/fit_cells.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace openltc::plot {

Result<std::vector<FitCell>> make_fit_cells(const brdf::Brdf& brdf, const fit::MeasuredLobes& lobes,
                                            const fit::MeasureAxes& axes, int side) {
  const fit::QuadratureSize size = fit::MeasureOptions{}.quadrature;
  const Result<std::vector<fit::ErrorMap>> maps = fit::measure_maps(brdf, {&lobes, 1}, axes, size);
  if (!maps) return maps.error();
  const fit::ErrorMap& map = maps->front();
  std::vector<FitCell> cells;
  for (std::size_t row = 0; row < map.rows(); ++row) {
    for (std::size_t column = 0; column < map.columns(); ++column) {
      FitCell cell;
      cell.roughness = axes.roughness[column];
      cell.theta_degrees = axes.theta_degrees[row];
      cell.error = map.at(column, row);
      cell.albedo = map.albedo[row * map.columns() + column];
      const double cos_theta = std::cos(cell.theta_degrees * f64::k_pi / 180);
      const Result<fit::Quadrature> rule =
          fit::make_quadrature(brdf, cell.roughness, cos_theta, size);
      if (!rule) return rule.error();
      cell.window = fit::window_of_lobe(*rule);
      cell.brdf = fit::sample_disc(fit::density_of(brdf, *rule), cell.window, side);
      const fit::MeasuredLobe lobe = lobes.lobes(cell.roughness, cos_theta);
      cell.lobe = fit::sample_disc(fit::density_of(lobe, lobes.horizon), cell.window, side);
      cell.brightest = *std::max_element(cell.brdf.begin(), cell.brdf.end());
      if (!(cell.brightest > 0)) cell.brightest = 1; // nothing of it falls on a pixel
      cells.push_back(std::move(cell));
    }
  }
  return cells;
}

std::vector<double> relative_difference(const FitCell& cell) {
  std::vector<double> difference;
  difference.reserve(cell.brdf.size());
  for (std::size_t i = 0; i < cell.brdf.size(); ++i)
    difference.push_back(cell.brdf[i] < 0 ? 0 : (cell.lobe[i] - cell.brdf[i]) / cell.brightest);
  return difference;
}

} // namespace openltc::plot
