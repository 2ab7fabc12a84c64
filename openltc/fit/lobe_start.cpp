// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/fit/lobe_start.h"

#include <cmath>
#include <limits>

namespace openltc::fit {

namespace {

Objective balanced_like(const Objective& objective) {
  Objective balanced;
  balanced.horizon = objective.horizon;
  return balanced;
}

bool is_balanced(const Objective& o) {
  const Objective b;
  return o.tv == b.tv && o.l2 == b.l2 && o.l3 == b.l3 && o.rounding == b.rounding;
}

} // namespace

LobeFit fit_from_neighbour(const Quadrature& quadrature, Vec4d& balanced_start,
                           const LobeFitOptions& options) {
  LobeFitOptions first = options;
  first.objective = balanced_like(options.objective);
  LobeFit fit = fit_lobe(quadrature, balanced_start, first);
  balanced_start = fit.mirror;
  return is_balanced(options.objective) ? fit : fit_lobe(quadrature, fit.mirror, options);
}

LobeFit fit_from_starts(const Quadrature& q, std::span<const Vec4d> starts,
                        const LobeFitOptions& options) {
  const Objective balanced = balanced_like(options.objective);
  Vec4d best = cosine_start(q.width, q.cos_theta);
  double least = evaluate_objective(q, best, balanced, false).value;
  const auto consider = [&](Vec4d start) {
    const double value = evaluate_objective(q, start, balanced, false).value;
    if (value < least) {
      least = value;
      best = start;
    }
  };
  for (const Vec4d& start : starts)
    consider(start);
  for (double alpha = 0.5; alpha > 1e-4; alpha *= 0.5)
    consider(Vec4d(q.cos_theta, 0, 0, 2 * q.cos_theta * alpha / q.width));
  return fit_from_neighbour(q, best, options);
}

} // namespace openltc::fit
