// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "light_targets.h"

namespace openltc::testing {

const std::vector<LightTarget>& light_targets() {
  static const std::vector<LightTarget> targets = [] {
    std::vector<LightTarget> list = {{"scalar", evaluate_lights_scalar, shade_lights_scalar}};
#ifdef OPENLTC_LIGHTS_BASELINE
    list.push_back({"baseline", evaluate_lights_baseline, shade_lights_baseline});
#endif
#ifdef OPENLTC_LIGHTS_SSE4
    if (__builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("aes"))
      list.push_back({"sse4", evaluate_lights_sse4, shade_lights_sse4});
#endif
#ifdef OPENLTC_LIGHTS_AVX2
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
      list.push_back({"avx2", evaluate_lights_avx2, shade_lights_avx2});
#endif
#ifdef OPENLTC_LIGHTS_AVX512
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
      list.push_back({"avx512", evaluate_lights_avx512, shade_lights_avx512});
#endif
    return list;
  }();
  return targets;
}

} // namespace openltc::testing
