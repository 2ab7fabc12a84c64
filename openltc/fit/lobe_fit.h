// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The lobe that comes closest to a BRDF for one view direction and roughness.

#pragma once

#include "openltc/fit/objective.h"
#include "openltc/fit/quadrature.h"
#include "openltc/target/shade_f64.h"
#include "openltc/target/vec.h"

namespace openltc::fit {

/// What one fit minimises and when it stops.
struct LobeFitOptions {
  Objective objective;
  int max_iterations = 100;
  /// Stops after a step that lowers the objective by no more than this, relatively, and moves no
  /// coefficient by more than step_tolerance.
  double tolerance = 1e-7;
  double step_tolerance = 1e-3;
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

/// The share of the lobe above the surface's horizon, 0..1.
double above_horizon(const f64::Lobe& lobe);

/// What is missing to 1: the share below.
double lobe_leak(Vec4d mirror, double alpha, double cos_theta);

/// Fits all four coefficients, from `start`, which must have a positive determinant. At normal
/// incidence (cos_theta = 1) symmetry fixes A = 1 and B = C = 0 and only D is fitted.
LobeFit fit_lobe(const Quadrature& quadrature, Vec4d start, const LobeFitOptions& options);

/// The cosine lobe (M = identity) in mirror packing: where a sweep over roughness starts.
Vec4d cosine_start(double alpha, double cos_theta);

} // namespace openltc::fit
