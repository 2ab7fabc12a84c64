// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// How far lobes are from their BRDF, between the nodes of a table or on them, through the look-up
// that shading uses.

#pragma once

#include "openltc/brdf/brdf.h"
#include "openltc/fit/horizon.h"
#include "openltc/fit/quadrature.h"
#include "openltc/table/layout.h"
#include "openltc/table/lobe_table.h"
#include "openltc/target/shade_f64.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace openltc::fit {

/// Distances between a lobe D and rho/E at one view angle and roughness, both of integral 1.
/// Read D / (1 - leak) for D where the horizon is clipped.
///
/// A lobe whose determinant is not positive is no distribution, although an engine's layout may
/// interpolate to one: it counts as all wrong, tv = 1, l1 = 2, l2 = l3 = peak = 1, and leaks 0.
struct LobeError {
  double tv = 0; ///< 1/2 integral over the sphere of |rho/E - D|, 0..1; lost leak included
  /// E tv + |n1 of the table - E|: no light of radiance 0..1 errs by more where F = 1, whatever its
  /// shape and texture. Zero where only the lobe is known, not its amplitude (measure_lobe).
  double bound = 0;
  double l1 = 0;   ///< integral of |rho/E - D| over the hemisphere
  double l2 = 0;   ///< (integral of |..|^2)^(1/2) over that of rho/E
  double l3 = 0;   ///< (integral of |..|^3)^(1/3) over that of rho/E
  double peak = 0; ///< |max D / max rho/E - 1| over the quadrature's points
  double leak = 0; ///< share of the lobe itself below the surface's horizon, whatever the reading
  double n1 = 0;   ///< |n1 of the table - E|
  double n5 = 0;   ///< the same for its Schlick-weighted part
};

/// One figure of a LobeError, for code that treats all alike.
struct LobeErrorField {
  const char* name;
  double LobeError::*member;
};

/// All of them, in the order of the struct.
std::span<const LobeErrorField> lobe_error_fields();

/// What shading reads at one place: a lobe with its amplitudes and, where there are two, a second
/// one that has a share of n1.
struct MeasuredLobe : f64::FittedLobe {
  f64::SecondLobe second{f64::cosine_lobe(), 0};

  MeasuredLobe() : f64::FittedLobe{f64::cosine_lobe(), 1, 0} {}
  MeasuredLobe(const f64::FittedLobe& fitted) : f64::FittedLobe(fitted) {}
  MeasuredLobe(const f64::FittedLobe& fitted, const f64::SecondLobe& beside)
      : f64::FittedLobe(fitted), second(beside) {}
  bool two() const { return second.weight != 0; }
};

/// Error of one lobe against a quadrature of its BRDF; no amplitude is known: bound, n1, n5 are 0.
LobeError measure_lobe(const Quadrature& quadrature, const f64::Lobe& lobe,
                       Horizon horizon = Horizon::leaking);

/// The same for a lobe, or two, with amplitudes, as shading multiplies them: all figures. Of two
/// lobes the density is (1 - w) D1 + w D2, each read by its own horizon.
LobeError measure_lobe(const Quadrature& quadrature, const MeasuredLobe& fitted,
                       Horizon horizon = Horizon::leaking);

/// No entry, determinant, amplitude or weight is NaN or infinite.
bool is_finite(const MeasuredLobe& fitted);

/// What a lobe is multiplied with before it is compared: 1, or one over its share above the
/// surface's horizon, exactly as make_surface of shade/surface.glsl finds it.
double horizon_scale(const f64::Lobe& lobe, Horizon horizon);

/// Lobe and amplitudes for a roughness 0..1 and the cosine of the view angle, as shading reads
/// them: a table with its interpolation, a polynomial, a file of another layout. Called from any
/// thread.
using LobeFunction = std::function<MeasuredLobe(double roughness, double cos_theta)>;

/// The look-up of a native table, which must outlive the function.
LobeFunction lobes_of(const table::LobeTable& table);

