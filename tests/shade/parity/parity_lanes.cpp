// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The dialect in lanes. Compiled once per instruction set, with OPENLTC_ISA naming it.

#include "openltc/target/resources.h"
#include "openltc/target/vec.h"
#include "tests/shade/parity/parity.h"

#include <hwy/highway.h>
// Highway asks for this order.
#include <hwy/contrib/math/math-inl.h>

#define OPENLTC_PASTE_(a, b) a##b
#define OPENLTC_PASTE(a, b) OPENLTC_PASTE_(a, b)
#define OPENLTC_LANES_NAMESPACE OPENLTC_PASTE(lanes_, OPENLTC_ISA)

namespace openltc {
namespace OPENLTC_LANES_NAMESPACE {

#include "openltc/target/lanes.inc"
#include "openltc/target/shade_all.inc"
#include "tests/shade/parity/parity_body.inc"

} // namespace OPENLTC_LANES_NAMESPACE

namespace testing {

namespace lanes = OPENLTC_LANES_NAMESPACE;

int OPENLTC_PASTE(parity_run_, OPENLTC_ISA)(const float* in, int count,
                                            const ParityResources& resources, float* out) {
  int outputs = 0;
  for (int i = 0; i < count; i += lanes::k_lanes) {
    lanes::Real inputs[k_parity_inputs], results[k_parity_max_outputs];
    for (int k = 0; k < k_parity_inputs; ++k)
      inputs[k] = lanes::load(in + k * count + i);
    outputs = lanes::parity_evaluate(inputs, resources, results, nullptr);
    for (int k = 0; k < outputs; ++k)
      lanes::store(results[k], out + k * count + i);
  }
  return outputs;
}

int OPENLTC_PASTE(parity_lanes_, OPENLTC_ISA)() { return lanes::k_lanes; }

void OPENLTC_PASTE(parity_break_, OPENLTC_ISA)() {
  alignas(64) float z[lanes::k_lanes];
  for (int lane = 0; lane < lanes::k_lanes; ++lane)
    z[lane] = lane + 1 < lanes::k_lanes ? 1.0f : 2.0f;
  const lanes::Real zero = lanes::Real(0.0f);
  const lanes::Vec3 up(zero, zero, lanes::Real(1.0f));
  const lanes::Frame frame = lanes::shading_frame(lanes::Vec3(zero, zero, lanes::load(z)), up);
  lanes::store(frame.n.z, z);
}

} // namespace testing
} // namespace openltc
