// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What stands before a file ltc_lights: the numbers of the scene, and where it finds those of a polygon.

#ifdef VULKAN
layout(set = 0, binding = 0, std140) uniform Scene {
#else
layout(std140) uniform Scene {
#endif
  vec4 size; // pixels
  vec4 eye;
  vec4 right; // of the picture at distance 1, half of its height long
  vec4 up;    // the same
  vec4 back;  // from what it looks at, unit
  vec4 floor_color_metallic;
  vec4 floor_roughness;
  vec4 quad_center;
  vec4 quad_half_u;
  vec4 quad_half_v;
  vec4 quad_radiance;
  vec4 star_radiance;
  vec4 star[19]; // eight elements, and its ten points with the first one again
};

// The star is the only polygon, so its index is 0.
vec4 ltc_polygon_data(int i) { return star[i]; }
