// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "tests/parity/shader_case.h"

#include "openltc/target/shade_f32.h"

namespace openltc::f32 {
#define FN inline
#define FN_CALL inline
#include "tests/parity/case_body.inc"
// Builds on the one before.
#include "tests/parity/case_block.inc"
#undef FN_CALL
#undef FN
} // namespace openltc::f32

namespace openltc::testing {

const char* name_of(CaseShape shape) {
  constexpr const char* k_names[] = {"quad", "polygon", "disk", "sphere", "tube", "line"};
  return k_names[int(shape)];
}

void case_block_scalar(const CaseBlock& block, float* out) { f32::shade_block(block, out); }

} // namespace openltc::testing
