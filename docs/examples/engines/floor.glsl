// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A floor, y = 0, lit by a quad and a polygon. Stands behind scene.glsl and a file ltc_lights; GLSL and GLSL ES.

// What the floor at a point reflects to the eye. This is all that an engine's own shader takes over.
vec3 light_of_floor(vec3 position, vec3 view) {
  ltc_Surface surface =
      ltc_gltf_surface(position, vec3(0.0, 1.0, 0.0), view, floor_color_metallic.rgb,
                       floor_color_metallic.a, floor_roughness.x);
  ltc_Quad quad = ltc_make_quad(quad_center.xyz, quad_half_u.xyz, quad_half_v.xyz, 0.0);
  return quad_radiance.rgb * ltc_shade_quad(surface, quad) +
         star_radiance.rgb * ltc_shade_polygon(surface, 0);
}

// Whether a ray from the eye meets the front of the quad, a rectangle.
bool sees_quad(vec3 dir) {
  vec3 normal = cross(quad_half_u.xyz, quad_half_v.xyz), to_center = quad_center.xyz - eye.xyz;
  float along = dot(dir, normal);
  vec3 at = dir * (dot(to_center, normal) / along) - to_center;
  return along < 0.0 && abs(dot(at, quad_half_u.xyz)) < dot(quad_half_u.xyz, quad_half_u.xyz) &&
         abs(dot(at, quad_half_v.xyz)) < dot(quad_half_v.xyz, quad_half_v.xyz);
}

// Whether it meets the front of the star: its outline crosses a half line from there an odd number of times.
bool sees_star(vec3 dir) {
  vec3 normal = ltc_polygon_normal(0);
  float along = dot(dir, normal);
  vec3 at = eye.xyz + dir * (dot(ltc_polygon_origin(0) - eye.xyz, normal) / along);
  bool inside = false;
  for (int i = 0; i + 1 < ltc_polygon_point_count(0); ++i) {
    vec3 a = ltc_polygon_point(0, i) - at, b = ltc_polygon_point(0, i + 1) - at;
    if ((a.y > 0.0) != (b.y > 0.0) && (dot(cross(a, b), normal) > 0.0) == (b.y > a.y))
      inside = !inside;
  }
  return along < 0.0 && inside;
}

// Radiance at a place of the picture, in pixels from its lower left corner.
vec3 radiance_at(vec2 pixel) {
  vec2 at = (2.0 * pixel - size.xy) / size.y;
  vec3 dir = normalize(at.x * right.xyz + at.y * up.xyz - back.xyz);
  if (sees_quad(dir)) return quad_radiance.rgb;
  if (sees_star(dir)) return star_radiance.rgb;
  if (dir.y >= 0.0) return vec3(0.0);
  return light_of_floor(eye.xyz - dir * (eye.y / dir.y), -dir);
}

// For a screen: a curve without an end, and sRGB.
vec3 displayed(vec3 radiance) {
  vec3 x = 1.0 - exp(-0.5 * radiance);
  return mix(12.92 * x, 1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055,
             vec3(greaterThan(x, vec3(0.0031308))));
}
