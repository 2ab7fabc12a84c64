// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Floating-point operations of the dialect, counted by running it with a number that counts.

#pragma once

#include "tests/shade/lights/light_batch.h"

namespace openltc::bench {

/// Additions, subtractions, multiplications, divisions and square roots that one point of a batch
/// takes, on average; comparisons, choices, minima, maxima and absolute values are free. Each point
/// takes its own shortcuts, as in scalar code, so that this is what has to be done, not what lanes
/// do.
double count_operations(const testing::LightBatch& batch, const LobeTableView& table);

} // namespace openltc::bench
