// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Where the lobes of a table are compared with the BRDF when its nodes are fitted together.
// Internal to fit.

#pragma once

#include "openltc/fit/joint/joint_fit.h"
#include "openltc/table/lobe_table.h"

#include <string>
#include <vector>

namespace openltc::fit {

/// Nodes of a table along its two axes; one column for a BRDF without a parameter.
struct TableShape {
  int columns = 1, rows = 2;

  /// Roughness 0..1 at a column, which need not be whole.
  double roughness(double column) const { return columns > 1 ? column / (columns - 1) : 1.0; }
};

/// Samples between the nodes, at the centres of an even subdivision of every cell, with the share
/// each corner of the cell has in them, and nodes of the grazing row. Unknown `row * columns +
/// column` is a node. Fails as make_quadrature.
Result<std::vector<JointSample>> make_table_samples(const brdf::Brdf& brdf, TableShape shape,
                                                    table::AngleAxis axis,
                                                    QuadratureSize quadrature);

/// What A D - w B C of a node that was fitted with others is kept above.
inline constexpr double k_least_determinant = 1e-5;

/// The first failure of many, each empty where nothing failed.
Status first_failure(const std::vector<std::string>& failures);

/// The float nearest to six decimal digits of x, in every maths library alike.
float round_to_six_digits(double x);

} // namespace openltc::fit
