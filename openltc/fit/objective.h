// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What a fit minimises: distances between the lobe D and the normalised BRDF p = rho/E.

#pragma once

#include "openltc/base/result.h"
#include "openltc/fit/horizon.h"
#include "openltc/fit/quadrature.h"
#include "openltc/target/vec.h"

#include <array>
#include <string>
#include <string_view>

namespace openltc::fit {

/// Weighted sum of distances, r being D / (1 - leak) - p (clipped) or D - p (leaking) above the
/// horizon, p = rho/E:
///   F = tv TV + l2 L2 + l3 L3,   TV = integral of max(-r, 0),
///   L2 = (integral r^2 / integral p^2)^(1/2),   L3 = (integral |r|^3 / integral p^3)^(1/3).
/// TV is the total variation, as the energy that D misses where p is: both integrate to 1, over the
/// hemisphere when clipped, over the sphere when leaking, and what is missing here is too much
/// elsewhere, also where the quadrature has no points. |r| in it is rounded at 0 to
/// r^2 / (|r| + e), e = rounding p and a little. Norms, not their powers: powers would weigh the
/// cells of a table that no lobe fits well hundreds of times more than the others.
/// Defaults: `balanced`.
struct Objective {
  std::string name = "balanced";
  double tv = 1;
  double l2 = 0.22;
  double l3 = 0.22;
  double rounding = 0.05;
  Horizon horizon = Horizon::clipped;
};

/// balanced, tv, l2, l3, or three weights as "TV,L2,L3"; the error lists them.
Result<Objective> find_objective(std::string_view name);

/// The names find_objective knows.
inline constexpr const char* k_objective_names[] = {"balanced", "tv", "l2", "l3"};

/// F at one set of coefficients, its gradient by A B C D and a positive semidefinite matrix in
/// place of its second derivatives: that of the reweighted squares.
struct ObjectiveValue {
  double value = 0;
  double gradient[4] = {0, 0, 0, 0};
  double hessian[10] = {}; ///< upper triangle by rows
};

/// Evaluates F, and its derivatives when asked for; infinite where the determinant is not positive.
/// The same bits on every instruction set.
ObjectiveValue evaluate_objective(const Quadrature& quadrature, Vec4d mirror,
                                  const Objective& objective, bool with_derivatives = true);

/// The unknowns of two lobes together: A B C D of the first, those of the second, and the weight of
/// the second, that of the first being the rest.
using TwoLobes = std::array<double, 9>;

/// As ObjectiveValue, of the density (1 - w) D1 + w D2, each lobe divided by its own share above
/// the horizon when clipped.
struct TwoLobeObjectiveValue {
  double value = 0;
  TwoLobes gradient{};
  std::array<double, 45> hessian{}; ///< upper triangle by rows
};

/// Evaluates F of two lobes, and its derivatives when asked for; infinite where a determinant is
/// not positive or the weight not within 0..1. The same bits on every instruction set.
TwoLobeObjectiveValue evaluate_objective(const Quadrature& quadrature, const TwoLobes& lobes,
                                         const Objective& objective, bool with_derivatives = true);

} // namespace openltc::fit
