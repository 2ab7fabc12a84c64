#version 300 es
// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The shading source as GLSL ES 3.00, for WebGL 2.

precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArray;

uniform sampler2D openltc_table_coefficients;
uniform sampler2D openltc_table_amplitudes;
uniform sampler2D openltc_table_second;
uniform sampler2DArray openltc_profiles;
layout(std140) uniform Polygons { vec4 openltc_polygons[256]; };
uniform sampler2DArray openltc_emission_stacks;
uniform vec4 openltc_emissions[12];
uniform int openltc_polynomial_degree;
uniform vec4 openltc_polynomial[56];
uniform vec4 openltc_polynomial_second[1];

#include "openltc/target/glsl.inc"
#include "openltc/target/shade_all.inc"
#include "tests/shaders/shade_body.inc"

in vec3 position;
in vec3 normal;
in vec3 wo;
in vec2 random;
out vec4 color;

void main() {
  color = vec4(shade_everything(position, normalize(normal), normalize(wo), random), 1.0);
}
