// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Compiled as C++14: see metal_stdlib. Names begin otherwise, as an engine may want it.

#include "tests/shaders/metal/metal_case.h"

#include <Area_lights_two_lobe.metal>
#define LTC(name) Area_##name
#include "tests/shaders/metal/metal_run.inc"

metal_run::Light metal_run::shade_by_two_lobes(const Case& at, const Picture& coefficients,
                                               const Picture& amplitudes, const Picture& second) {
  return run(Area_gltf_surface(texture_of(coefficients), texture_of(amplitudes), texture_of(second),
                               sampler(), vector_of(at.position), vector_of(at.normal),
                               vector_of(at.view), vector_of(at.base_color), at.metallic,
                               at.roughness),
             at);
}
