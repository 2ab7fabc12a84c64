// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// How far a table is from its BRDF, between the nodes, through the look-up that shading uses.

#pragma once

#include "openltc/brdf/brdf.h"
#include "openltc/fit/quadrature.h"
#include "openltc/table/lobe_table.h"
#include "openltc/target/shade_f64.h"

#include <functional>

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

/// Lobe and amplitudes for a roughness 0..1 and the cosine of the view angle, as shading reads
/// them: a table with its interpolation, a polynomial, a file of another layout. Called from any
/// thread.
using LobeFunction = std::function<f64::FittedLobe(double roughness, double cos_theta)>;

/// The look-up of a native table, which must outlive the function.
LobeFunction lobes_of(const table::LobeTable& table);

/// Mean, 95th percentile and maximum of each over a region.
struct TableError {
  LobeError mean, p95, max;
  double roughness_from = 0, roughness_to = 1, theta_to_degrees = 90;
  int points = 0; ///< per axis
};

/// Mean |second difference| of A B C D over the whole table, along both axes.
double mean_second_difference(const table::LobeTable& table);

/// The region over which a table is measured.
struct MeasureOptions {
  double roughness_from = 0.06;
  double roughness_to = 1.0;
  double theta_to_degrees = 89.7;
  int points = 40; ///< per axis, uniform in roughness and theta, at the midpoints of cells
  QuadratureSize quadrature{40, 32};
};

/// Measures lobes against their BRDF. Does not depend on the number of threads. Fails when the BRDF
/// does (make_quadrature).
Result<TableError> measure_lobes(const brdf::Brdf& brdf, const LobeFunction& lobes,
                                 const MeasureOptions& options);

} // namespace openltc::fit
