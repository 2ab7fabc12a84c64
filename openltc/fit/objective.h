// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What a fit minimises: distances between the lobe D and the normalised BRDF p = rho/E.

#pragma once

#include "openltc/base/result.h"
#include "openltc/fit/quadrature.h"
#include "openltc/target/vec.h"

#include <string>
#include <string_view>

namespace openltc::fit {

/// What becomes of the part of the lobe below the surface's horizon.
enum class Horizon {
  clipped, ///< shading divides by the share above, as shade/surface.glsl does: s D, integral 1
  leaking  ///< it is lost, or shines through the surface, as in engines that do not clip
};

/// Weighted sum of distances, r being s D - p (clipped) or D - p (leaking) above the horizon:
///   F = tv (1/2 integral |r| + 1/2 leak) + l2 integral r^2 / integral p^2
///     + l3 integral |r|^3 / integral p^3,
/// |r| rounded at 0 to r^2 / (|r| + e), e = rounding p and a little. The leak counts only when
/// leaking. Defaults: `balanced`.
struct Objective {
  std::string name = "balanced";
  double tv = 1;
  double l2 = 2;
  double l3 = 2;
  double rounding = 0.05;
  Horizon horizon = Horizon::clipped;
};

/// balanced, tv, l2 or l3; the error lists them.
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

/// Evaluates F; infinite where the determinant is not positive. The same bits on every instruction
/// set.
ObjectiveValue evaluate_objective(const Quadrature& quadrature, Vec4d mirror,
                                  const Objective& objective);

} // namespace openltc::fit
