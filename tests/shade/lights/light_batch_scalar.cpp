// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/target/vec.h"
#include "tests/shade/lights/light_batch.h"

#include <cmath>

namespace openltc {

namespace light_batch_scalar {
using Scalar = float;
// Each builds on the one before.
// clang-format off
#include "openltc/target/scalar.inc"
#include "openltc/target/shade_all.inc"
#include "tests/shade/lights/light_batch_body.inc"
// clang-format on
} // namespace light_batch_scalar

namespace testing {

void evaluate_lights_scalar(const LightBatch& batch, const LobeTableView& table,
                            LightAnswers* answers) {
  light_batch_scalar::evaluate_batch(batch, table, answers);
}

void shade_lights_scalar(const LightBatch& batch, const LobeTableView& table,
                         float (*shaded)[k_batch]) {
  light_batch_scalar::shade_batch(batch, table, shaded);
}

} // namespace testing
} // namespace openltc
