// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The evaluations of a LightBatch that this build has and this CPU can run.

#pragma once

#include "tests/shade/lights/light_batch.h"

#include <vector>

namespace openltc::testing {

struct LightTarget {
  const char* name; ///< scalar, sse4, avx2, avx512, baseline
  EvaluateLights evaluate;
  ShadeLights shade;
};

/// Scalar first.
const std::vector<LightTarget>& light_targets();

} // namespace openltc::testing
