#version 450
// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The shading source as Vulkan GLSL. Textures and sampler are separate objects, the one form that
// SPIR-V, WGSL, HLSL and MSL all have.

layout(set = 0, binding = 0) uniform texture2D table_coefficients;
layout(set = 0, binding = 1) uniform texture2D table_amplitudes;
layout(set = 0, binding = 2) uniform sampler table_sampler;
layout(set = 0, binding = 3, std140) uniform Polygons { vec4 openltc_polygons[256]; };
layout(set = 0, binding = 4, std140) uniform Polynomial {
  ivec4 polynomial_header;
  vec4 openltc_polynomial[56];
  vec4 openltc_polynomial_second[28];
};
layout(set = 0, binding = 5) uniform texture2DArray profiles;
layout(set = 0, binding = 6, std140) uniform Emissions { vec4 openltc_emissions[12]; };
layout(set = 0, binding = 7) uniform texture2DArray emission_stacks;
layout(set = 0, binding = 8) uniform texture2D table_second;
#define openltc_polynomial_degree polynomial_header.x
#define openltc_profiles sampler2DArray(profiles, table_sampler)
#define openltc_table_coefficients sampler2D(table_coefficients, table_sampler)
#define openltc_table_amplitudes sampler2D(table_amplitudes, table_sampler)
#define openltc_table_second sampler2D(table_second, table_sampler)
#define openltc_emission_stacks sampler2DArray(emission_stacks, table_sampler)

#include "openltc/target/glsl.inc"
#include "openltc/target/shade_all.inc"
#include "tests/shaders/shade_body.inc"

layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec3 in_wo;
layout(location = 3) in vec2 in_random;
layout(location = 0) out vec4 out_color;

void main() {
  out_color =
      vec4(shade_everything(in_position, normalize(in_normal), normalize(in_wo), in_random), 1.0);
}
