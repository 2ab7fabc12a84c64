// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Compiled as C++14: see metal_stdlib.

#include "tests/shaders/metal/metal_case.h"

#include <ltc_lights_two_lobe_polynomial.metal>
#define LTC(name) ltc_##name
#include "tests/shaders/metal/metal_run.inc"

metal_run::Light metal_run::shade_by_two_lobe_polynomial(const Case& at) {
  return run(ltc_gltf_surface(vector_of(at.position), vector_of(at.normal), vector_of(at.view),
                              vector_of(at.base_color), at.metallic, at.roughness),
             at);
}
