// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The error of lobes over roughness and view angle, as maps of colours: one set of lobes, or two
// and their difference.

#pragma once

#include "openltc/draw/figure.h"
#include "openltc/fit/measure/error.h"

#include <string>
#include <vector>

namespace openltc::plot {

struct ErrorFigureOptions {
  brdf::Brdf brdf;                                       ///< what the lobes stand for
  std::vector<fit::MeasuredLobes> lobes;                 ///< one or two, with labels
  std::vector<std::string> norms = {"tv", "l2", "peak"}; ///< a row each; of fit::lobe_error_fields
  fit::MeasureOptions region;                            ///< the report's first; its horizon unused
  std::string command;                                   ///< stands in the caption
};

/// The norm of that name; the error lists the names.
Result<fit::LobeErrorField> find_norm(const std::string& name);

/// What the figure shows: one map for each set of lobes, measured as a report measures them.
/// Fails for no norm, an unknown one, other than one or two sets of lobes, an empty region, and as
/// fit::measure_maps does.
Result<std::vector<fit::ErrorMap>> measure_errors(const ErrorFigureOptions& options);

/// A row for each norm, a column for each set of lobes; of two, a third column has the second's
/// error less the first's. Mean and 95th percentile stand above each map. Fails as measure_errors.
Result<draw::Figure> make_error_figure(const ErrorFigureOptions& options);

} // namespace openltc::plot
