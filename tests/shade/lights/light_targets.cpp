// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "tests/shade/lights/light_targets.h"

#include "openltc/base/processor.h"

namespace openltc::testing {

const std::vector<LightTarget>& light_targets() {
  static const std::vector<LightTarget> targets = [] {
    std::vector<LightTarget> list = {{"scalar", evaluate_lights_scalar, shade_lights_scalar}};
#ifdef OPENLTC_LIGHTS_BASELINE
    list.push_back({"baseline", evaluate_lights_baseline, shade_lights_baseline});
#endif
#ifdef OPENLTC_LIGHTS_SSE4
    if (has_sse4()) list.push_back({"sse4", evaluate_lights_sse4, shade_lights_sse4});
#endif
#ifdef OPENLTC_LIGHTS_AVX2
    if (has_avx2()) list.push_back({"avx2", evaluate_lights_avx2, shade_lights_avx2});
#endif
#ifdef OPENLTC_LIGHTS_AVX512
    if (has_avx512()) list.push_back({"avx512", evaluate_lights_avx512, shade_lights_avx512});
#endif
    return list;
  }();
  return targets;
}

} // namespace openltc::testing
