#version 450
// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The shading source in a compute shader, polygons in a storage buffer.

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) uniform texture2D table_coefficients;
layout(set = 0, binding = 1) uniform texture2D table_amplitudes;
layout(set = 0, binding = 2) uniform sampler table_sampler;
layout(set = 0, binding = 3, std430) readonly buffer Polygons { vec4 openltc_polygons[]; };
layout(set = 0, binding = 4, std430) readonly buffer Points { vec4 points[]; };
layout(set = 0, binding = 5, std430) buffer Colors { vec4 colors[]; };
layout(set = 0, binding = 6, std430) readonly buffer Polynomial { vec4 openltc_polynomial[]; };
layout(set = 0, binding = 11, std430) readonly buffer Second { vec4 openltc_polynomial_second[]; };
layout(set = 0, binding = 7) uniform texture2DArray profiles;
layout(set = 0, binding = 8, std430) readonly buffer Emissions { vec4 openltc_emissions[]; };
layout(set = 0, binding = 9) uniform texture2DArray emission_stacks;
layout(set = 0, binding = 10) uniform texture2D table_second;
const int openltc_polynomial_degree = 4;
#define openltc_profiles sampler2DArray(profiles, table_sampler)
#define openltc_table_coefficients sampler2D(table_coefficients, table_sampler)
#define openltc_table_amplitudes sampler2D(table_amplitudes, table_sampler)
#define openltc_table_second sampler2D(table_second, table_sampler)
#define openltc_emission_stacks sampler2DArray(emission_stacks, table_sampler)

#include "openltc/target/glsl.inc"
#include "openltc/target/shade_all.inc"
#include "tests/shaders/shade_body.inc"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  vec3 color = shade_everything(points[3 * i].xyz, points[3 * i + 1].xyz, points[3 * i + 2].xyz,
                                vec2(points[3 * i].w, points[3 * i + 1].w));
  colors[i] = vec4(color, 1.0);
}
