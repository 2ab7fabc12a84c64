// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Where fits begin. Internal to fit.

#pragma once

#include "openltc/fit/lobe_fit.h"

#include <span>

namespace openltc::fit {

/// The best of the given starts, of the cosine and of mirror lobes of several widths: the one with
/// the least objective, refined under `balanced`, whose valley is wide, before the fit under the
/// options' own objective.
LobeFit fit_from_starts(const Quadrature& quadrature, std::span<const Vec4d> starts,
                        const LobeFitOptions& options);

/// A fit that follows a neighbour's: `balanced` from `balanced_start`, which is moved to its
/// result, then the options' own objective. So every objective stays in the same valley from node
/// to node.
LobeFit fit_from_neighbour(const Quadrature& quadrature, Vec4d& balanced_start,
                           const LobeFitOptions& options);

} // namespace openltc::fit
