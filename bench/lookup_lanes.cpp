// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Compiled once per instruction set, OPENLTC_ISA naming it, with the flags of the shading kernels.

#include "bench/lookup.h"
#include "openltc/target/vec.h"

#include <hwy/highway.h>
// Highway's math comes after the core.
#include <hwy/contrib/math/math-inl.h>

#define OPENLTC_PASTE_(a, b) a##b
#define OPENLTC_PASTE(a, b) OPENLTC_PASTE_(a, b)

namespace openltc::bench {

namespace OPENLTC_ISA {
// Each builds on the one before.
// clang-format off
#include "openltc/target/lanes.inc"
#include "openltc/target/shade_all.inc"
#include "bench/lookup.inc"
// clang-format on
} // namespace OPENLTC_ISA

void OPENLTC_PASTE(lookup_, OPENLTC_ISA)(const LobeTableView& table,
                                         const LobePolynomialView& polynomial,
                                         const float* roughness, const float* cos_theta, int count,
                                         float* out) {
  OPENLTC_ISA::lookup(table, polynomial, roughness, cos_theta, count, out);
}

} // namespace openltc::bench
