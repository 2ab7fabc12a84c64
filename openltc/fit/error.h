// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// How far a table is from its BRDF, between the nodes, through the look-up that shading uses.

#pragma once

#include "openltc/brdf/brdf.h"
#include "openltc/fit/quadrature.h"
#include "openltc/table/lobe_table.h"
#include "openltc/target/shade_f64.h"

namespace openltc::fit {

/// Distances between a lobe D and rho/E at one view angle and roughness, both of integral 1.
struct LobeError {
  double tv = 0;   ///< 1/2 integral over the sphere of |rho/E - D|, 0..1, leak included
  double l1 = 0;   ///< integral of |rho/E - D| over the hemisphere
  double l2 = 0;   ///< (integral of |..|^2)^(1/2) over that of rho/E
  double l3 = 0;   ///< (integral of |..|^3)^(1/3) over that of rho/E
  double peak = 0; ///< |max D / max rho/E - 1| over the quadrature's points
  double leak = 0; ///< share of D below the surface's horizon
  double n1 = 0;   ///< |n1 of the table - E|
  double n5 = 0;
};

/// Error of one lobe against a quadrature of its BRDF.
LobeError measure_lobe(const Quadrature& quadrature, const f64::Lobe& lobe);

/// Mean, 95th percentile and maximum of each over a region.
struct TableError {
  LobeError mean, p95, max;
  double roughness_from = 0, roughness_to = 1, theta_to_degrees = 90;
  int points = 0;               ///< per axis
  double second_difference = 0; ///< mean |second difference| of A B C D over the whole table
};

/// The region over which a table is measured.
struct MeasureOptions {
  double roughness_from = 0.06;
  double roughness_to = 1.0;
  double theta_to_degrees = 89.7;
  int points = 40; ///< per axis, uniform in roughness and theta, at the midpoints of cells
  int grid = 48;   ///< quadrature, 2 grid^2 points
};

/// Measures a table against its BRDF. Does not depend on the number of threads.
TableError measure_table(const brdf::Brdf& brdf, const table::LobeTable& table,
                         const MeasureOptions& options);

} // namespace openltc::fit
