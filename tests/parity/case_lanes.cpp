// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Cases in lanes. Compiled once per instruction set, with OPENLTC_ISA naming it.

#include "openltc/target/resources.h"
#include "openltc/target/vec.h"
#include "tests/parity/shader_case.h"

#include <hwy/highway.h>
// Highway asks for this order.
#include <hwy/contrib/math/math-inl.h>

#define OPENLTC_PASTE_(a, b) a##b
#define OPENLTC_PASTE(a, b) OPENLTC_PASTE_(a, b)
#define OPENLTC_LANES_NAMESPACE OPENLTC_PASTE(case_lanes_, OPENLTC_ISA)

namespace openltc {
namespace OPENLTC_LANES_NAMESPACE {

// Each builds on the one before.
// clang-format off
#include "openltc/target/lanes.inc"
#include "openltc/target/shade_all.inc"
#include "tests/parity/case_body.inc"
#include "tests/parity/case_block.inc"
// clang-format on

} // namespace OPENLTC_LANES_NAMESPACE

namespace testing {

void OPENLTC_PASTE(case_block_, OPENLTC_ISA)(const CaseBlock& block, float* out) {
  OPENLTC_LANES_NAMESPACE::shade_block(block, out);
}

} // namespace testing
} // namespace openltc
