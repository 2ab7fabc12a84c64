// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The limit that any table of single lobes has.

#pragma once

#include "openltc/brdf/brdf.h"
#include "openltc/fit/measure/error.h"
#include "openltc/fit/objective.h"

namespace openltc::fit {

/// The best single lobe at every point by itself, fitted when asked for, from the lobe that `start`
/// gives there: what a table would read that had a node at every point. About 50 microseconds a
/// call. Where the BRDF fails, the start is returned.
LobeFunction best_single_lobes(const brdf::Brdf& brdf, LobeFunction start,
                               const Objective& objective);

} // namespace openltc::fit
