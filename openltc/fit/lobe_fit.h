// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The lobe that comes closest to a BRDF for one view direction and roughness.

#pragma once

#include "openltc/fit/quadrature.h"
#include "openltc/target/vec.h"

namespace openltc::fit {

/// What one fit minimises and when it stops.
struct LobeFitOptions {
  /// Weight of the squared L2 distance, relative to that of the BRDF's lobe, beside the total
  /// variation. 0 is pure total variation.
  double l2_weight = 0.3;
  /// Width of the rounding of |x| at 0, relative to the local density of the quadrature.
  double rounding = 0.05;
  int max_iterations = 200;
  /// Stops when no coefficient moves by more than this.
  double tolerance = 1e-7;
};

/// Result of a fit.
struct LobeFit {
  Vec4d mirror{1, 0, 0, 1}; ///< A B C D, see lobe_from_mirror in shade/lobe.glsl
  double objective = 0;
  int iterations = 0;
  bool converged = false;
};

/// Density of the lobe with coefficients `mirror` in a direction given in the mirror frame, and its
/// derivatives by A B C D. The formula stands in the .cpp file. Zero where o.z <= 0.
struct LobeDensity {
  double value = 0;
  double derivative[4] = {0, 0, 0, 0};
};
LobeDensity lobe_density(Vec4d mirror, double alpha, Vec3d wi_mirror);

/// The share of the lobe below the surface's horizon, 0..1.
double lobe_leak(Vec4d mirror, double alpha, double cos_theta);

/// Fits all four coefficients, from `start`, which must have a positive determinant. At normal
/// incidence (cos_theta = 1) symmetry fixes A = 1 and B = C = 0 and only D is fitted.
LobeFit fit_lobe(const Quadrature& quadrature, Vec4d start, const LobeFitOptions& options);

/// The cosine lobe (M = identity) in mirror packing: where a sweep over roughness starts.
Vec4d cosine_start(double alpha, double cos_theta);

} // namespace openltc::fit
