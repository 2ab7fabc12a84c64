// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Many lobes fitted at once through what interpolates them: the nodes of a table under its bilinear
// look-up, or the coefficients of a polynomial.

#pragma once

#include "openltc/base/progress.h"
#include "openltc/fit/objective.h"
#include "openltc/fit/quadrature.h"
#include "openltc/target/vec.h"

#include <functional>
#include <vector>

namespace openltc::fit {

/// A share that one unknown has in a sample.
struct JointTerm {
  int unknown = 0;
  double factor = 0;
};

/// A place where the interpolated lobe is compared with the BRDF: what is interpolated there is the
/// sum of factor * unknown over the terms.
struct JointSample {
  Quadrature rule;
  double weight = 1; ///< of the objective; the penalty below counts fully
  std::vector<JointTerm> terms;
  /// The coefficients A B C D of what is interpolated, smooth; empty: that is what they are.
  std::function<Vec4d(Vec4d)> read = {};
};

/// When a joint fit stops, and what it keeps away from.
struct JointFitOptions {
  Objective objective;
  int max_iterations = 30;
  double tolerance = 1e-5; ///< relative decrease of the objective in one step
  /// A D - w B C is kept above this by a quadratic penalty, w being the lobe's width.
  double least_determinant = 0;
  int held = 0;      ///< so many of the first unknowns stay as they are
  Progress progress; ///< told of every step; when it asks to stop, the fit ends as it stands
};

struct JointFit {
  std::vector<Vec4d> unknowns; ///< A B C D each
  double objective = 0;        ///< weighted mean over the samples
  int iterations = 0;
  bool cancelled = false; ///< by the options' progress
};

/// Minimises the weighted sum of the objective over the samples from `start`, one Vec4d per
/// unknown, whose lobes need positive determinants at every sample. The result depends neither on
/// the number of threads nor on the instruction set.
JointFit fit_jointly(const std::vector<JointSample>& samples, std::vector<Vec4d> start,
                     const JointFitOptions& options);

/// The unknowns whose interpolated coefficients come closest, in the metric of the objective's
/// second derivatives there, to the best lobe of every sample by itself, while every sample's
/// determinant stays positive: where a joint fit can start.
std::vector<Vec4d> project_jointly(const std::vector<JointSample>& samples,
                                   const std::vector<Vec4d>& best, int unknown_count,
                                   const JointFitOptions& options);

/// Least squares of plain values through the same terms: sum of factor * unknown close to `values`,
/// the squares weighted with the samples' weights and with `importance` (empty: all alike).
std::vector<double> interpolate_jointly(const std::vector<JointSample>& samples,
                                        const std::vector<double>& values,
                                        const std::vector<double>& importance,
                                        std::vector<double> start);

} // namespace openltc::fit
