#version 450
// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The picture of vulkan.cpp: a pixel an invocation. The scene stands before the shader file, which reads it.

#extension GL_GOOGLE_include_directive : require
#include "scene.glsl"
#include "../../../shaders/ltc_lights.glsl"
#include "floor.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 1, std430) writeonly buffer Picture {
  vec4 picture[];
}; // rows from the bottom

void main() {
  uvec2 at = gl_GlobalInvocationID.xy, count = uvec2(size.xy);
  if (at.x < count.x && at.y < count.y)
    picture[at.y * count.x + at.x] = vec4(radiance_at(vec2(at) + 0.5), 1.0);
}
