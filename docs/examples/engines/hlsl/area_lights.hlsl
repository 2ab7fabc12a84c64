// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What a surface reflects to the eye of a quad and the polygon of star.hlsl. Stands behind star.hlsl and
// ltc_lights.hlsl.
//
// All in one frame and one unit of length; `normal` on the viewer's side and `view`, to the eye, are unit; the
// roughness is perceptual. The quad shines along quad_half_u x quad_half_v, by the formula of the cross product.

float3 area_lights(float3 position, float3 normal, float3 view, float3 base_color, float metallic,
                   float roughness, float3 quad_center, float3 quad_half_u, float3 quad_half_v,
                   float3 quad_radiance, float3 star_radiance) {
  ltc_Surface surface =
      ltc_gltf_surface(position, normal, view, base_color, metallic, roughness);
  ltc_Quad quad = ltc_make_quad(quad_center, quad_half_u, quad_half_v, 0.0);
  return quad_radiance * ltc_shade_quad(surface, quad) +
         star_radiance * ltc_shade_polygon(surface, 0);
}
