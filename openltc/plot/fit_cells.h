// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the figure of fits shows: lobes beside their BRDF over a grid of view angles and
// roughnesses, and how far they are from it.

#pragma once

#include "openltc/base/result.h"
#include "openltc/fit/measure/error.h"
#include "openltc/fit/report/lobe_view.h"

#include <vector>

namespace openltc::plot {

/// One view angle and roughness.
struct FitCell {
  double roughness = 0, theta_degrees = 0;
  fit::LobeError error;     ///< as the report of `openltc fit` measures it
  double albedo = 0;        ///< E of the BRDF, F = 1
  fit::DiscWindow window;   ///< of the discs
  std::vector<double> brdf; ///< rho/E, 1/steradian, as fit::sample_disc gives it
  std::vector<double> lobe; ///< D, its horizon read as the candidate says
  double brightest = 0;     ///< of `brdf`: what colours are relative to; > 0
};

/// Cells over the axes, roughness fast, theta slow, with discs of side x side pixels. Measures with
/// the quadrature of fit::MeasureOptions, as the report does. Fails as fit::measure_maps does.
Result<std::vector<FitCell>> make_fit_cells(const brdf::Brdf& brdf, const fit::MeasuredLobes& lobes,
                                            const fit::MeasureAxes& axes, int side);

/// (D - rho/E) / brightest at every pixel of a cell; 0 beyond the horizon, where neither is.
std::vector<double> relative_difference(const FitCell& cell);

} // namespace openltc::plot
