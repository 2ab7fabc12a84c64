// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Polynomials of two lobes, from those of one. Private to polynomial_fit.cpp.

#pragma once

#include "openltc/base/progress.h"
#include "openltc/fit/joint/joint_fit.h"
#include "openltc/fit/objective.h"

#include <array>
#include <optional>
#include <vector>

namespace openltc::fit {

/// A term's coefficients: A B C D of both lobes and t, which the weight is made of
/// (shade/polynomial.glsl).
using TwoLobeTerm = std::array<double, 9>;

/// What the barrier weighs at first that keeps lobes from turning inside out.
inline constexpr double k_barrier = 1e-4;

/// Minimises the weighted sum of the objective over the samples, from one lobe's terms of this
/// degree. At every sample, those of weight 0 among them, which need a width and terms alone, both
/// determinants stay positive. The result depends neither on the number of threads nor on the
/// instruction set. None: `progress` asked to stop.
std::optional<std::vector<TwoLobeTerm>> fit_two_lobe_terms(const std::vector<JointSample>& samples,
                                                           const std::vector<Vec4d>& one,
                                                           int degree, const Objective& objective,
                                                           double barrier,
                                                           const Progress& progress);

} // namespace openltc::fit