/// The look-up of a table of any layout, as its engines do it; it must outlive the function.
LobeFunction lobes_of(const table::PackedTable& packed);

/// What lobes_of reads at one place, with the albedo as n1 and n5 where they are divided.
MeasuredLobe fetch_measured(const table::PackedTable& packed, double roughness, double cos_theta);

/// How a table's lobes are to be read: as its metadata says, otherwise clipped for the native
/// layout, which our shading reads, and leaking for those of other engines.
Horizon horizon_of(const table::PackedTable& packed);

/// Where lobes are measured: every roughness with every view angle.
struct MeasureAxes {
  std::vector<double> roughness;
  std::vector<double> theta_degrees;
};

/// Errors over a grid of roughness and view angle, one cell each.
struct ErrorMap {
  MeasureAxes axes;
  std::vector<LobeError> cells; ///< roughness fast, theta slow
  std::vector<double> albedo;   ///< E of the BRDF in each cell

  std::size_t columns() const { return axes.roughness.size(); }
  std::size_t rows() const { return axes.theta_degrees.size(); }
  const LobeError& at(std::size_t column, std::size_t row) const {
    return cells[row * columns() + column];
  }
};

/// Mean, median, 95th percentile and maximum of each figure over a region.
struct TableError {
  LobeError mean, p95, max, median;
  double roughness_from = 0, roughness_to = 1, theta_to_degrees = 90;
  int points = 0; ///< per axis; of roughness where the axes differ
};

/// Statistics of a map, every cell counted once. The bounds are those of the map's own axes.
TableError summarise(const ErrorMap& map);

/// Mean |second difference| of A B C D of the first lobe over the whole table, along both axes.
double mean_second_difference(const table::LobeTable& table);

/// Roughness of the first lobe over both axes, whatever their packing: mean |second difference| of
/// m00 m02 m20 m22 (M^-1 with middle element 1) between `points` x `points` samples, equidistant in
/// roughness and sqrt(1 - cos theta) from 0 to 1. `points` >= 3; 64 are the nodes of the tables
/// that engines use.
double mean_second_difference(const LobeFunction& lobes, int points = 64);

/// The region over which lobes are measured.
struct MeasureOptions {
  double roughness_from = 0.06;
  double roughness_to = 1.0;
  double theta_to_degrees = 89.7;
  int points = 40; ///< per axis, at the midpoints of cells, uniform in roughness and angle_axis
  /// The native table's own axis: every part of a table counts alike.
  table::AngleAxis angle_axis = table::AngleAxis::sqrt_one_minus_cos;
  QuadratureSize quadrature{40, 32};
  Horizon horizon = Horizon::leaking;
};

/// The angle in degrees at share t of the way from 0 to `theta_to_degrees` along an axis that is
/// uniform in theta or in sqrt(1 - cos theta).
double theta_at(double t, double theta_to_degrees, table::AngleAxis axis);

/// The midpoints of a region's cells.
MeasureAxes midpoint_axes(const MeasureOptions& options);

/// The nodes of a table that lie in a region: its columns and rows between the bounds.
MeasureAxes node_axes(const table::LobeTable& table, const MeasureOptions& region);

/// Lobes to be measured and how their horizon is read.
struct MeasuredLobes {
  std::string label; ///< for messages
  LobeFunction lobes;
  Horizon horizon = Horizon::leaking;
};

/// Measures several sets of lobes against one BRDF on the same axes and quadrature, one map each.
/// Does not depend on the number of threads. Fails when the BRDF does (make_quadrature), when a
/// lobe or amplitude is not finite, or when the axes are empty.
Result<std::vector<ErrorMap>> measure_maps(const brdf::Brdf& brdf,
                                           std::span<const MeasuredLobes> candidates,
                                           const MeasureAxes& axes, QuadratureSize quadrature);

/// Measures lobes against their BRDF over a region: summarise() of its map.
Result<TableError> measure_lobes(const brdf::Brdf& brdf, const LobeFunction& lobes,
                                 const MeasureOptions& options);

} // namespace openltc::fit
