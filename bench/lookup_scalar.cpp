// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "bench/lookup.h"
#include "openltc/target/vec.h"

#include <cmath>

namespace openltc::bench {

namespace scalar {
using Scalar = float;
// Each builds on the one before.
// clang-format off
#include "openltc/target/scalar.inc"
#include "openltc/target/shade_all.inc"
#include "bench/lookup.inc"
// clang-format on
} // namespace scalar

void lookup_scalar(const LobeTableView& table, const LobePolynomialView& polynomial,
                   const float* roughness, const float* cos_theta, int count, float* out) {
  scalar::lookup(table, polynomial, roughness, cos_theta, count, out);
}

} // namespace openltc::bench
