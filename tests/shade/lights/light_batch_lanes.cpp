// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Compiled once per instruction set, OPENLTC_ISA naming it, with the flags of the shading kernels.

#include "openltc/target/vec.h"
#include "tests/shade/lights/light_batch.h"

#include <hwy/highway.h>
// Highway asks for this order.
#include <hwy/contrib/math/math-inl.h>

#define OPENLTC_PASTE_(a, b) a##b
#define OPENLTC_PASTE(a, b) OPENLTC_PASTE_(a, b)
#define OPENLTC_LANES_NAMESPACE OPENLTC_PASTE(light_lanes_, OPENLTC_ISA)

namespace openltc {

namespace OPENLTC_LANES_NAMESPACE {
// Each builds on the one before.
// clang-format off
#include "openltc/target/lanes.inc"
#include "openltc/target/shade_all.inc"
#include "tests/shade/lights/light_batch_body.inc"
// clang-format on
} // namespace OPENLTC_LANES_NAMESPACE

namespace testing {

void OPENLTC_PASTE(evaluate_lights_, OPENLTC_ISA)(const LightBatch& batch,
                                                  const LobeTableView& table,
                                                  LightAnswers* answers) {
  OPENLTC_LANES_NAMESPACE::evaluate_batch(batch, table, answers);
}

void OPENLTC_PASTE(shade_lights_, OPENLTC_ISA)(const LightBatch& batch, const LobeTableView& table,
                                               float (*shaded)[k_batch]) {
  OPENLTC_LANES_NAMESPACE::shade_batch(batch, table, shaded);
}

} // namespace testing
} // namespace openltc
