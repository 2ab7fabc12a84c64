// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A BRDF's lobes, the fitted ones and their difference, seen from above, over a grid of view angles
// and roughnesses: figure 2 of the source document, with numbers.

#pragma once

#include "openltc/draw/figure.h"
#include "openltc/plot/fit_cells.h"

#include <string>
#include <vector>

namespace openltc::plot {

struct FitFigureOptions {
  brdf::Brdf brdf;                                     ///< what the lobes stand for
  fit::MeasuredLobes lobes;                            ///< with a label
  std::vector<double> theta_degrees = {0, 30, 60, 80}; ///< rows, 0..90, not 90; at most 6
  std::vector<double> roughness = {0.1, 0.3, 0.6, 1};  ///< columns, 0..1; at most 6
  bool linear = false;                                 ///< colours; else over three decades
  std::string command;                                 ///< stands in the caption
};

/// One cell each, with TV, L2 and peak error as the report of `openltc fit` has them. Fails for
/// axes out of range or too long, and as make_fit_cells does.
Result<draw::Figure> make_fit_figure(const FitFigureOptions& options);

} // namespace openltc::plot
