// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A floor, y = 0, lit by a quad and a polygon. Stands beside ltc_lights.wgsl; the order does not matter.

struct Scene {
  size: vec4f,  // pixels
  eye: vec4f,
  right: vec4f, // of the picture at distance 1, half of its height long
  up: vec4f,    // the same
  back: vec4f,  // from what it looks at, unit
  floor_color_metallic: vec4f,
  floor_roughness: vec4f,
  quad_center: vec4f,
  quad_half_u: vec4f,
  quad_half_v: vec4f,
  quad_radiance: vec4f,
  star_radiance: vec4f,
  star: array<vec4f, 19>, // eight elements, and its ten points with the first one again
}
@group(0) @binding(0) var<uniform> scene: Scene;

// The star is the only polygon, so its index is 0.
fn ltc_polygon_data(i: i32) -> vec4f { return scene.star[i]; }

// What the floor at a point reflects to the eye. This is all that an engine's own shader takes over.
fn light_of_floor(position: vec3f, view: vec3f) -> vec3f {
  let surface = ltc_gltf_surface(position, vec3f(0.0, 1.0, 0.0), view, scene.floor_color_metallic.rgb,
                                 scene.floor_color_metallic.a, scene.floor_roughness.x);
  let quad = ltc_make_quad(scene.quad_center.xyz, scene.quad_half_u.xyz, scene.quad_half_v.xyz, 0.0);
  return scene.quad_radiance.rgb * ltc_shade_quad(surface, quad)
      + scene.star_radiance.rgb * ltc_shade_polygon(surface, 0);
}

// Whether a ray from the eye meets the front of the quad, a rectangle.
fn sees_quad(dir: vec3f) -> bool {
  let u = scene.quad_half_u.xyz;
  let v = scene.quad_half_v.xyz;
  let normal = cross(u, v);
  let to_center = scene.quad_center.xyz - scene.eye.xyz;
  let along = dot(dir, normal);
  let at = dir * (dot(to_center, normal) / along) - to_center;
  return along < 0.0 && abs(dot(at, u)) < dot(u, u) && abs(dot(at, v)) < dot(v, v);
}

// Whether it meets the front of the star: its outline crosses a half line from there an odd number of times.
fn sees_star(dir: vec3f) -> bool {
  let normal = ltc_polygon_normal(0);
  let along = dot(dir, normal);
  let at = scene.eye.xyz + dir * (dot(ltc_polygon_origin(0) - scene.eye.xyz, normal) / along);
  var inside = false;
  for (var i = 0; i + 1 < ltc_polygon_point_count(0); i++) {
    let a = ltc_polygon_point(0, i) - at;
    let b = ltc_polygon_point(0, i + 1) - at;
    if ((a.y > 0.0) != (b.y > 0.0) && (dot(cross(a, b), normal) > 0.0) == (b.y > a.y)) { inside = !inside; }
  }
  return along < 0.0 && inside;
}

// Radiance at a place of the picture, in pixels from its lower left corner.
fn radiance_at(pixel: vec2f) -> vec3f {
  let at = (2.0 * pixel - scene.size.xy) / scene.size.y;
  let dir = normalize(at.x * scene.right.xyz + at.y * scene.up.xyz - scene.back.xyz);
  if (sees_quad(dir)) { return scene.quad_radiance.rgb; }
  if (sees_star(dir)) { return scene.star_radiance.rgb; }
  if (dir.y >= 0.0) { return vec3f(0.0); }
  return light_of_floor(scene.eye.xyz - dir * (scene.eye.y / dir.y), -dir);
}

// For a screen: a curve without an end, and sRGB.
fn displayed(radiance: vec3f) -> vec3f {
  let x = 1.0 - exp(-0.5 * radiance);
  return select(12.92 * x, 1.055 * pow(x, vec3f(1.0 / 2.4)) - 0.055, x > vec3f(0.0031308));
}
