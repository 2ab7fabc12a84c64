// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Area lights in closed form, by linearly transformed cosines (LTC).
// Language: WGSL. Shapes: quad, polygon, disk, sphere, tube, line, textured.
//
// Made by OpenLTC 0.1.0 from its shading source, and readable and yours to change like that:
//   openltc shaders --language wgsl --shapes all
//
// BRDF   GGX with height-correlated Smith masking and Schlick's Fresnel, over Lambert.
// Lobe   one, by polynomials of degree 4 in this file: no texture. It differs from the BRDF by a
//        total variation 0.038 in the mean, 0.30 at most, which bounds the error of every light
//        (docs/fitting.md).
//
// How to call it:
//   let surface = ltc_gltf_surface(position, normal, view, base_color, metallic, roughness);
//   let lamp = ltc_make_quad(center, half_u, half_v, 0.0);
//   light += radiance * ltc_shade_quad(surface, lamp);
//   light += radiance * ltc_shade_polygon(surface, outline);
//   let disk = ltc_make_disk(center, normal_of_disk, radius, 0.0);
//   light += radiance * ltc_shade_ellipse(surface, disk);
//   let ball = ltc_make_sphere(center, radius);
//   light += radiance * ltc_shade_sphere(surface, ball);
//   let rod = ltc_make_tube(one_end, other_end, radius, 2.0);
//   light += radiance * ltc_shade_tube(surface, rod);
//   let wire = ltc_make_line(one_end, other_end);
//   light += intensity_per_metre * ltc_shade_line(surface, wire);
//   let screen = ltc_make_quad(center, half_u, half_v, 0.0);
//   light += radiance * ltc_shade_textured_quad(surface, screen, picture, picture_sampler);
// `normal`, on the viewer's side, and `view`, to the eye, are unit and in world space, like all else;
// a lamp emits along half_u x half_v. The result has no shadow. One `surface` serves all lights.
// Polygons are read by a function of yours, which stands before this file:
//   fn ltc_polygon_data(i: i32) -> vec4f   element i of what "polygon data" below says
// `outline` is the index of a polygon's first element.
//
// More:
//   ltc_surface_at              a surface of any reflectance, instead of glTF's
//   ltc_set_geometric_normal    where a normal map turns the normal: hides what the triangle does
//   ltc_correct_at_mean         small lights become exact, for a few instructions more
//   ltc_shade_..._parts         diffuse and specular light apart
//
// Comments are those of the source: names have no ltc_ there, a lane is an invocation, and files that
// they name are OpenLTC's, as is docs/method.md, where all is derived.

// ---- constants ----------------------------------------------------------------------------------
//
// Constants. CONSTANT is a compile-time scalar in every target.

// pi
const ltc_k_pi: f32 = 3.14159265358979323846;

// 1 / pi
const ltc_k_inv_pi: f32 = 0.31830988618379067154;

// 1 / (2 pi)
const ltc_k_half_inv_pi: f32 = 0.15915494309189533577;

// Smallest microfacet width that shading uses: roughness 0.01. A perfect mirror has no finite
// density; at this width the lobe is 0.01 degrees wide, below what a pixel resolves, and single
// precision still carries it.
const ltc_k_min_alpha: f32 = 1.0e-4;

// What rounding may make of a distance of 0 from a plane, relative to that from the plane's origin:
// four units in the last place of single precision.
const ltc_k_plane_rounding: f32 = 2.5e-7;

// Rounding of a position on a triangle in world space, relative to its distance from the origin: some
// ten units in the last place of single precision.
const ltc_k_position_rounding: f32 = 6.0e-7;

// Length of the difference of two unit normals up to which they are the same: some ten units in the
// last place of single precision.
const ltc_k_normal_rounding: f32 = 1.0e-6;

// Least share of a lobe above the horizon that its amplitude is divided by. Fitted lobes have 0.7
// and more there; a lobe of a damaged table must not magnify rounding.
const ltc_k_min_share: f32 = 0.01;

// Most that a light's specular part is multiplied by (blended_ratio), so that it fades where a light
// leaves the lobe, beyond whose own horizon there is nothing to multiply. Where the BRDF is so many times
// the lobe, there is next to nothing of either.
const ltc_k_max_ratio: f32 = 64.0;

// Added under a division or a square root whose argument may vanish; far below any length in use.
const ltc_k_tiny: f32 = 1.0e-30;

// Added to the square of a length under an inverse root: the product of two inverse lengths, at most
// 1e11 each, and an inverse sine, at most 1e15, stays finite.
const ltc_k_least_length2: f32 = 1.0e-22;

// ---- quad data ----------------------------------------------------------------------------------
//
// A light of four corners, known by its middle.

// A rectangle or parallelogram in world space; emits along half_u x half_v.
struct ltc_Quad {
  center: vec3f,  // world space
  half_u: vec3f,  // from there to the middle of one side, metres
  half_v: vec3f,  // and to that of the next, counter-clockwise as seen from the front
  two_sided: f32, // 0 or 1
}

// Corner i, counter-clockwise as seen from the front; 4 is the first again.
fn ltc_quad_point(quad: ltc_Quad, i: i32) -> vec3f {
  let u = select(-1.0, 1.0, i == 1 || i == 2);
  let v = select(-1.0, 1.0, i == 2 || i == 3);
  return quad.center + quad.half_u * u + quad.half_v * v;
}

// A point of its plane.
fn ltc_quad_origin(quad: ltc_Quad) -> vec3f { return quad.center; }

// Unit, to the emitting side.
fn ltc_quad_normal(quad: ltc_Quad) -> vec3f {
  let normal = cross(quad.half_u, quad.half_v);
  return normal * inverseSqrt(max(dot(normal, normal), ltc_k_tiny));
}

// Whether it emits to both sides.
fn ltc_quad_two_sided(quad: ltc_Quad) -> bool { return quad.two_sided > 0.0; }

// Square metres.
fn ltc_quad_area(quad: ltc_Quad) -> f32 {
  let normal = cross(quad.half_u, quad.half_v);
  return sqrt(dot(normal, normal)) * 4.0;
}

// The middle of its area.
fn ltc_quad_centroid(quad: ltc_Quad) -> vec3f { return quad.center; }

// From there to the middle of the side from corner 1 to 2.
fn ltc_quad_half_u(quad: ltc_Quad) -> vec3f { return quad.half_u; }

// And of that from 2 to 3.
fn ltc_quad_half_v(quad: ltc_Quad) -> vec3f { return quad.half_v; }

// The distance of the farthest corner from there.
fn ltc_quad_radius(quad: ltc_Quad) -> f32 {
  return sqrt(dot(quad.half_u, quad.half_u) + dot(quad.half_v, quad.half_v) +
              2.0 * abs(dot(quad.half_u, quad.half_v)));
}

// sqrt(2/3): sqrt(2) times the standard deviation of -1..1.
const ltc_k_quad_spread: f32 = 0.81649658092772603;

// Half of what stands for it where it is small: the mean over centroid +- spread_u and +- spread_v is
// that over its area for every quadratic function.
fn ltc_quad_spread_u(quad: ltc_Quad) -> vec3f { return quad.half_u * ltc_k_quad_spread; }

// And the other half.
fn ltc_quad_spread_v(quad: ltc_Quad) -> vec3f { return quad.half_v * ltc_k_quad_spread; }

// ---- polygon data -------------------------------------------------------------------------------
//
// Polygons of any outline are four-component vectors that the caller provides, one polygon after the
// other:
//   0  number of points, two-sided (0 or 1), area, 0
//   1  origin: a point of its plane, 0
//   2, 3  not read
//   4  normal: unit, to the emitting side, 0
//   5  centroid of its area, distance of the farthest point from there
//   6  spread u, 0     7  spread v, 0
//   8 and on: its points, 1 where a ring begins, else 0
// Rings run counter-clockwise as seen from the front, holes clockwise, and each ends with its first point
// again. The spreads are sqrt(2) times the standard deviations of the area along its principal axes, as
// vectors; for a rectangle those are half of its sides times sqrt(2/3).

// Number of points.
fn ltc_polygon_point_count(polygon: i32) -> i32 { return i32(ltc_polygon_data(polygon).x); }

// Whether it emits to both sides.
fn ltc_polygon_two_sided(polygon: i32) -> bool { return ltc_polygon_data(polygon).y != 0.0; }

// Square metres.
fn ltc_polygon_area(polygon: i32) -> f32 { return ltc_polygon_data(polygon).z; }

// A point of its plane.
fn ltc_polygon_origin(polygon: i32) -> vec3f { return ltc_polygon_data(polygon + 1).xyz; }

// Unit, to the emitting side.
fn ltc_polygon_normal(polygon: i32) -> vec3f { return ltc_polygon_data(polygon + 4).xyz; }

// The middle of its area.
fn ltc_polygon_centroid(polygon: i32) -> vec3f { return ltc_polygon_data(polygon + 5).xyz; }

// The distance of the farthest point from there.
fn ltc_polygon_radius(polygon: i32) -> f32 { return ltc_polygon_data(polygon + 5).w; }

// How far it spreads.
fn ltc_polygon_spread_u(polygon: i32) -> vec3f { return ltc_polygon_data(polygon + 6).xyz; }

// And across.
fn ltc_polygon_spread_v(polygon: i32) -> vec3f { return ltc_polygon_data(polygon + 7).xyz; }

// Point i.
fn ltc_polygon_point(polygon: i32, i: i32) -> vec3f {
  return ltc_polygon_data(polygon + 8 + i).xyz;
}

// Whether a ring begins with it.
fn ltc_polygon_starts_ring(polygon: i32, i: i32) -> bool {
  return ltc_polygon_data(polygon + 8 + i).w != 0.0;
}

// ---- picture data -------------------------------------------------------------------------------
//
// The picture of a light: a texture with all its mip levels, linear filter between texels and between
// levels, clamped. It covers a rectangle, with (0, 0) at center - half_u - half_v, u along half_u and v
// along half_v. Its alpha is the share of a texel that shines, by which its colour has been multiplied: 1
// everywhere for a light that is whole.

// Columns and rows of the finest level.
fn ltc_emission_texel_count(emission: ltc_Quad, emission_picture: texture_2d<f32>,
                            emission_picture_sampler: sampler) -> vec2f {
  return vec2f(textureDimensions(emission_picture));
}

// The colour, times the share that shines, and that share.
fn ltc_emission_texel(emission: ltc_Quad, emission_picture: texture_2d<f32>,
                      emission_picture_sampler: sampler, uv: vec2f, level: f32) -> vec4f {
  return textureSampleLevel(emission_picture, emission_picture_sampler, uv, level);
}

// Where u and v are 0.
fn ltc_emission_corner(emission: ltc_Quad, emission_picture: texture_2d<f32>,
                       emission_picture_sampler: sampler) -> vec3f {
  return emission.center - emission.half_u - emission.half_v;
}

// Unit, the direction of u.
fn ltc_emission_axis_u(emission: ltc_Quad, emission_picture: texture_2d<f32>,
                       emission_picture_sampler: sampler) -> vec3f {
  return emission.half_u * inverseSqrt(max(dot(emission.half_u, emission.half_u), ltc_k_tiny));
}

// Unit, the direction of v.
fn ltc_emission_axis_v(emission: ltc_Quad, emission_picture: texture_2d<f32>,
                       emission_picture_sampler: sampler) -> vec3f {
  return emission.half_v * inverseSqrt(max(dot(emission.half_v, emission.half_v), ltc_k_tiny));
}

// Its sides, metres.
fn ltc_emission_extent(emission: ltc_Quad, emission_picture: texture_2d<f32>,
                       emission_picture_sampler: sampler) -> vec2f {
  return vec2f(2.0 * sqrt(dot(emission.half_u, emission.half_u)),
               2.0 * sqrt(dot(emission.half_v, emission.half_v)));
}

// ---- angle --------------------------------------------------------------------------------------
//
// Inverse tangents, the same in every target: of any angle to the last digits, for the lights' outlines, and
// of half a turn to 2.5e-7 radians, by one polynomial and no choice of range, for the profiles of light.

// atan(x) / x for |x| <= tan(pi/8), from x2 = x^2; relative error 2.2e-11 (Chebyshev interpolation).
fn ltc_atan_over_small(x2: f32) -> f32 {
  return 0.9999999999783847 +
         x2 *
         (-0.3333333209692669 +
          x2 *
          (0.19999883803916288 +
           x2 *
           (-0.14281587308807808 +
            x2 * (0.11040471028770685 + x2 * (-0.08456089562356194 + x2 * 0.04707129830797903)))));
}

// Angle of the vector (x, y) from the x axis, -pi..pi; 0 for the zero vector.
fn ltc_angle_of(x: f32, y: f32) -> f32 {
  let ax = abs(x);
  let ay = abs(y);
  let small = min(ax, ay);
  let large = max(max(ax, ay), ltc_k_tiny);
  // atan(t) = pi/4 + atan((t - 1)/(t + 1)) brings t from 0..1 to within tan(pi/8).
  let steep = small > 0.41421356237309503 * large;
  let t = select(small, small - large, steep) / select(large, small + large, steep);
  var angle = t * ltc_atan_over_small(t * t) + select(0.0, 0.25 * ltc_k_pi, steep);
  angle = select(angle, 0.5 * ltc_k_pi - angle, ay > ax);
  angle = select(angle, ltc_k_pi - angle, x < 0.0);
  return select(angle, -angle, y < 0.0);
}

// atan(x) / x, 1 at 0.
fn ltc_atan_over(x: f32) -> f32 {
  let a = abs(x);
  let small = a < 0.4;
  return select(ltc_angle_of(1.0, a) / max(a, 0.4), ltc_atan_over_small(min(a * a, 0.16)), small);
}

// ---- frame --------------------------------------------------------------------------------------
//
// The shading frame: t1 in the plane of normal and view direction, t2 = n x t1, n.
//
// In it wo = (sin theta, 0, cos theta), so an isotropic BRDF depends on theta and roughness alone.

// The shading frame of a point: the axes x, y and z of shading space, orthonormal.
struct ltc_Frame {
  t1: vec3f, // unit, world space
  t2: vec3f, // n x t1
  n: vec3f,  // the normal
}

// A unit vector perpendicular to the unit vector n, without a branch: Duff et al. 2017, "Building an
// Orthonormal Basis, Revisited", equation 3.
fn ltc_any_perpendicular(n: vec3f) -> vec3f {
  let s = select(1.0, -1.0, n.z < 0.0);
  let a = -1.0 / (s + n.z);
  return vec3f(1.0 + s * n.x * n.x * a, s * n.x * n.y * a, -s * n.x);
}

// Frame of a unit normal and a unit direction to the viewer, world space. When the two are
// parallel any tangent serves.
fn ltc_shading_frame(n: vec3f, wo: vec3f) -> ltc_Frame {
  let in_plane = wo - n * dot(n, wo);
  let length2 = dot(in_plane, in_plane);

  // Below this sine, 1e-4, rounding would dominate the direction; the lobe is round there.
  let parallel = length2 < 1.0e-8;
  var t1 = in_plane * inverseSqrt(max(length2, 1.0e-8));
  // Uniform shortcut: no lane looks along its normal.
  if (parallel) {
    t1 = ltc_any_perpendicular(n);
  }

  var frame: ltc_Frame;
  frame.t1 = t1;
  frame.t2 = cross(n, t1);
  frame.n = n;
  return frame;
}

// A vector of world space in shading space.
fn ltc_to_shading(frame: ltc_Frame, v_world: vec3f) -> vec3f {
  return vec3f(dot(frame.t1, v_world), dot(frame.t2, v_world), dot(frame.n, v_world));
}

// ---- ggx ----------------------------------------------------------------------------------------
//
// Trowbridge-Reitz (GGX) microfacet reflection with height-correlated Smith masking.
//
// Sources:
//   Walter, Marschner, Li, Torrance 2007, "Microfacet Models for Refraction through Rough
//     Surfaces", equation 33 (D);
//   Heitz 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs",
//     equations 72 and 99 (Lambda, height-correlated G2);
//   Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering", equation 24 (F);
//   Dupuy, Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps", listing 3 (sampling).
//
// All directions are unit, in shading space, and point away from the surface.

// Microfacet width from the artists' perceptual roughness, both 0..1.
fn ltc_alpha_from_roughness(roughness: f32) -> f32 {
  return max(roughness * roughness, ltc_k_min_alpha);
}

// (1 - cos)^5, the weight of F90 in Schlick's approximation.
fn ltc_schlick_weight(o_dot_h: f32) -> f32 {
  let m = min(max(1.0 - o_dot_h, 0.0), 1.0);
  let m2 = m * m;
  return m2 * m2 * m;
}

// schlick_weight at the microfacet that reflects one unit direction into the other, from their
// cosine: wo.h = sqrt((1 + wo.wi) / 2).
fn ltc_schlick_weight_between(o_dot_i: f32) -> f32 {
  return ltc_schlick_weight(sqrt(max(0.5 + 0.5 * o_dot_i, 0.0)));
}

// The `scale` of eval_ggx_terms by itself, by reciprocals instead of quotients and roots:
//   alpha^2 / (2 pi) (c / t)^2 cos_i / (cos_i root_o + cos_o root_i)
// with c = |wo + wi|^2 and t = |diag(1, 1, alpha) (wo + wi)|^2.
fn ltc_eval_ggx_scale(wo: vec3f, wi: vec3f, alpha: f32) -> f32 {
  let sum = wo + wi;
  let across2 = sum.x * sum.x + sum.y * sum.y;
  let up2 = sum.z * sum.z;
  let alpha2 = alpha * alpha;
  let slope = (across2 + up2) * (1.0 / max(across2 + alpha2 * up2, ltc_k_tiny));
  let cos_o = max(wo.z, 0.0);
  let cos_i = max(wi.z, 0.0);
  let root_o = cos_o * cos_o * (1.0 - alpha2) + alpha2;
  let root_i = cos_i * cos_i * (1.0 - alpha2) + alpha2;
  let masking = cos_i * (root_o * inverseSqrt(root_o)) + cos_o * (root_i * inverseSqrt(root_i));
  return 0.5 * ltc_k_inv_pi * alpha2 * (slope * slope) * cos_i * (1.0 / max(masking, ltc_k_tiny));
}

// ---- lobe ---------------------------------------------------------------------------------------
//
// The lobe: a linearly transformed cosine.
//
// Source: Heitz, Dupuy, Hill, Neubelt 2016, "Real-Time Polygonal-Light Shading with Linearly
// Transformed Cosines", equations 1, 2 and section 3.
//
// D_o(o) = max(0, o.z)/pi is the cosine on the hemisphere. A matrix M carries directions from
// cosine space to shading space, w = M o / |M o|, and D_o to the lobe
//   D(w) = D_o(o/|o|) |det M^-1| / |o|^3 = max(0, o.z) |det M^-1| / (pi |o|^4),   o = M^-1 w.
// An isotropic BRDF is symmetric about the plane of incidence, so M^-1 is, with row 1 scaled to 1,
//   [ m00  0  m02 ]
//   [  0   1   0  ]
//   [ m20  0  m22 ].

// A lobe by its matrix M^-1.
struct ltc_Lobe {
  m00: f32, // M^-1, shading space to cosine space
  m02: f32, // row 0, column 2
  m20: f32, // row 2, column 0
  m22: f32, // row 2, column 2
  det: f32, // det M^-1 = m00 m22 - m02 m20, positive
}

// The lobe of these elements, whose determinant is positive.
fn ltc_make_lobe(m00: f32, m02: f32, m20: f32, m22: f32) -> ltc_Lobe {
  var lobe: ltc_Lobe;
  lobe.m00 = m00;
  lobe.m02 = m02;
  lobe.m20 = m20;
  lobe.m22 = m22;
  lobe.det = m00 * m22 - m02 * m20;
  return lobe;
}

// The lobe of Lambert's BRDF: M = identity.
fn ltc_cosine_lobe() -> ltc_Lobe { return ltc_make_lobe(1.0, 0.0, 0.0, 1.0); }

// The lobe from its native packing in the mirror frame.
//
// With x' = (cos, 0, sin), z' = (-sin, 0, cos), z' being the mirror direction of wo,
//   M^-1 = [ A 0 aB ; 0 1 0 ; aC 0 aD ] [ x' ; y ; z' ],   a = alpha.
// As alpha vanishes A tends to cos and D to 2 cos: four smooth, bounded functions, which
// therefore interpolate well down to a mirror. Multiplied out:
//   m00 = A cos - a B sin     m02 = A sin + a B cos
//   m20 = a (C cos - D sin)   m22 = a (C sin + D cos).
fn ltc_lobe_from_mirror(abcd: vec4f, alpha: f32, cos_theta: f32) -> ltc_Lobe {
  let sin_theta = sqrt(max(1.0 - cos_theta * cos_theta, 0.0));
  let b = alpha * abcd.y;
  var lobe: ltc_Lobe;
  lobe.m00 = abcd.x * cos_theta - b * sin_theta;
  lobe.m02 = abcd.x * sin_theta + b * cos_theta;
  lobe.m20 = alpha * (abcd.z * cos_theta - abcd.w * sin_theta);
  lobe.m22 = alpha * (abcd.z * sin_theta + abcd.w * cos_theta);
  lobe.det = alpha * (abcd.x * abcd.w - alpha * abcd.y * abcd.z);
  return lobe;
}

// M^-1 v: a vector of shading space in cosine space, not normalised.
fn ltc_to_cosine(lobe: ltc_Lobe, v: vec3f) -> vec3f {
  return vec3f(lobe.m00 * v.x + lobe.m02 * v.z, v.y, lobe.m20 * v.x + lobe.m22 * v.z);
}

// M o up to a positive scale: the adjugate of M^-1 applied to a vector of cosine space.
fn ltc_from_cosine(lobe: ltc_Lobe, o: vec3f) -> vec3f {
  return vec3f(lobe.m22 * o.x - lobe.m02 * o.z, lobe.det * o.y, lobe.m00 * o.z - lobe.m20 * o.x);
}

// An upper bound of the square by which M^-1 lengthens a vector: its Frobenius norm.
fn ltc_lobe_stretch2(lobe: ltc_Lobe) -> f32 {
  return 1.0 + lobe.m00 * lobe.m00 + lobe.m02 * lobe.m02 + lobe.m20 * lobe.m20 +
         lobe.m22 * lobe.m22;
}

// The surface's normal in cosine space, unit: M^T z ~ (-m20, 0, m00), the normal of the plane to
// which M^-1 takes the horizon.
fn ltc_horizon_normal_cosine(lobe: ltc_Lobe) -> vec3f {
  let length2 = lobe.m00 * lobe.m00 + lobe.m20 * lobe.m20;
  let inv_length = inverseSqrt(max(length2, ltc_k_tiny));
  return vec3f(-lobe.m20 * inv_length, 0.0, lobe.m00 * inv_length);
}

// Integral of the lobe over the directions above the surface's horizon, 0..1; the rest leaks.
//
// In cosine space those directions are a lune, between the cosine's own horizon with normal z and
// the surface's with normal m. Lambert's edge sum over its two edges, half circles of length pi,
// makes (z + m) / 2 of it: the z component is this share, (1 + cos g) / 2 with g between z and m.
fn ltc_share_above_horizon(lobe: ltc_Lobe) -> f32 {
  return 0.5 + 0.5 * ltc_horizon_normal_cosine(lobe).z;
}

// Mean direction of the part of the lobe above the horizon, shading space, not normalised: (z + m)
// / 2, the whole vector of that edge sum, carried back by M.
fn ltc_mean_above_horizon(lobe: ltc_Lobe) -> vec3f {
  let m = ltc_horizon_normal_cosine(lobe);
  let z = m.z + 1.0;
  return vec3f(lobe.m22 * m.x - lobe.m02 * z, 0.0, lobe.m00 * z - lobe.m20 * m.x);
}

// Density D(w) per solid angle, 1 over the whole sphere; the lobe may reach below the horizon.
fn ltc_eval_lobe(lobe: ltc_Lobe, wi_shading: vec3f) -> f32 {
  let o = ltc_to_cosine(lobe, wi_shading);
  // Two divisions by |o|^2 instead of one by |o|^4 keep single precision from overflowing.
  let inv_length2 = 1.0 / max(dot(o, o), ltc_k_tiny);
  return max(o.z, 0.0) * inv_length2 * (lobe.det * inv_length2) * ltc_k_inv_pi;
}

// ---- table --------------------------------------------------------------------------------------
//
// A fitted lobe and the amplitudes that belong to it, looked up in a table.
//
// Axes of the native table, node (0,0) at roughness 0 and normal incidence:
//   x = sqrt(alpha) = roughness,   y = sqrt(1 - cos theta).
// Node i of N lies at i/(N-1) of its axis.
//
// The prelude of each target gives a look-up with bilinear interpolation, `at` clamped to [0, 1]:
//   LobeTexel lobe_table_texel(LobeTable, Vec2 at)
//     .coefficients, Vec4  the mirror-frame coefficients A B C D
//     .amplitudes, Vec2    n1 = integral of D V cos, n5 = integral of D V cos (1 - wo.h)^5
//     .second_weight       share of n1 that the second lobe has, 0 in a table of one lobe
//   bool lobe_table_has_second(LobeTable)
//   Vec4 lobe_table_second(LobeTable, Vec2 at)  A B C D of the second lobe, where there is one

// The lobe of a roughness and a view angle, and its amplitudes.
struct ltc_FittedLobe {
  lobe: ltc_Lobe, // normalised: its integral is 1
  n1: f32,        // directional albedo for F = 1
  n5: f32,        // its Schlick-weighted part
}

// Amplitude of the specular lobe: F0 n1 + (F90 - F0) n5, the albedo of the whole lobe.
fn ltc_specular_amplitude(fitted: ltc_FittedLobe, f0: vec3f, f90: vec3f) -> vec3f {
  return f0 * fitted.n1 + (f90 - f0) * fitted.n5;
}

// ---- polynomial ---------------------------------------------------------------------------------
//
// Fitted lobes without a table: a polynomial for each channel.
//
// With u = 2 sqrt(alpha) - 1 and v = 2 sqrt(1 - cos theta) - 1, both in [-1, 1] and the axes of the
// native table (table.glsl), each of A, B, C, D (the mirror packing, lobe.glsl), n1 and s is
//   sum over i + j <= degree of c_ij T_i(u) T_j(v),
// T_n being Chebyshev's polynomials, T_0 = 1, T_1 = x, T_n+1 = 2 x T_n - T_n-1. They stay within
// 1, so the coefficients show what each term is worth, and single precision loses nothing.
//
// Terms are numbered with j slow, from 0, and i fast, from 0 to degree - j. The prelude of each
// target gives
//   int  lobe_polynomial_degree(LobePolynomial)
//   Vec4 lobe_polynomial_mirror(LobePolynomial, term)      c_ij of A B C D
//   Vec2 lobe_polynomial_amplitudes(LobePolynomial, term)  c_ij of n1 s
//   bool lobe_polynomial_has_second(LobePolynomial)
//   Vec4 lobe_polynomial_second(LobePolynomial, term)      c_ij of A B C D of the second lobe
//   Real lobe_polynomial_tangent(LobePolynomial, term)     c_ij of t, below
//
// s = (n5 / n1)^(1/5) stands in for n5: Schlick's (1 - cos)^5 is of degree ten in v, its root of
// degree two. A dielectric's reflection, .04 n1 + .96 n5, hangs on n5 where that is small.
//
// The second lobe's share of n1 is w = (1 + t / sqrt(1 + t^2)) / 2, whatever t is: within 0..1 and
// smooth, t being the tangent of an angle and (1 + its sine) / 2 the share.

// What the terms of the first lobe and of the amplitudes add up to.
struct ltc_LobePolynomialSum {
  mirror: vec4f,     // A B C D
  amplitudes: vec2f, // n1 s
}

// At u and v, see above.
fn ltc_sum_lobe_polynomial(u: f32, v: f32) -> ltc_LobePolynomialSum {
  // Chebyshev's polynomials: un is T_n(u), vn is T_n(v).
  let u2 = 2.0 * u * u - 1.0;
  let u3 = 2.0 * u * u2 - u;
  let u4 = 2.0 * u * u3 - u2;
  let v2 = 2.0 * v * v - 1.0;
  let v3 = 2.0 * v * v2 - v;
  let v4 = 2.0 * v * v3 - v2;
  var sum: ltc_LobePolynomialSum;
  sum.mirror = vec4f(0.6677733, -0.2839807, 0.6423568, 1.097253);
  sum.mirror = sum.mirror + vec4f(0.03543778, -0.3508565, 0.1513957, -0.25154) * u;
  sum.mirror = sum.mirror + vec4f(-0.03947054, -0.01649081, 0.03640917, -0.1250094) * u2;
  sum.mirror = sum.mirror + vec4f(-0.03788963, 0.06603108, -0.1000224, -0.02221692) * u3;
  sum.mirror = sum.mirror + vec4f(-0.01275793, 0.02818707, 0.01359907, 0.008370275) * u4;
  sum.mirror = sum.mirror + vec4f(-0.4390807, -0.2865121, 0.6107541, -0.8337397) * v;
  sum.mirror = sum.mirror + vec4f(0.04532699, -0.3207448, 0.2106151, 0.2377783) * (u * v);
  sum.mirror = sum.mirror + vec4f(-0.04185048, 0.00981988, -0.07275826, 0.07755067) * (u2 * v);
  sum.mirror = sum.mirror + vec4f(-0.04465733, 0.06849372, 0.015033, 0.002158859) * (u3 * v);
  sum.mirror = sum.mirror + vec4f(-0.1106452, 0.009666363, 0.09600891, -0.2100363) * v2;
  sum.mirror = sum.mirror + vec4f(0.01206078, 0.03199834, -0.1940915, 0.05398509) * (u * v2);
  sum.mirror = sum.mirror + vec4f(-0.009938524, 0.0348854, 0.110808, 0.01473734) * (u2 * v2);
  sum.mirror = sum.mirror + vec4f(0.001470969, 0.006227979, -0.03764246, -0.0002229243) * v3;
  sum.mirror = sum.mirror + vec4f(-0.0001330755, 0.007741617, 0.05895613, -0.001076636) * (u * v3);
  sum.mirror = sum.mirror + vec4f(0.002074114, -0.001229983, 0.009980159, 0.00201469) * v4;
  sum.amplitudes = vec2f(0.8045086, 0.343843);
  sum.amplitudes = sum.amplitudes + vec2f(-0.2724648, -0.05521916) * u;
  sum.amplitudes = sum.amplitudes + vec2f(-0.07661926, 0.02603711) * u2;
  sum.amplitudes = sum.amplitudes + vec2f(0.008226918, -0.009146704) * u3;
  sum.amplitudes = sum.amplitudes + vec2f(0.01169145, -0.001905162) * u4;
  sum.amplitudes = sum.amplitudes + vec2f(0.07112518, 0.363317) * v;
  sum.amplitudes = sum.amplitudes + vec2f(0.1375234, -0.135376) * (u * v);
  sum.amplitudes = sum.amplitudes + vec2f(0.07787056, -0.05730146) * (u2 * v);
  sum.amplitudes = sum.amplitudes + vec2f(-0.003416058, 0.03913193) * (u3 * v);
  sum.amplitudes = sum.amplitudes + vec2f(0.04123044, 0.04581396) * v2;
  sum.amplitudes = sum.amplitudes + vec2f(0.07066337, -0.0722363) * (u * v2);
  sum.amplitudes = sum.amplitudes + vec2f(0.02702755, 0.05455893) * (u2 * v2);
  sum.amplitudes = sum.amplitudes + vec2f(0.01748315, 0.01933991) * v3;
  sum.amplitudes = sum.amplitudes + vec2f(0.03402566, 0.01176714) * (u * v3);
  sum.amplitudes = sum.amplitudes + vec2f(0.008494951, -0.01617918) * v4;
  return sum;
}

// The lobe and amplitudes for a microfacet width and the cosine of the view angle, whatever their
// values: n1 >= 0, n5 in [0, n1], a determinant above 0. `width` is what was factored out of
// M^-1: alpha, or 1 for a BRDF whose lobe stays wide.
fn ltc_eval_lobe_polynomial_of_width(alpha: f32, width: f32, cos_theta: f32) -> ltc_FittedLobe {
  let a = min(max(alpha, ltc_k_min_alpha), 1.0);
  let c = min(max(cos_theta, 0.0), 1.0);
  let u = 2.0 * sqrt(a) - 1.0;
  let v = 2.0 * sqrt(1.0 - c) - 1.0;
  let sum = ltc_sum_lobe_polynomial(u, v);
  var fitted: ltc_FittedLobe;
  fitted.lobe = ltc_lobe_from_mirror(sum.mirror, min(max(width, ltc_k_min_alpha), 1.0), c);
  fitted.lobe.det = max(fitted.lobe.det, ltc_k_tiny);
  fitted.n1 = max(sum.amplitudes.x, 0.0);
  let s = min(max(sum.amplitudes.y, 0.0), 1.0);
  let s2 = s * s;
  fitted.n5 = fitted.n1 * (s2 * s2 * s);
  return fitted;
}

// The same of a microfacet BRDF, which reflects no more than it receives: n1 in [0, 1].
fn ltc_eval_lobe_polynomial(alpha: f32, cos_theta: f32) -> ltc_FittedLobe {
  var fitted = ltc_eval_lobe_polynomial_of_width(alpha, alpha, cos_theta);
  let excess = max(fitted.n1, 1.0);
  fitted.n1 = fitted.n1 / excess;
  fitted.n5 = fitted.n5 / excess;
  return fitted;
}

// ---- edge ---------------------------------------------------------------------------------------
//
// Edges of what a lobe is integrated over: clipped to both horizons, closed at an apex.
//
// Sources:
//   Lambert 1760; Baum, Rushmeier, Winget 1989, "Improving Radiosity Solutions Through the Use of
//     Analytically Determined Form-Factors", equation 9 (edge sum);
//   Heitz, Dupuy, Hill, Neubelt 2016, equations 4 to 11 (the integral under M^-1).
//
// For a polygon in cosine space, wholly above its horizon,
//   E = 1/(2 pi) sum over edges of theta_k (a_k x b_k)_z / |a_k x b_k|,
// theta_k being the angle between the edge's end points a_k and b_k as seen from the origin.
//
// Two horizons bound what counts: the surface's, z >= 0 before M^-1, and the cosine's, z_o >= 0
// after it. Together they leave a wedge whose apex is the line through the origin along which both
// planes meet. M^-1 keeps the y axis (see lobe.glsl), so that line is the y axis in either space.
//
// Each edge is clipped to the wedge by itself. Where it enters or leaves, the outline of the
// clipped polygon continues along one of the two planes, and we close it by an arc to the apex: to
// +y or -y, whichever the polygon's plane meets. Arcs on the same plane telescope, whatever the
// order of the edges, so concave outlines, holes and any number of vertices need no clip buffer and
// no search for neighbours: the result is a plain sum over edges. The arc to the apex q = (0, s, 0)
// has (p x q)_z = s p_x.

// 1 / |v|, finite for the origin too: what is added vanishes beside lengths above 1e-8.
fn ltc_inverse_length(v: vec3f) -> f32 {
  return inverseSqrt(v.x * v.x + (v.y * v.y + (v.z * v.z + ltc_k_least_length2)));
}

// v / |v|, or the normal where v has no direction to speak of.
fn ltc_safe_direction(v: vec3f) -> vec3f {
  let length2 = dot(v, v);
  let usable = length2 > ltc_k_tiny;
  return select(vec3f(0.0, 0.0, 1.0), v * inverseSqrt(max(length2, ltc_k_tiny)), usable);
}

// theta / sin(theta) from x = cos(theta), for 0 <= theta <= pi/2; of -x for x < 0.
//
// A rational minimax fit of degree 3/3, relative error 1.0e-9; smooth at 1, so that a cosine that
// rounding took beyond does no harm.
fn ltc_acute_over_sin(x: f32) -> f32 {
  let y = abs(x);
  let p = 1.5707963252152057 +
          y * (1.638642066993385 + y * (0.35581734455759484 + y * 0.004572514079188905));
  let q = 1.0 + y * (1.679811571269012 + y * (0.7959248032398663 + y * 0.09409187287776444));
  return p * (1.0 / q);
}

// theta / sin(theta) for 0 <= theta < pi, from `acute`, that of x = cos(theta), and sin2 =
// sin(theta)^2: beyond a right angle theta = pi - theta', which is exact. It grows without bound
// towards x = -1, where 1 - x^2 has no digits left; so the caller, who knows the vectors, passes
// sin2 as well.
fn ltc_any_over_sin(x: f32, sin2: f32, acute: f32) -> f32 {
  let inv_sin = inverseSqrt(max(sin2, ltc_k_tiny));
  return select(acute, ltc_k_pi * inv_sin - acute, x < 0.0);
}

// theta / sin(theta) of an angle with cosine x and squared sine sin2, 0..pi.
fn ltc_theta_over_sin(x: f32, sin2: f32) -> f32 {
  var weight = ltc_acute_over_sin(x);
  // Uniform shortcut: no lane's angle is beyond a right one.
  if (x < 0.0) {
    weight = ltc_any_over_sin(x, sin2, weight);
  }
  return weight;
}

// Contribution of the arc from a to b = a + d to the vector irradiance, times 2 pi. d is passed by
// itself so that the cross product of a small, far edge does not cancel. Never longer than pi: a
// vector over its length, times an angle.
//
// inv_a, inv_b: one over the lengths of a and b.
fn ltc_edge_term_scaled(a: vec3f, b: vec3f, d: vec3f, inv_a: f32, inv_b: f32) -> vec3f {
  let scale = inv_a * inv_b;
  let c = cross(a, d);
  let x = dot(a, b) * scale;
  var weight = ltc_acute_over_sin(x);
  if (x < 0.0) {
    weight = ltc_any_over_sin(x, dot(c, c) * scale * scale, weight);
  }
  return c * (scale * weight);
}

// edge_term_scaled, which finds the inverse lengths of a and b by itself.
fn ltc_edge_term(a: vec3f, b: vec3f, d: vec3f) -> vec3f {
  return ltc_edge_term_scaled(a, b, d, ltc_inverse_length(a), ltc_inverse_length(b));
}

// Contribution of the arc from p to the apex (0, s, 0), s = 1 or -1.
fn ltc_apex_term(p: vec3f, inv_p: f32, s: f32) -> vec3f {
  let u = p * inv_p;
  let weight = s * ltc_theta_over_sin(s * u.y, u.x * u.x + u.z * u.z);
  return vec3f(-weight * u.z, 0.0, weight * u.x);
}

// Where an edge crosses a plane, in units of the edge, 0..1; a, b: heights of its ends, of which one is
// below and the other not. The bound is for targets whose reciprocal is not the last digit's: a place
// beyond the end would count as cut by the other horizon (clip_edge).
fn ltc_crossing_place(a: f32, b: f32) -> f32 {
  return min(abs(a) * (1.0 / max(abs(a) + abs(b), ltc_k_tiny)), 1.0);
}

// The part of an edge above a plane, in units of the edge; whole where both ends are above.
struct ltc_Span {
  t0: f32, // where it begins, 0..1
  t1: f32, // where it ends, 0..1
}

// a, b: heights of the ends, of which one at least is not below.
fn ltc_span_above(a: f32, b: f32) -> ltc_Span {
  let t = ltc_crossing_place(a, b);
  var span: ltc_Span;
  span.t0 = select(0.0, t, a < 0.0);
  span.t1 = select(1.0, t, b < 0.0);
  return span;
}

// What is left of an edge within the wedge.
struct ltc_ClippedEdge {
  p0: vec3f,     // cosine space
  p1: vec3f,     // its end; p0 is its beginning
  extent: f32,   // in units of the edge
  outside: bool, // whether nothing is left
}

// a_o, b_o: end points in cosine space; a_z, b_z: their heights above the surface's horizon.
fn ltc_clip_edge(a_o: vec3f, b_o: vec3f, a_z: f32, b_z: f32) -> ltc_ClippedEdge {
  let surface = ltc_span_above(a_z, b_z);
  let cosine = ltc_span_above(a_o.z, b_o.z);
  let t0 = max(surface.t0, cosine.t0);
  let t1 = min(surface.t1, cosine.t1);
  var edge: ltc_ClippedEdge;
  // t0 == t1 is not outside: an edge that leaves from, or ends at, a point on a horizon has no
  // length left but still opens or closes the outline there.
  edge.outside = (a_z < 0.0 && b_z < 0.0) || (a_o.z < 0.0 && b_o.z < 0.0) || t0 > t1;
  let d = b_o - a_o;
  edge.p0 = a_o + d * t0;
  edge.p1 = a_o + d * t1;
  edge.extent = t1 - t0;
  // A point cut at the cosine's horizon lies on it: seen near the apex, what rounding leaves of its
  // height would tilt the arc that closes.
  edge.p0.z = select(max(edge.p0.z, 0.0), 0.0, cosine.t0 > surface.t0);
  edge.p1.z = select(max(edge.p1.z, 0.0), 0.0, cosine.t1 < surface.t1);
  return edge;
}

// Angle of a unit vector (c, s) from (1, 0), -pi..pi.
fn ltc_angle_of_unit(c: f32, s: f32) -> f32 {
  let acute = s * ltc_acute_over_sin(c);
  let half_turn = select(ltc_k_pi, -ltc_k_pi, s < 0.0);
  return select(acute, half_turn - acute, c < 0.0);
}

// The same closed at both ends, cut or not: for edges that meet arcs (cone.glsl), whose own
// closing cancels it. Whether the common point is inside, both find by themselves, and rounding
// may make them disagree; this way that does not matter.
fn ltc_closed_edge_term(a_o: vec3f, b_o: vec3f, a_z: f32, b_z: f32, s: f32) -> vec3f {
  let edge = ltc_clip_edge(a_o, b_o, a_z, b_z);
  let inv_p0 = ltc_inverse_length(edge.p0);
  let inv_p1 = ltc_inverse_length(edge.p1);
  let sum = ltc_edge_term_scaled(edge.p0, edge.p1, (b_o - a_o) * edge.extent, inv_p0, inv_p1) +
            ltc_apex_term(edge.p1, inv_p1, s) - ltc_apex_term(edge.p0, inv_p0, s);
  return select(sum, vec3f(0.0, 0.0, 0.0), edge.outside);
}

// ---- light --------------------------------------------------------------------------------------
//
// What lights of all shapes share: their integral, a point of one, and the planes of flat ones.
//
// A shape X has a file of its own, and there, named alike:
//   integrate_X     its integral as a point sees it, for Lambert and for a lobe
//   X_heights       its extent over a plane through the point
//   surface_X_integral   the integral as a surface sees it: none without a side of a flat light, and
//                   without what the surface's triangle hides
//   shade_X_parts, shade_X   the light that the surface reflects of it, for radiance 1 and without shadow
//   X_seen          what sampling wants to know of it and of the point, once for all samples
//   sample_X, intersect_X, pdf_X   a point of it from random numbers, or where a ray meets it; its density.
//                   No ray meets a line

// What shading wants to know of a light of radiance 1, whatever its shape, without shadow.
//
// Both integrals are z components of vector irradiances, in shading space and in cosine space. The
// vectors' directions are the mean directions of the part of the light that counts; of the
// specular one, carried back by M, shading takes the Fresnel reflectance.
struct ltc_LightIntegral {
  diffuse: f32,              // integral of cos/pi over the light, 0..1
  specular: f32,             // integral of the lobe's density, both horizons respected, 0..1
  diffuse_direction: vec3f,  // shading space, unit
  specular_direction: vec3f, // shading space, unit
  second: f32,               // integral of a second lobe's density, see with_second_lobe; else 0
  concentration: f32,        // cosine space, 0..1: 1 for a light so small that it lies in one direction
}

// How closely a light keeps to its mean direction in cosine space, 0..1: R^4 (1 - |Phi|).
//
// R is the length of the mean of the unit vectors to the points that make up the light's outline: its
// cosine for a cone, 1 for a point, near 0 for a wall on all sides; outline2 is its square. Phi is the
// vector irradiance, which is as long as 1 for a light that is all around.
fn ltc_light_concentration(outline2: f32, vector_irradiance: f32) -> f32 {
  let rest = max(1.0 - vector_irradiance, 0.0);
  return min(outline2 * outline2, 1.0) * rest;
}

// From the vector irradiances times 2 pi; outline2: see light_concentration.
fn ltc_light_integral(diffuse: vec3f, specular: vec3f, lobe: ltc_Lobe,
                      outline2: f32) -> ltc_LightIntegral {
  var result: ltc_LightIntegral;
  result.diffuse = min(max(diffuse.z * ltc_k_half_inv_pi, 0.0), 1.0);
  result.specular = min(max(specular.z * ltc_k_half_inv_pi, 0.0), 1.0);
  result.second = 0.0;
  result.diffuse_direction = ltc_safe_direction(diffuse);
  result.specular_direction = ltc_safe_direction(ltc_from_cosine(lobe, specular));
  result.concentration = ltc_light_concentration(outline2,
                                                 sqrt(dot(specular, specular)) * ltc_k_half_inv_pi);
  return result;
}

// Heights of a light's lowest and highest point over a plane through the shaded point, metres.
struct ltc_Heights {
  low: f32,  // of the lowest point, metres
  high: f32, // of the highest one, metres
}

// Both 0, where nothing is asked of them.
fn ltc_no_heights() -> ltc_Heights {
  var heights: ltc_Heights;
  heights.low = 0.0;
  heights.high = 0.0;
  return heights;
}

// Whether a point lies in a light's plane as far as can be told: h, its distance, is no more than
// that to which the point is known, whose square is `error2`, or than what rounding makes of 0. Such a
// point has no side, and gets no light. `to_origin` leads from the point to any point of the plane.
fn ltc_lies_in_plane(h: f32, to_origin: vec3f, error2: f32) -> bool {
  return h * h <=
         max(error2, ltc_k_plane_rounding * ltc_k_plane_rounding * dot(to_origin, to_origin));
}

// ---- surface ------------------------------------------------------------------------------------
//
// A shaded point: the reflectance equation for the lights of this project.
//
//   L_o = integral of (k_d c/pi + f_s) L_i cos_i,   f_s = D V F (GGX, Smith, Schlick).
//
// The diffuse part is what the specular one leaves, k_d = (1 - metallic)(1 - E_spec(wo)), with
// E_spec the specular albedo that comes with the lobe: it does not depend on wi, so Lambert stays a
// cosine and its polygon integral exact.
//
// The lobe integrates to 1 over the sphere and may reach below the surface, where no light comes
// from. f_s cos_i is therefore n1 F times the lobe divided by its share above the horizon: what
// light from all sides reflects is n1 F, the albedo, and nothing leaks. Of two lobes each has its own
// share above the horizon, and a weight of the whole.

// A point of a surface, ready to be shaded by any light.
struct ltc_Surface {
  position: vec3f,        // world space
  // Square of the metres within which it is known; make_surface assumes single precision.
  position_error2: f32,
  frame: ltc_Frame,       // shading space
  wo: vec3f,              // shading space: (sin theta, 0, cos theta)
  alpha: f32,             // microfacet width, roughness^2
  diffuse: vec3f,         // k_d c, albedo of the Lambertian part
  f0: vec3f,              // specular reflectance at normal incidence
  f90: vec3f,             // and at grazing incidence
  fitted: ltc_FittedLobe, // the lobe for this roughness and view
  specular: vec3f,        // F0 n1 + (F90 - F0) n5, the specular albedo
  axis_weight: f32,       // n5/n1 less Schlick's weight in the lobe's mean direction
  inv_share: f32,         // weight of the lobe, 1 if it is the only one, over its share_above_horizon
  second: ltc_Lobe,       // the second lobe
  second_inv_share: f32,  // its weight over its share above the horizon
  // Of the triangle, unit, world space, on the viewer's side; make_surface assumes the shading normal.
  geometric: vec3f,
  // Whether the two differ in any lane: then what lies behind the triangle's plane is hidden by it.
  tilted: bool,
  // Whether lights take the BRDF's own value in their mean direction: see blended_ratio.
  corrected: bool,
  max_ratio: f32,         // most that this may multiply a light by
}

// Schlick's weight at the microfacet that reflects wo, which has no y, into wi.
fn ltc_fresnel_weight(wo: vec3f, wi: vec3f) -> f32 {
  return ltc_schlick_weight_between(wo.x * wi.x + wo.z * wi.z);
}

// Prepares a point for shading. `fitted` is the lobe of alpha_from_roughness(roughness) and
// dot(normal, wo_world), from a table or a polynomial. `normal` and `wo_world` are unit; `albedo`
// is (1 - metallic) c.
fn ltc_make_surface(fitted: ltc_FittedLobe, position: vec3f, normal: vec3f, wo_world: vec3f,
                    albedo: vec3f, f0: vec3f, f90: vec3f, roughness: f32) -> ltc_Surface {
  var s: ltc_Surface;
  s.position = position;
  s.position_error2 = ltc_k_position_rounding * ltc_k_position_rounding * dot(position, position);
  s.frame = ltc_shading_frame(normal, wo_world);
  s.wo = vec3f(dot(s.frame.t1, wo_world), 0.0, dot(normal, wo_world));
  s.alpha = ltc_alpha_from_roughness(roughness);
  s.f0 = f0;
  s.f90 = f90;
  s.fitted = fitted;
  s.specular = ltc_specular_amplitude(fitted, f0, f90);
  s.inv_share = 1.0 / max(ltc_share_above_horizon(fitted.lobe), ltc_k_min_share);
  let mean = ltc_safe_direction(ltc_mean_above_horizon(fitted.lobe));
  s.axis_weight = fitted.n5 * (1.0 / max(fitted.n1, ltc_k_tiny)) - ltc_fresnel_weight(s.wo, mean);
  let taken = max(max(s.specular.x, s.specular.y), s.specular.z);
  s.diffuse = albedo * max(1.0 - taken, 0.0);
  s.geometric = normal;
  s.second = fitted.lobe;
  s.second_inv_share = 0.0;
  s.tilted = false;
  s.corrected = false;
  s.max_ratio = 1.0;
  return s;
}

// Density of all the lobes above the horizon, 1 over the hemisphere.
fn ltc_eval_lobes(s: ltc_Surface, wi: vec3f) -> f32 {
  let density = s.inv_share * ltc_eval_lobe(s.fitted.lobe, wi);
  return density;
}

// The share that a light fills of all that the lobes have above the horizon, 0..1.
fn ltc_filled_share(s: ltc_Surface, integral: ltc_LightIntegral) -> f32 {
  let share = integral.specular * s.inv_share;
  return min(share, 1.0);
}

// Asks for the ratio at the mean direction: see blended_ratio.
fn ltc_correct_at_mean(s_in: ltc_Surface) -> ltc_Surface {
  var s = s_in;
  s.corrected = true;
  s.max_ratio = ltc_k_max_ratio;
  return s;
}

// The same surface where no lane is GGX itself: one that asks its lobes alone.
fn ltc_without_exact(s: ltc_Surface) -> ltc_Surface { return s; }

// Makes known the normal of the triangle that the point is on: unit, world space, on the viewer's side.
fn ltc_set_geometric_normal(s_in: ltc_Surface, geometric: vec3f) -> ltc_Surface {
  var s = s_in;
  let d = geometric - s.frame.n;
  s.geometric = geometric;
  s.tilted = dot(d, d) > ltc_k_normal_rounding * ltc_k_normal_rounding;
  return s;
}

// Whether the point has a side of a flat light, whose plane holds `origin`: not on the emitter itself
// or on a wall flush with it, as far as its position is known. Without a side there is no light.
fn ltc_has_side(s: ltc_Surface, origin: vec3f, normal: vec3f) -> bool {
  let to_origin = origin - s.position;
  return !ltc_lies_in_plane(dot(to_origin, normal), to_origin, s.position_error2);
}

// An integral without what lanes have without a side of a flat light.
fn ltc_unless_in_plane(s: ltc_Surface, origin: vec3f, normal: vec3f,
                       integral_in: ltc_LightIntegral) -> ltc_LightIntegral {
  var integral = integral_in;
  let sided = ltc_has_side(s, origin, normal);
  integral.diffuse = select(0.0, integral.diffuse, sided);
  integral.specular = select(0.0, integral.specular, sided);
  integral.second = select(0.0, integral.second, sided);
  return integral;
}

// An integral without what lanes have that see nothing of the light in front of the triangle's plane.
fn ltc_unless_hidden(s: ltc_Surface, heights: ltc_Heights,
                     integral_in: ltc_LightIntegral) -> ltc_LightIntegral {
  var integral = integral_in;
  let seen = heights.high > 0.0 && heights.high * heights.high > s.position_error2;
  integral.diffuse = select(0.0, integral.diffuse, seen);
  integral.specular = select(0.0, integral.specular, seen);
  integral.second = select(0.0, integral.second, seen);
  return integral;
}

// A part of the hemisphere reflects no more than the whole, s.specular.
fn ltc_within_albedo(s: ltc_Surface, part: vec3f) -> vec3f {
  return vec3f(min(part.x, s.specular.x), min(part.y, s.specular.y), min(part.z, s.specular.z));
}

// The normal of the triangle in shading space.
fn ltc_front_shading(s: ltc_Surface) -> vec3f { return ltc_to_shading(s.frame, s.geometric); }

// The share `filled` of n1 with this weight of F90 over F0, within the albedo.
fn ltc_reflectance_of_weight(s: ltc_Surface, weight: f32, filled: f32) -> vec3f {
  let fresnel = s.f0 + (s.f90 - s.f0) * min(max(weight, 0.0), 1.0);
  return ltc_within_albedo(s, fresnel * (s.fitted.n1 * filled));
}

// What a light that fills this share of the lobe has of Schlick's weight beyond that in its mean
// direction: all of the whole lobe's, axis_weight, for one that fills it, and by the square of the share
// less for others, since it comes from the lobe's rim, which a light around its middle does not reach.
fn ltc_weight_of_rim(s: ltc_Surface, share: f32) -> f32 { return share * share * s.axis_weight; }

// Schlick's weight in the light of a share of what the lobe has above the horizon, 0..1, which comes from around
// wi.
//
// F0 n1 + (F90 - F0) n5 is the albedo of the whole lobe. Spread evenly over it, it gives light far
// from the mirror direction the Fresnel reflectance of the mirror direction: twice too much and
// more on a dielectric seen at an angle. So Schlick's weight is taken at wi instead, plus weight_of_rim:
// exact for a small light, w(wi), and for one that fills the hemisphere, n5/n1.
fn ltc_part_weight(s: ltc_Surface, wi: vec3f, share: f32) -> f32 {
  return ltc_fresnel_weight(s.wo, wi) + ltc_weight_of_rim(s, share);
}

// What the specular part of a light is multiplied by so that a small one is exact: near its mean
// direction wi the BRDF is larger than the lobe by
//   r = rho / (n1 D),  rho = D V cos of GGX, D the lobe's density above the horizon.
// A light that fills the whole lobe has n1 whatever its shape, so 1 is right for that. Between the two,
// with w the light's concentration times what it leaves of the lobe, their harmonic mean
//   1 / (1 - w + w / r):
// at most 1 / (1 - w), so that a quotient of two small numbers does no harm where a light is large, and
// nearly r where the lobe glows and the BRDF does not. It is not additive: see docs/method.md.
fn ltc_blended_ratio(s: ltc_Surface, wi: vec3f, w: f32) -> f32 {
  let lobe = s.fitted.n1 * ltc_eval_lobes(s, wi);
  let rho = min(ltc_eval_ggx_scale(s.wo, wi, s.alpha), s.max_ratio * lobe);
  // 1 where both vanish.
  return (rho + ltc_k_tiny) * (1.0 / (max(rho + w * (lobe - rho), 0.0) + ltc_k_tiny));
}

// The weight of the BRDF in that: of a light that fills `share` of the lobe.
fn ltc_ratio_weight(integral: ltc_LightIntegral, share: f32) -> f32 {
  return integral.concentration * max(1.0 - share, 0.0);
}

// Reflected light of a light of radiance 1.
struct ltc_ShadedLight {
  diffuse: vec3f,  // by the Lambertian part
  specular: vec3f, // by the lobe
}

// Their sum.
fn ltc_both_parts(shaded: ltc_ShadedLight) -> vec3f { return shaded.diffuse + shaded.specular; }

// Light of radiance 1 whose specular part has this weight of F90 over F0, and the share `filled` of n1; where the
// integral is that of GGX itself, its own.
fn ltc_shade_filled(s: ltc_Surface, integral: ltc_LightIntegral, weight: f32,
                    filled: f32) -> ltc_ShadedLight {
  var shaded: ltc_ShadedLight;
  shaded.diffuse = s.diffuse * integral.diffuse;
  shaded.specular = ltc_reflectance_of_weight(s, weight, filled);
  return shaded;
}

// Light of radiance 1 in closed form, without shadow: its diffuse and its specular part.
fn ltc_shade_integral(s: ltc_Surface, integral: ltc_LightIntegral) -> ltc_ShadedLight {
  let share = ltc_filled_share(s, integral);
  var filled = share;
  if (s.corrected) {
    let w = ltc_ratio_weight(integral, share);
    filled = min(share * ltc_blended_ratio(s, integral.specular_direction, w), 1.0);
  }
  return ltc_shade_filled(s, integral, ltc_part_weight(s, integral.specular_direction, share),
                          filled);
}

// ---- cone ---------------------------------------------------------------------------------------
//
// Elliptic cones: what ellipses, disks and spheres fill of the directions around a point, and what a
// linear map makes of that, which is an elliptic cone again. Their vector irradiance, exact and
// clipped to both horizons.
//
// Sources: the cone's axes as eigenvectors, and the whole cone's irradiance, follow Heitz and Hill
// 2017, "Real-Time Line- and Disk-Light Shading with Linearly Transformed Cosines". They clip to the
// horizon by the form factor of a sphere of the same irradiance; here the arcs that are left above
// the horizons are integrated themselves, which is as exact as the edges of a polygon:
//
// In the frame of its axes the cone's outline is the curve of unit vectors
//   v(t) = (k1 cos t, k2 sin t, N),   N^2 = c1^2 cos^2 t + c2^2 sin^2 t,
// k and c being the sines and cosines of its half angles along the first two axes (k1 >= k2). With
// m^2 = k1^2 - k2^2, the integral of v x dv, which is the vector irradiance times 2 pi, is
//   ( -k2 c1^2 atanh(m sin t / N) / m,   k1 c2^2 atan(m cos t / N) / m,   k1 k2 t ).
// The whole circle leaves 2 pi k1 k2 along the axis. (Differentiate; v x dv / dt = (-k2 c1^2 cos t,
// -k1 c2^2 sin t, ...)/N, and N dN = m^2 sin t cos t dt.)
//
// A plane through the origin cuts that curve in at most two points, which bound one interval of t.
// What lies above both horizons is therefore the intersection of two intervals of a circle, at most
// two pieces, and each is closed by arcs to the wedge's apex as the edges of edge.glsl are.

// An elliptic cone of directions around its apex, the point.
struct ltc_Cone {
  e1: vec3f, // orthonormal, right-handed; e3 the axis
  e2: vec3f, // the second axis, of the smaller half angle
  e3: vec3f, // the axis of the cone
  k1: f32,   // sines of the half angles, k1 >= k2
  k2: f32,   // of the one along e2
  c1: f32,   // their cosines, c1 <= c2
  c2: f32,   // of the one along e2
}

// A symmetric matrix in a basis of its own, on the way to being diagonal.
struct ltc_Diagonalisation {
  s11: f32,  // its elements in that basis, by row and column
  s22: f32,  // see s11
  s33: f32,  // see s11
  s12: f32,  // see s11
  s13: f32,  // see s11
  s23: f32,  // see s11
  e1: vec3f, // the basis, orthonormal
  e2: vec3f, // see e1
  e3: vec3f, // see e1
}

// The tangent of the smaller rotation that clears the element `pq` between `pp` and `qq`.
fn ltc_jacobi_tangent(pp: f32, qq: f32, pq: f32) -> f32 {
  let d = qq - pp;
  let root = sqrt(d * d + 4.0 * pq * pq);
  let t = 2.0 * pq / (d + select(root, -root, d < 0.0) + ltc_k_tiny);
  return min(max(t, -1.0), 1.0);
}

// One sweep of Jacobi's method.
fn ltc_jacobi_sweep(j_in: ltc_Diagonalisation) -> ltc_Diagonalisation {
  var j = j_in;
  var t = ltc_jacobi_tangent(j.s11, j.s33, j.s13);
  var c = inverseSqrt(1.0 + t * t);
  var s = t * c;
  j.s11 = j.s11 - t * j.s13;
  j.s33 = j.s33 + t * j.s13;
  j.s13 = 0.0;
  var s12 = c * j.s12 - s * j.s23;
  j.s23 = s * j.s12 + c * j.s23;
  j.s12 = s12;
  var e1 = j.e1 * c - j.e3 * s;
  j.e3 = j.e1 * s + j.e3 * c;
  j.e1 = e1;

  t = ltc_jacobi_tangent(j.s22, j.s33, j.s23);
  c = inverseSqrt(1.0 + t * t);
  s = t * c;
  j.s22 = j.s22 - t * j.s23;
  j.s33 = j.s33 + t * j.s23;
  j.s23 = 0.0;
  s12 = c * j.s12 - s * j.s13;
  j.s13 = s * j.s12 + c * j.s13;
  j.s12 = s12;
  let e2 = j.e2 * c - j.e3 * s;
  j.e3 = j.e2 * s + j.e3 * c;
  j.e2 = e2;

  t = ltc_jacobi_tangent(j.s11, j.s22, j.s12);
  c = inverseSqrt(1.0 + t * t);
  s = t * c;
  j.s11 = j.s11 - t * j.s12;
  j.s22 = j.s22 + t * j.s12;
  j.s12 = 0.0;
  let s13 = c * j.s13 - s * j.s23;
  j.s23 = s * j.s13 + c * j.s23;
  j.s13 = s13;
  e1 = j.e1 * c - j.e2 * s;
  j.e2 = j.e1 * s + j.e2 * c;
  j.e1 = e1;
  return j;
}

// The cone of directions to the ellipse center + a cos t + b sin t, as seen from the origin. a and
// b need not be perpendicular. An ellipse seen edge-on gives a flat cone, one around the origin a
// half-space.
//
// With K = [a b center], the directions v = K w, w.x^2 + w.y^2 <= w.z^2, are v' Q v <= 0 with
// Q = K^-T diag(1, 1, -1) K^-1. Its inverse, S = a a' + b b' - center center', has the same
// eigenvectors and needs no division. One of its eigenvalues, -q, is negative and belongs to the
// axis; the others are s_i = q tan^2 of the half angles. The matrix is set up in a basis whose third
// axis is close to the cone's: then the small elements of a narrow cone are not lost beside the
// large one, and three sweeps of Jacobi's method find all to the last digits.
fn ltc_make_cone(center: vec3f, a: vec3f, b: vec3f) -> ltc_Cone {
  let size2 = dot(center, center) + dot(a, a) + dot(b, b);
  let scale = inverseSqrt(max(size2, ltc_k_tiny));
  let c = center * scale;
  let p = a * scale;
  let q = b * scale;

  // Start from the direction to the centre, or from the ellipse's normal where that is closer to
  // the axis: where S is more negative along it.
  var n = cross(p, q);
  n = n * inverseSqrt(max(dot(n, n), ltc_k_tiny));
  let height = dot(n, c);
  let z_normal = n * select(1.0, -1.0, height < 0.0);
  let c_length2 = dot(c, c);
  let inv_c = inverseSqrt(max(c_length2, ltc_k_tiny));
  let z_center = c * inv_c;
  let along_p = dot(p, z_center);
  let along_q = dot(q, z_center);
  let from_center = along_p * along_p + along_q * along_q - c_length2 < -(height * height);

  var j: ltc_Diagonalisation;
  j.e3 = select(z_normal, z_center, from_center);
  j.e1 = ltc_any_perpendicular(j.e3);
  j.e2 = cross(j.e3, j.e1);
  let pj = vec3f(dot(p, j.e1), dot(p, j.e2), dot(p, j.e3));
  let qj = vec3f(dot(q, j.e1), dot(q, j.e2), dot(q, j.e3));
  let zero = 0.0;
  let cj = vec3f(select(dot(c, j.e1), zero, from_center), select(dot(c, j.e2), zero, from_center),
                 dot(c, j.e3));
  j.s11 = pj.x * pj.x + qj.x * qj.x - cj.x * cj.x;
  j.s22 = pj.y * pj.y + qj.y * qj.y - cj.y * cj.y;
  j.s33 = pj.z * pj.z + qj.z * qj.z - cj.z * cj.z;
  j.s12 = pj.x * pj.y + qj.x * qj.y - cj.x * cj.y;
  j.s13 = pj.x * pj.z + qj.x * qj.z - cj.x * cj.z;
  j.s23 = pj.y * pj.z + qj.y * qj.z - cj.y * cj.z;
  for (var i = 0; i < 3; i++) {
    j = ltc_jacobi_sweep(j);
  }

  // The negative eigenvalue may have come out elsewhere: bring it to the third place.
  let first = j.s11 < j.s33 && j.s11 <= j.s22;
  let second = j.s22 < j.s33 && j.s22 < j.s11;
  let s33 = min(min(j.s11, j.s22), j.s33);
  let e3 = select(select(j.e3, j.e2, second), j.e1, first);
  j.s11 = select(j.s11, j.s33, first);
  j.e1 = select(j.e1, j.e3, first);
  j.s22 = select(j.s22, j.s33, second);
  j.e2 = select(j.e2, j.e3, second);
  j.s33 = s33;
  j.e3 = e3;

  var cone: ltc_Cone;
  let away = select(1.0, -1.0, dot(j.e3, c) < 0.0);
  cone.e3 = j.e3 * away;
  let swapped = j.s22 > j.s11;
  cone.e1 = select(j.e1, j.e2, swapped);
  cone.e2 = cross(cone.e3, cone.e1);
  let s1 = max(max(j.s11, j.s22), 0.0);
  var s2 = max(min(j.s11, j.s22), 0.0);
  var negative = max(-j.s33, 1.0e-14);
  // The product of the eigenvalues is -det(K)^2, which keeps its digits where the smallest of them,
  // a difference of large numbers, has none left: in the flat cones of narrow lobes.
  let det = abs(dot(cross(p, q), c));
  let det_over_s1 = det / max(s1, ltc_k_tiny);
  let small_s2 = min(det_over_s1 * (det / negative), s1);
  s2 = select(s2, small_s2, s2 < 0.01 * min(s1, negative));
  let small_negative = max(det_over_s1 * (det / max(s2, ltc_k_tiny)), 1.0e-14);
  negative = select(negative, small_negative, negative < 0.01 * s2);
  let inv1 = inverseSqrt(s1 + negative);
  let inv2 = inverseSqrt(s2 + negative);
  let root = sqrt(negative);
  cone.k1 = sqrt(s1) * inv1;
  cone.k2 = sqrt(s2) * inv2;
  cone.c1 = root * inv1;
  cone.c2 = root * inv2;
  return cone;
}

// More than the extent of an arc that a plane cuts, 9e-5 below 2 pi: a full turn, whose start is its
// lowest point, and cuts nothing.
const ltc_k_full_turn: f32 = 6.2831;

// An interval of the outline's parameter: counter-clockwise from `start`.
struct ltc_Arc {
  start: f32,  // -pi..pi
  extent: f32, // 0..2 pi
}

// The part of the outline above the plane with unit normal `up`.
//
// In terms of the circle that the outline is a linear image of, the plane is p cos + q sin + r = 0.
fn ltc_arc_above(cone: ltc_Cone, up: vec3f) -> ltc_Arc {
  let ratio = cone.c1 / cone.c2;
  var p = dot(up, cone.e1) * cone.k1;
  var q = dot(up, cone.e2) * cone.k2 * ratio;
  var r = dot(up, cone.e3) * cone.c1;
  // Of size 1, so that the products below neither vanish nor overflow.
  let scale = 1.0 / max(max(max(abs(p), abs(q)), abs(r)), ltc_k_tiny);
  p = p * scale;
  q = q * scale;
  r = r * scale;
  let radius2 = p * p + q * q;
  let w2 = radius2 - r * r;
  let w = sqrt(max(w2, 0.0));
  // The two roots, up to a positive factor, turned from the circle's parameter into the outline's.
  let start_x = w * q - r * p;
  let start_y = ratio * (-(w * p) - r * q);
  let end_x = -(w * q) - r * p;
  let end_y = ratio * (w * p - r * q);
  var arc: ltc_Arc;
  arc.start = ltc_angle_of(start_x, start_y);
  let length = ltc_angle_of(start_x * end_x + start_y * end_y, start_x * end_y - start_y * end_x);
  // Less than half of the outline is above exactly when the axis is not; rounding must not turn a
  // little into nearly all.
  let half_turn = 0.5 * ltc_k_pi;
  let turn = 2.0 * ltc_k_pi;
  let less = select(max(length, 0.0), length + turn, length < -half_turn);
  let more = select(length, length + turn, length < half_turn);
  arc.extent = min(select(more, less, r < 0.0), turn);
  let uncut = w2 <= 0.0;
  arc.extent = select(arc.extent, select(turn, 0.0, r < 0.0), uncut);
  return arc;
}

// N of the point with cosine c and sine s of its parameter.
fn ltc_cone_height(cone: ltc_Cone, c: f32, s: f32) -> f32 {
  return sqrt(max(cone.c1 * cone.c1 * c * c + cone.c2 * cone.c2 * s * s, ltc_k_tiny));
}

// The unit vector v(t), in the space of the cone's axes.
fn ltc_cone_direction(cone: ltc_Cone, t: f32) -> vec3f {
  let c = cos(t);
  let s = sin(t);
  return cone.e1 * (cone.k1 * c) + cone.e2 * (cone.k2 * s) + cone.e3 * ltc_cone_height(cone, c, s);
}

// The antiderivative of v x dv at the parameter t, in the frame of the cone, and v there.
struct ltc_ConePoint {
  sum: vec3f,       // the antiderivative
  direction: vec3f, // v, unit
}

// Both at the parameter t, radians.
fn ltc_cone_point(cone: ltc_Cone, t: f32) -> ltc_ConePoint {
  let c = cos(t);
  let s = sin(t);
  let m2 = max((cone.k1 - cone.k2) * (cone.k1 + cone.k2), 0.0);
  let m = sqrt(m2);
  let n = ltc_cone_height(cone, c, s);
  let inv_n = 1.0 / n;
  // atanh(z) / m = s / n times atanh(z) / z; the logarithm's argument is (1 + z) / sqrt(1 - z^2).
  let ms = m * abs(s);
  let z2 = min(ms * ms * inv_n * inv_n, 1.0);
  let series = 1.0 + z2 * (1.0 / 3.0 + z2 * (1.0 / 5.0 + z2 * (1.0 / 7.0)));
  let logarithm = log((n + ms) / max(cone.c1, 1.0e-12));
  let atanh_over_z = select(logarithm * n / max(ms, ltc_k_tiny), series, z2 < 0.01);
  var point: ltc_ConePoint;
  point.sum = vec3f(-(cone.k2 * cone.c1 * cone.c1 * s * inv_n * atanh_over_z),
                    cone.k1 * cone.c2 * cone.c2 * c * inv_n * ltc_atan_over(m * c * inv_n),
                    cone.k1 * cone.k2 * t);
  point.direction = cone.e1 * (cone.k1 * c) + cone.e2 * (cone.k2 * s) + cone.e3 * n;
  return point;
}

// The same angle within a turn: 0 to 2 pi, from -2 pi to 4 pi.
fn ltc_wrapped_turn(angle: f32) -> f32 {
  let turn = 2.0 * ltc_k_pi;
  let a = select(angle, angle + turn, angle < 0.0);
  return select(a - turn, a, a < turn);
}

// What the arcs `part`, `surface` and `cosine` of an outline have in common, the latter two being what is above each
// horizon, closed towards the apex (0, s, 0) at both ends of every piece: 2 pi times its share of the vector
// irradiance.
fn ltc_common_arc_term(cone: ltc_Cone, part: ltc_Arc, surface: ltc_Arc, cosine: ltc_Arc,
                       s: f32) -> vec3f {
  let turn = 2.0 * ltc_k_pi;
  let x1 = select(ltc_wrapped_turn(surface.start - part.start), 0.0,
                  surface.extent > ltc_k_full_turn);
  let x2 = select(ltc_wrapped_turn(cosine.start - part.start), 0.0, cosine.extent > ltc_k_full_turn);
  var sum = vec3f(0.0, 0.0, 0.0);
  var ends = sum;
  // Intervals on a circle meet themselves again after a turn.
  for (var i = 0; i < 2; i++) {
    let a = x1 - turn * f32(i);
    for (var k = 0; k < 2; k++) {
      let b = x2 - turn * f32(k);
      let low = max(max(a, b), 0.0);
      let high = min(min(a + surface.extent, b + cosine.extent), part.extent);
      let some = high > low;
      if (some) {
        // Its end, then its beginning.
        var t = high;
        var sign = 1.0;
        for (var end = 0; end < 2; end++) {
          let point = ltc_cone_point(cone, part.start + t);
          let counts = sign;
          sum = sum + point.sum * counts;
          ends = ends +
                 ltc_apex_term(point.direction, ltc_inverse_length(point.direction), s) * counts;
          t = low;
          sign = -1.0;
        }
      }
    }
  }
  return cone.e1 * sum.x + cone.e2 * sum.y + cone.e3 * sum.z + ends;
}

// The outline's arc `part`, clipped to the wedge between the horizons with unit normals `up` and z, and closed as
// above. Ends that other edges continue from cancel with those.
fn ltc_clipped_arc_term(cone: ltc_Cone, part: ltc_Arc, up: vec3f, s: f32) -> vec3f {
  return ltc_common_arc_term(cone, part, ltc_arc_above(cone, up),
                             ltc_arc_above(cone, vec3f(0.0, 0.0, 1.0)), s);
}

// Whether a cone lies wholly above the planes with unit normals `up` and z: the axis' height over
// each against the reach sideways.
fn ltc_cone_is_above(cone: ltc_Cone, up: vec3f) -> bool {
  let height = dot(up, cone.e3) * cone.c1 * cone.c2;
  let p = dot(up, cone.e1) * cone.k1 * cone.c2;
  let q = dot(up, cone.e2) * cone.k2 * cone.c1;
  let height_o = cone.e3.z * cone.c1 * cone.c2;
  let po = cone.e1.z * cone.k1 * cone.c2;
  let qo = cone.e2.z * cone.k2 * cone.c1;
  return height > 0.0 && height * height >= p * p + q * q && height_o > 0.0 &&
         height_o * height_o >= po * po + qo * qo;
}

// Square of the mean of the unit vectors to the ends of a cone's axes; see light_concentration.
fn ltc_cone_outline2(cone: ltc_Cone) -> f32 {
  let mean = 0.5 * (cone.c1 + cone.c2);
  return mean * mean;
}

// Vector irradiance times 2 pi of a whole cone, clipped to the wedge between the horizons with unit
// normals `up` and z.
fn ltc_clipped_cone(cone: ltc_Cone, up: vec3f) -> vec3f {
  let whole = ltc_cone_is_above(cone, up);
  let all = cone.e3 * (2.0 * ltc_k_pi * cone.k1 * cone.k2);
  // Uniform shortcut: no lane needs to clip.
  if (whole) {
    return all;
  }
  // The outline is taken up where a horizon cuts it.
  let surface = ltc_arc_above(cone, up);
  let cosine = ltc_arc_above(cone, vec3f(0.0, 0.0, 1.0));
  var part: ltc_Arc;
  part.start = select(surface.start, cosine.start, surface.extent > ltc_k_full_turn);
  part.extent = 2.0 * ltc_k_pi;
  let s = select(1.0, -1.0, cone.e3.y < 0.0);
  return select(ltc_common_arc_term(cone, part, surface, cosine, s), all, whole);
}

// Parameter of the outline at a direction on it, -pi..pi.
//
// Of a nearly flat cone the second coordinate is mostly rounding: there its sign alone is taken,
// and its size from the first.
fn ltc_outline_parameter(cone: ltc_Cone, direction: vec3f) -> f32 {
  let inv_length = inverseSqrt(max(dot(direction, direction), ltc_k_tiny));
  let x = dot(direction, cone.e1) * inv_length;
  let y = dot(direction, cone.e2) * inv_length;
  let x1 = min(max(x / max(cone.k1, 1.0e-12), -1.0), 1.0);
  let y1 = sqrt(1.0 - x1 * x1);
  let flat_cone = cone.k2 < 0.02 * cone.k1;
  return ltc_angle_of(select(x * cone.k2, x1, flat_cone),
                      select(y * cone.k1, select(y1, -y1, y < 0.0), flat_cone));
}

// Share of the outline's arc `part` in 2 pi times the vector irradiance, without horizons.
fn ltc_arc_term(cone: ltc_Cone, part: ltc_Arc) -> vec3f {
  var sum = vec3f(0.0, 0.0, 0.0);
  var t = part.start + part.extent;
  var sign = 1.0;
  for (var end = 0; end < 2; end++) {
    sum = sum + ltc_cone_point(cone, t).sum * sign;
    t = part.start;
    sign = -1.0;
  }
  return cone.e1 * sum.x + cone.e2 * sum.y + cone.e3 * sum.z;
}

// ---- front --------------------------------------------------------------------------------------
//
// A third half space: what lies behind the plane of the triangle is hidden by it, whatever the
// shading normal says. Where a normal map or interpolation turns that normal, the plane is neither
// horizon, and it cuts the light before both.
//
// A light's outline stays a closed outline when a plane cuts it: pieces end where they cross the
// plane, and edges in the plane join their ends. In directions such an edge is an arc of the plane's
// great circle, that is, an edge like any other, which the two horizons clip and close as they do
// all. So nothing has to be known of three planes at a time, and the integral stays exact.
//
// A polygon's crossings lie on one straight line, where its own plane meets this one: edges from each
// of them to the first found there telescope, and outlines need no order (polygon.glsl). A cone's
// outline is crossed twice at most: what is left is one arc and its chord. A tube's four pieces are
// joined by way of a common crossing q, as the apex joins what the horizons cut.

// A plane's normal in cosine space, unit, from that of shading space: M^T n, see
// horizon_normal_cosine.
fn ltc_plane_normal_cosine(lobe: ltc_Lobe, normal: vec3f) -> vec3f {
  let n = vec3f(lobe.m22 * normal.x - lobe.m20 * normal.z, lobe.det * normal.y,
                lobe.m00 * normal.z - lobe.m02 * normal.x);
  return n * inverseSqrt(max(dot(n, n), ltc_k_tiny));
}

// The part of a segment in front of a plane.
struct ltc_FrontSegment {
  a: vec3f,   // where it begins
  b: vec3f,   // where it ends
  some: bool, // whether there is any
}

// The part of the segment from a to b in front of the plane through the origin with that normal.
fn ltc_segment_in_front(a: vec3f, b: vec3f, front: vec3f) -> ltc_FrontSegment {
  let a_height = dot(front, a);
  let b_height = dot(front, b);
  let span = ltc_span_above(a_height, b_height);
  let d = b - a;
  var segment: ltc_FrontSegment;
  segment.a = a + d * span.t0;
  segment.b = select(b, a + d * span.t1, b_height < 0.0);
  segment.some = a_height > 0.0 || b_height > 0.0;
  return segment;
}

// An edge in the wedge between the horizons with unit normals `up` and z; see closed_edge_term.
fn ltc_closed_term(a: vec3f, b: vec3f, up: vec3f, s: f32) -> vec3f {
  return ltc_closed_edge_term(a, b, dot(up, a), dot(up, b), s);
}

// clipped_cone for the part of the cone in front of the plane with unit normal `front`.
fn ltc_clipped_cone_in_front(cone: ltc_Cone, up: vec3f, front: vec3f) -> vec3f {
  let none = vec3f(0.0, 0.0, 0.0);
  var part = ltc_arc_above(cone, front);
  let uncut = part.extent > ltc_k_full_turn;
  let hidden = part.extent <= 0.0;
  let surface = ltc_arc_above(cone, up);
  let cosine = ltc_arc_above(cone, vec3f(0.0, 0.0, 1.0));
  let start = select(surface.start, cosine.start, surface.extent > ltc_k_full_turn);
  part.start = select(part.start, start, uncut);
  part.extent = select(part.extent, 2.0 * ltc_k_pi, uncut);
  let s = select(1.0, -1.0, cone.e3.y < 0.0);
  let from_ = ltc_cone_direction(cone, part.start + part.extent);
  let to = ltc_cone_direction(cone, part.start);
  let sum = ltc_clipped_arc_term(cone, part, up, s) +
            select(ltc_closed_term(from_, to, up, s), none, uncut);
  let all = cone.e3 * (2.0 * ltc_k_pi * cone.k1 * cone.k2);
  return select(select(sum, all, uncut && ltc_cone_is_above(cone, up)), none, hidden);
}

// An edge's part in front of the plane with unit normal `front`, and what joins its ends to q in that
// plane. Ends that another piece goes on from are joined too, and cancel.
fn ltc_edge_in_front(a: vec3f, b: vec3f, q: vec3f, up: vec3f, front: vec3f, s: f32) -> vec3f {
  let part = ltc_segment_in_front(a, b, front);
  let sum = ltc_closed_term(part.a, part.b, up, s) + ltc_closed_term(part.b, q, up, s) -
            ltc_closed_term(part.a, q, up, s);
  return select(vec3f(0.0, 0.0, 0.0), sum, part.some);
}

// The same of an arc of a cone's outline.
fn ltc_arc_in_front(cone: ltc_Cone, part: ltc_Arc, q: vec3f, up: vec3f, front: vec3f,
                    s: f32) -> vec3f {
  let above = ltc_arc_above(cone, front);
  let turn = 2.0 * ltc_k_pi;
  var x = select(ltc_wrapped_turn(above.start - part.start), 0.0, above.extent > ltc_k_full_turn);
  let none = vec3f(0.0, 0.0, 0.0);
  var sum = none;
  // Intervals on a circle meet themselves again after a turn.
  for (var i = 0; i < 2; i++) {
    let low = max(x, 0.0);
    let high = min(x + above.extent, part.extent);
    let some = high > low;
    if (some) {
      var piece: ltc_Arc;
      piece.start = part.start + low;
      piece.extent = high - low;
      let from_ = ltc_cone_direction(cone, piece.start);
      let to = ltc_cone_direction(cone, piece.start + piece.extent);
      let term = ltc_clipped_arc_term(cone, piece, up, s) + ltc_closed_term(to, q, up, s) -
                 ltc_closed_term(from_, q, up, s);
      sum = sum + term;
    }
    x = x - turn;
  }
  return sum;
}

// Where an edge crosses the plane; `otherwise` where it does not.
fn ltc_edge_crossing(a: vec3f, b: vec3f, front: vec3f, otherwise: vec3f) -> vec3f {
  let a_height = dot(front, a);
  let b_height = dot(front, b);
  let t = ltc_crossing_place(a_height, b_height);
  return select(otherwise, a + (b - a) * t, (a_height < 0.0) != (b_height < 0.0));
}

// The same of an arc of a cone's outline.
fn ltc_arc_crossing(cone: ltc_Cone, part: ltc_Arc, front: vec3f, otherwise: vec3f) -> vec3f {
  let above = ltc_arc_above(cone, front);
  let cut = above.extent > 0.0 && above.extent <= ltc_k_full_turn;
  let end = above.start + above.extent;
  let q = select(otherwise, ltc_cone_direction(cone, end),
                 cut && ltc_wrapped_turn(end - part.start) <= part.extent);
  return select(q, ltc_cone_direction(cone, above.start),
                cut && ltc_wrapped_turn(above.start - part.start) <= part.extent);
}

// ---- polygon edges ------------------------------------------------------------------------------
//
// The sum over a polygon's edges in shading space and in cosine space, clipped to both horizons, and where
// it is cut, to the plane of a triangle.
//
// Source: the edge sum of edge.glsl.

// The sums over the edges of an outline.
struct ltc_EdgeSums {
  diffuse: vec3f,  // 2 pi times the vector irradiance of the clipped polygon in shading space
  specular: vec3f, // the same in cosine space
  outline2: f32,   // square of the mean of the unit vectors to its corners, cosine space
}

// Of an outline without an edge.
fn ltc_no_edge_sums() -> ltc_EdgeSums {
  var sums: ltc_EdgeSums;
  sums.diffuse = vec3f(0.0, 0.0, 0.0);
  sums.specular = sums.diffuse;
  sums.outline2 = 1.0;
  return sums;
}

// Square of the length of a mean, from the sum and the number of its parts.
fn ltc_mean_length2(sum: vec3f, count: f32) -> f32 {
  return dot(sum, sum) / max(count * count, 1.0);
}

// ---- outline ------------------------------------------------------------------------------------
//
// The sum over a polygon's edges as one lane does it by itself, as in a shader: an edge is cut by one plane after
// the other, and what nothing is left of is passed over by a branch. Code that is short and holds little at a time
// is what counts there, so each edge begins anew with its two ends.
//
// Where an outline crosses a plane, what is left of it goes on in the plane. All its crossings lie on the straight
// line in which the polygon's own plane meets this one, which a point that has a side of the polygon sees as less than
// half a turn: so edges between each crossing and the first telescope, and outlines may be concave, or have holes. Such
// an edge is then cut by the next plane like any other. Lanes, which all walk the same way, close at an apex instead,
// a sum without a memory (edge.glsl).

// What is summed along an outline, and where it first crossed each plane.
struct ltc_OutlineSums {
  diffuse: vec3f,    // 2 pi times the vector irradiance, shading space
  specular: vec3f,   // the same in cosine space
  front: vec3f,      // the first crossing of the triangle's plane, shading space
  horizon: vec3f,    // of the surface's horizon, shading space
  cosine: vec3f,     // and of the cosine's horizon, unit, cosine space
  has_front: bool,   // whether there was any
  has_horizon: bool, // whether there was any
  has_cosine: bool,  // whether there was any
}

// No edges yet.
fn ltc_no_outline() -> ltc_OutlineSums {
  var outline: ltc_OutlineSums;
  outline.diffuse = vec3f(0.0, 0.0, 0.0);
  outline.specular = outline.diffuse;
  outline.front = outline.diffuse;
  outline.horizon = outline.diffuse;
  outline.cosine = outline.diffuse;
  outline.has_front = false;
  outline.has_horizon = false;
  outline.has_cosine = false;
  return outline;
}

// The edge from a to b (cosine space), above the surface's horizon, cut by the cosine's, for the specular sum.
fn ltc_add_to_specular(outline: ltc_OutlineSums, a: vec3f, b: vec3f) -> ltc_OutlineSums {
  var next = outline;
  let a_up = a.z >= 0.0;
  let b_up = b.z >= 0.0;
  if (a_up || b_up) {
    var from_ = a;
    var to = b;
    var along = b - a;
    if (a_up != b_up) {
      let t = ltc_crossing_place(a.z, b.z);
      let cut = vec3f(a.x + along.x * t, a.y + along.y * t, 0.0);
      let unit = cut * ltc_inverse_length(cut);
      var leaves = 1.0;
      if (a_up) {
        to = cut;
        along = along * t;
      } else {
        from_ = cut;
        along = along * (1.0 - t);
        leaves = -1.0;
      }
      if (outline.has_cosine) {
        let angle = ltc_angle_of_unit(dot(unit, outline.cosine),
                                      unit.x * outline.cosine.y - unit.y * outline.cosine.x);
        next.specular.z = next.specular.z + angle * leaves;
      } else {
        next.cosine = unit;
        next.has_cosine = true;
      }
    }
    next.specular = next.specular + ltc_edge_term(from_, to, along);
  }
  return next;
}

// The edge from a to b (shading space), cut by both horizons, for both sums.
fn ltc_add_to_outline(outline: ltc_OutlineSums, a: vec3f, b: vec3f,
                      lobe: ltc_Lobe) -> ltc_OutlineSums {
  var next = outline;
  let a_up = a.z >= 0.0;
  let b_up = b.z >= 0.0;
  var from_ = a;
  var to = b;
  var parts = select(0, 1, a_up || b_up);
  if (a_up != b_up) {
    let t = ltc_crossing_place(a.z, b.z);
    let cut = vec3f(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, 0.0);
    if (a_up) {
      to = cut;
    } else {
      from_ = cut;
    }
    if (outline.has_horizon) {
      parts = 2;
    } else {
      next.horizon = cut;
      next.has_horizon = true;
    }
  }
  for (var i = 0; i < parts; i++) {
    next.diffuse = next.diffuse + ltc_edge_term(from_, to, to - from_);
    next = ltc_add_to_specular(next, ltc_to_cosine(lobe, from_), ltc_to_cosine(lobe, to));
    // What joins the crossing to the first.
    if (a_up) {
      from_ = to;
      to = outline.horizon;
    } else {
      to = from_;
      from_ = outline.horizon;
    }
  }
  return next;
}

// The same, with `cut` cut before all else by the plane of the triangle, whose unit normal in shading space is
// `front`.
fn ltc_add_in_front(outline: ltc_OutlineSums, a: vec3f, b: vec3f, lobe: ltc_Lobe, cut: bool,
                    front: vec3f) -> ltc_OutlineSums {
  var next = outline;
  var from_ = a;
  var to = b;
  var next_from = a;
  var next_to = a;
  var parts = 1;
  if (cut) {
    let a_height = dot(front, a);
    let b_height = dot(front, b);
    let a_seen = a_height >= 0.0;
    let b_seen = b_height >= 0.0;
    parts = select(0, 1, a_seen || b_seen);
    if (a_seen != b_seen) {
      var crossing = a + (b - a) * ltc_crossing_place(a_height, b_height);
      // See corner_between.
      crossing = crossing - front * dot(front, crossing);
      if (a_seen) {
        to = crossing;
        next_from = crossing;
        next_to = outline.front;
      } else {
        from_ = crossing;
        next_from = outline.front;
        next_to = crossing;
      }
      if (outline.has_front) {
        parts = 2;
      } else {
        next.front = crossing;
        next.has_front = true;
      }
    }
  }
  for (var i = 0; i < parts; i++) {
    next = ltc_add_to_outline(next, from_, to, lobe);
    // What joins the crossing to the first.
    from_ = next_from;
    to = next_to;
  }
  return next;
}

// sum_edges in one lane, and with `cut` of what is in front of the plane with unit normal `front`, shading space.
fn ltc_sum_edges_in_one_lane(polygon: i32, position: vec3f, frame: ltc_Frame, lobe: ltc_Lobe,
                             cut: bool, front: vec3f) -> ltc_EdgeSums {
  var outline = ltc_no_outline();
  var corners = outline.diffuse;
  var corner_count = 0.0;
  var a = ltc_to_shading(frame, ltc_polygon_point(polygon, 0) - position);
  let count = ltc_polygon_point_count(polygon);
  for (var i = 1; i < count; i++) {
    let b = ltc_to_shading(frame, ltc_polygon_point(polygon, i) - position);
    if (!ltc_polygon_starts_ring(polygon, i)) {
      let o = ltc_to_cosine(lobe, b);
      corners = corners + o * ltc_inverse_length(o);
      corner_count = corner_count + 1.0;
      outline = ltc_add_in_front(outline, a, b, lobe, cut, front);
    }
    a = b;
  }
  var sums: ltc_EdgeSums;
  sums.diffuse = outline.diffuse;
  sums.specular = outline.specular;
  sums.outline2 = ltc_mean_length2(corners, corner_count);
  return sums;
}

// sum_edges in one lane, and with `cut` of what is in front of the plane with unit normal `front`, shading space.
fn ltc_quad_sum_edges_in_one_lane(quad: ltc_Quad, position: vec3f, frame: ltc_Frame,
                                  lobe: ltc_Lobe, front: vec3f) -> ltc_EdgeSums {
  var outline = ltc_no_outline();
  var corners = outline.diffuse;
  var corner_count = 0.0;
  var a = ltc_to_shading(frame, ltc_quad_point(quad, 0) - position);
  let count = 5;
  for (var i = 1; i < count; i++) {
    let b = ltc_to_shading(frame, ltc_quad_point(quad, i) - position);
    let o = ltc_to_cosine(lobe, b);
    corners = corners + o * ltc_inverse_length(o);
    corner_count = corner_count + 1.0;
    outline = ltc_add_in_front(outline, a, b, lobe, true, front);
    a = b;
  }
  var sums: ltc_EdgeSums;
  sums.diffuse = outline.diffuse;
  sums.specular = outline.specular;
  sums.outline2 = ltc_mean_length2(corners, corner_count);
  return sums;
}

// ---- convex quad --------------------------------------------------------------------------------
//
// A convex quad cut by both horizons in one lane, without a loop and with next to no branch: what the surface's
// horizon leaves of it has five corners at most, and five that may coincide stand for every case. In cosine space
// their five edges are cut one by one and closed in their plane, as in lanes (close_outline).

// The point where an edge crosses the surface's horizon, shading space.
fn ltc_horizon_point(a: vec3f, b: vec3f) -> vec3f {
  let t = ltc_crossing_place(a.z, b.z);
  return vec3f(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, 0.0);
}

// Five corners of a convex outline in its order, of which some may coincide.
struct ltc_FiveCorners {
  first: vec3f,  // shading space
  second: vec3f, // see first
  third: vec3f,  // see first
  fourth: vec3f, // see first
  fifth: vec3f,  // see first
}

// The same, from the second on.
fn ltc_next_corner_first(corners: ltc_FiveCorners) -> ltc_FiveCorners {
  var next: ltc_FiveCorners;
  next.first = corners.second;
  next.second = corners.third;
  next.third = corners.fourth;
  next.fourth = corners.fifth;
  next.fifth = corners.first;
  return next;
}

// 2 pi times the vector irradiance of what they bound, which is above the horizon, shading space.
fn ltc_sum_corners(corners: ltc_FiveCorners) -> vec3f {
  var left = corners;
  var sum = vec3f(0.0, 0.0, 0.0);
  var a = corners.fifth;
  var inv_a = ltc_inverse_length(a);
  for (var i = 0; i < 5; i++) {
    let b = left.first;
    let inv_b = ltc_inverse_length(b);
    sum = sum + ltc_edge_term_scaled(a, b, b - a, inv_a, inv_b);
    a = b;
    inv_a = inv_b;
    left = ltc_next_corner_first(left);
  }
  return sum;
}

// The sum over a convex outline in cosine space, and where it crosses the cosine's horizon: at most once either way.
struct ltc_ConvexSum {
  term: vec3f,   // 2 pi times the vector irradiance, not yet closed
  enters: vec3f, // where the outline comes up, unit
  leaves: vec3f, // and where it goes down
}

// No edges yet.
fn ltc_no_convex_edges() -> ltc_ConvexSum {
  var sum: ltc_ConvexSum;
  sum.term = vec3f(0.0, 0.0, 0.0);
  sum.enters = vec3f(1.0, 0.0, 0.0);
  sum.leaves = sum.enters;
  return sum;
}

// The edge from a to b, cosine space, cut by its horizon without a branch: of an edge below it the length is 0. inv_a,
// inv_b: 1 / their lengths.
fn ltc_add_convex_edge(sum: ltc_ConvexSum, a: vec3f, b: vec3f, inv_a: f32,
                       inv_b: f32) -> ltc_ConvexSum {
  let a_up = a.z >= 0.0;
  let b_up = b.z >= 0.0;
  let along = b - a;
  let t = ltc_crossing_place(a.z, b.z);
  let cut = vec3f(a.x + along.x * t, a.y + along.y * t, 0.0);
  let inv_cut = ltc_inverse_length(cut);
  let unit = cut * inv_cut;
  let extent = select(select(0.0, 1.0 - t, b_up), select(t, 1.0, b_up), a_up);
  var next: ltc_ConvexSum;
  next.term = sum.term +
              ltc_edge_term_scaled(select(cut, a, a_up), select(cut, b, b_up), along * extent,
                                   select(inv_cut, inv_a, a_up), select(inv_cut, inv_b, b_up));
  next.enters = select(sum.enters, unit, b_up && !a_up);
  next.leaves = select(sum.leaves, unit, a_up && !b_up);
  return next;
}

// The specular sum of a whole outline, closed along the cosine's horizon. way: negative where a positive angle about z
// leads backwards; it holds whatever rounding makes of an angle near 0.
fn ltc_close_convex_outline(sum: ltc_ConvexSum, way: f32) -> vec3f {
  let a = sum.leaves;
  let b = sum.enters;
  let angle = abs(ltc_angle_of_unit(a.x * b.x + a.y * b.y, a.x * b.y - a.y * b.x));
  return vec3f(sum.term.x, sum.term.y, sum.term.z + select(angle, -angle, way < 0.0));
}

// sum_corners in cosine space. way: see close_convex_outline.
fn ltc_sum_corners_cosine(corners: ltc_FiveCorners, lobe: ltc_Lobe, way: f32) -> vec3f {
  var left = corners;
  var sum = ltc_no_convex_edges();
  var a = ltc_to_cosine(lobe, corners.fifth);
  var inv_a = ltc_inverse_length(a);
  for (var i = 0; i < 5; i++) {
    let b = ltc_to_cosine(lobe, left.first);
    let inv_b = ltc_inverse_length(b);
    sum = ltc_add_convex_edge(sum, a, b, inv_a, inv_b);
    a = b;
    inv_a = inv_b;
    left = ltc_next_corner_first(left);
  }
  return ltc_close_convex_outline(sum, way);
}

// sum_edges, but for outline2, of a convex quad with these corners, shading space, in its order. h: signed
// distance of its plane along its normal.
fn ltc_sum_convex_quad(corner0: vec3f, corner1: vec3f, corner2: vec3f, corner3: vec3f, h: f32,
                       lobe: ltc_Lobe) -> ltc_EdgeSums {
  var a = corner0;
  var b = corner1;
  var c = corner2;
  var d = corner3;
  // Turned until it enters at a: a is above and d is not. One that is wholly above comes as it may.
  for (var i = 0; i < 3; i++) {
    let enters = a.z >= 0.0 && d.z < 0.0;
    let first = a;
    a = select(b, a, enters);
    b = select(c, b, enters);
    c = select(d, c, enters);
    d = select(first, d, enters);
  }
  let seen = a.z >= 0.0;
  let two = b.z >= 0.0;
  let three = two && c.z >= 0.0;
  let four = d.z >= 0.0;
  let last = select(select(a, b, two), c, three);
  let below = select(select(b, c, two), d, three);
  let leaves = select(ltc_horizon_point(last, below), d, four);
  var corners: ltc_FiveCorners;
  corners.first = a;
  corners.second = select(leaves, b, two);
  corners.third = select(leaves, c, three);
  corners.fourth = leaves;
  corners.fifth = select(ltc_horizon_point(d, a), d, four);
  let none = vec3f(0.0, 0.0, 0.0);
  var sums: ltc_EdgeSums;
  sums.diffuse = select(none, ltc_sum_corners(corners), seen);
  sums.specular = select(none, ltc_sum_corners_cosine(corners, lobe, h * lobe.det), seen);
  sums.outline2 = 0.0;
  return sums;
}

// sum_edges_in_one_lane of a parallelogram at signed distance h along its normal: by its outline where a triangle's
// plane cuts it, and else as above.
fn ltc_sum_quad_in_one_lane(quad: ltc_Quad, position: vec3f, frame: ltc_Frame, lobe: ltc_Lobe,
                            h: f32, cut: bool, front: vec3f) -> ltc_EdgeSums {
  // Its middle and sides take three turns where four corners take four.
  let middle = ltc_to_shading(frame, ltc_quad_centroid(quad) - position);
  let u = ltc_to_shading(frame, ltc_quad_half_u(quad));
  let v = ltc_to_shading(frame, ltc_quad_half_v(quad));
  let a = middle - u - v;
  let b = middle + u - v;
  let c = middle + u + v;
  let d = middle - u + v;
  if (cut) {
    let lowest = min(min(dot(front, a), dot(front, b)), min(dot(front, c), dot(front, d)));
    if (lowest < 0.0) {
      return ltc_quad_sum_edges_in_one_lane(quad, position, frame, lobe, front);
    }
  }
  var sums = ltc_sum_convex_quad(a, b, c, d, h, lobe);
  let corners = ltc_safe_direction(ltc_to_cosine(lobe, a)) +
                ltc_safe_direction(ltc_to_cosine(lobe, b)) +
                ltc_safe_direction(ltc_to_cosine(lobe, c)) +
                ltc_safe_direction(ltc_to_cosine(lobe, d));
  sums.outline2 = ltc_mean_length2(corners, 4.0);
  return sums;
}

// ---- polygon ------------------------------------------------------------------------------------
//
// The integral of a lobe over a polygon, exact, clipped to both horizons: the sum over its edges
// (polygon_edges.glsl), or where it is small an expansion around its middle. Its sampling: polygon_points.glsl.
//
// The prelude of each target gives the polygon, the same for all lanes, in world space:
//   int  polygon_point_count(Polygon)            rings one after the other, each closed by
//                                                repeating its first point
//   Vec3 polygon_point(Polygon, int)             world space
//   bool polygon_starts_ring(Polygon, int)
//   Vec3 polygon_origin(Polygon)                 a point of its plane
//   Vec3 polygon_normal(Polygon)                 unit, to the emitting side
//   bool polygon_two_sided(Polygon)
//   bool polygon_is_parallelogram(Polygon)       of four corners; where that is known beforehand
//   Vec3 polygon_half_u(Polygon), polygon_half_v(Polygon)  of one that is: from its middle to that of
//                                                the side from corner 1 to 2, and of that from 2 to 3
//   Real polygon_area(Polygon)                   square metres
//   Vec3 polygon_centroid(Polygon), polygon_spread_u(Polygon), polygon_spread_v(Polygon),
//   Real polygon_radius(Polygon)                 see PolygonMoments; around the centroid

// A small polygon: where it is in shading space, and how far it spreads.
struct ltc_SmallPolygon {
  center: vec3f,    // its centroid
  u: vec3f,         // its spread, see PolygonMoments
  v: vec3f,         // and the one across
  radius: f32,      // around the centroid
  area_height: f32, // area times the distance from its plane
}

// What its small form has of a polygon's integral over one lobe.
struct ltc_SmallShare {
  sum: vec3f,    // its part of 2 pi times the vector irradiance
  by_edges: f32, // the share, 0..1, of the sums over the edges, which are the rest
}

// All by the edges.
fn ltc_no_small_share() -> ltc_SmallShare {
  var share: ltc_SmallShare;
  share.sum = vec3f(0.0, 0.0, 0.0);
  share.by_edges = 1.0;
  return share;
}

// Square of the angular radius below which the small form is all, 0.03.
const ltc_k_wholly_small_radius2: f32 = 0.0009;

// Square of the one below which it begins, 0.05.
const ltc_k_small_radius2: f32 = 0.0025;

// 1 over what lies between, over which the one fades into the other.
const ltc_k_inv_small_range: f32 = 625.0;

// What a polygon's small form has of its integral: all of one that is small against its distance and wholly above
// both horizons. With `cut`, what the plane with unit normal `front` may cut is the edges', however small.
//
// The edge terms of a small polygon nearly cancel, of which rounding makes 1e-7 over its angular
// radius, and the coordinates' own rounding the same again. So from a twentieth downwards it is handed over, without a
// step, to its area, centroid and second moments. At p, o = M^-1 p, a solid angle area h / |p|^3 is det |p|^3 / |o|^3
// times that in cosine space, so that the density makes o / |o|^4 of it (docs/method.md, section 9). The mean of
// that over the polygon is here to second order around the centroid: with x = o.u / |o|^2, and y for v,
//   (o (1 + 6 (x^2 + y^2) - (u^2 + v^2) / |o|^2) - 2 (x u + y v)) / |o|^4,
// wrong by the fourth power of the angular radius, or the third of a lopsided one: 2e-6 or 1e-5 at 0.03.
fn ltc_small_share(small: ltc_SmallPolygon, lobe: ltc_Lobe, cut: bool,
                   front: vec3f) -> ltc_SmallShare {
  let o = ltc_to_cosine(lobe, small.center);
  let u = ltc_to_cosine(lobe, small.u);
  let v = ltc_to_cosine(lobe, small.v);
  let inv_o2 = 1.0 / max(dot(o, o), ltc_k_tiny);
  let reach2 = small.radius * small.radius * ltc_lobe_stretch2(lobe) * inv_o2;
  var above = small.center.z > small.radius && o.z > 0.0 && o.z * o.z * inv_o2 > reach2;
  if (cut) {
    above = above && dot(front, small.center) > small.radius;
  }
  var share: ltc_SmallShare;
  share.by_edges = select(1.0,
                          min(max((reach2 - ltc_k_wholly_small_radius2) * ltc_k_inv_small_range,
                                  0.0), 1.0), above);
  let x = dot(o, u) * inv_o2;
  let y = dot(o, v) * inv_o2;
  let middle = 1.0 + 6.0 * (x * x + y * y) - (dot(u, u) + dot(v, v)) * inv_o2;
  let mean = o * middle - (u * x + v * y) * 2.0;
  let rest = 2.0 * small.area_height * (1.0 - share.by_edges);
  share.sum = select(vec3f(0.0, 0.0, 0.0), mean * (rest * inv_o2 * (lobe.det * inv_o2)),
                     share.by_edges < 1.0);
  return share;
}

// EdgeSums.outline2 for what fades into the small form, which lies in one direction.
fn ltc_small_outline2(sums: ltc_EdgeSums, exact: f32) -> f32 {
  return 1.0 + (sums.outline2 - 1.0) * exact;
}

// The sign that its edge sums want: -1 in front, 1 behind a two-sided one, else 0. h: signed distance of
// its plane along its normal.
fn ltc_lit_side(polygon: i32, h: f32, to_origin: vec3f) -> f32 {
  let side = select(select(0.0, 1.0, ltc_polygon_two_sided(polygon)), -1.0, h < 0.0);
  return select(side, 0.0, ltc_lies_in_plane(h, to_origin, 0.0));
}

// The sign that its edge sums want: -1 in front, 1 behind a two-sided one, else 0. h: signed distance of
// its plane along its normal.
fn ltc_quad_lit_side(quad: ltc_Quad, h: f32, to_origin: vec3f) -> f32 {
  let side = select(select(0.0, 1.0, ltc_quad_two_sided(quad)), -1.0, h < 0.0);
  return select(side, 0.0, ltc_lies_in_plane(h, to_origin, 0.0));
}

// What a point knows of a polygon before it asks a lobe.
struct ltc_PolygonSight {
  h: f32,           // signed distance of its plane, along its normal
  side: f32,        // see lit_side
  to_center: vec3f, // its centroid, from the point, world space
  radius: f32,      // around the centroid
  large: bool,      // whether no lane sees it small, in shading space or in any lobe's cosine space
}

// Of a point at `position`, world space.
fn ltc_see_polygon(polygon: i32, position: vec3f) -> ltc_PolygonSight {
  var sight: ltc_PolygonSight;
  let to_origin = ltc_polygon_origin(polygon) - position;
  sight.h = dot(to_origin, ltc_polygon_normal(polygon));
  sight.side = ltc_lit_side(polygon, sight.h, to_origin);
  sight.to_center = ltc_polygon_centroid(polygon) - position;
  sight.radius = ltc_polygon_radius(polygon);
  // What is not small in shading space is not in cosine space, where its radius counts as much longer as the
  // distance can become.
  sight.large = sight.radius * sight.radius >=
                ltc_k_small_radius2 * dot(sight.to_center, sight.to_center);
  return sight;
}

// Of a point at `position`, world space.
fn ltc_see_quad(quad: ltc_Quad, position: vec3f) -> ltc_PolygonSight {
  var sight: ltc_PolygonSight;
  let to_origin = ltc_quad_origin(quad) - position;
  sight.h = dot(to_origin, ltc_quad_normal(quad));
  sight.side = ltc_quad_lit_side(quad, sight.h, to_origin);
  sight.to_center = ltc_quad_centroid(quad) - position;
  sight.radius = ltc_quad_radius(quad);
  // What is not small in shading space is not in cosine space, where its radius counts as much longer as the
  // distance can become.
  sight.large = sight.radius * sight.radius >=
                ltc_k_small_radius2 * dot(sight.to_center, sight.to_center);
  return sight;
}

// A polygon as that point sees it, for its small form; center: its centroid, shading space.
fn ltc_small_polygon(polygon: i32, sight: ltc_PolygonSight, center: vec3f,
                     frame: ltc_Frame) -> ltc_SmallPolygon {
  var small: ltc_SmallPolygon;
  small.center = center;
  small.u = ltc_to_shading(frame, ltc_polygon_spread_u(polygon));
  small.v = ltc_to_shading(frame, ltc_polygon_spread_v(polygon));
  small.radius = sight.radius;
  small.area_height = ltc_polygon_area(polygon) * abs(sight.h) * abs(sight.side);
  return small;
}

// A polygon as that point sees it, for its small form; center: its centroid, shading space.
fn ltc_small_quad(quad: ltc_Quad, sight: ltc_PolygonSight, center: vec3f,
                  frame: ltc_Frame) -> ltc_SmallPolygon {
  var small: ltc_SmallPolygon;
  small.center = center;
  small.u = ltc_to_shading(frame, ltc_quad_spread_u(quad));
  small.v = ltc_to_shading(frame, ltc_quad_spread_v(quad));
  small.radius = sight.radius;
  small.area_height = ltc_quad_area(quad) * abs(sight.h) * abs(sight.side);
  return small;
}

// The sums over its edges in whichever way suits its outline and what cuts it.
fn ltc_sum_polygon_edges(polygon: i32, position: vec3f, frame: ltc_Frame, lobe: ltc_Lobe,
                         cut: bool, front: vec3f) -> ltc_EdgeSums {
  return ltc_sum_edges_in_one_lane(polygon, position, frame, lobe, cut, front);
}

// The sums over its edges in whichever way suits its outline and what cuts it.
fn ltc_sum_quad_edges(quad: ltc_Quad, position: vec3f, frame: ltc_Frame, lobe: ltc_Lobe, h: f32,
                      cut: bool, front: vec3f) -> ltc_EdgeSums {
  return ltc_sum_quad_in_one_lane(quad, position, frame, lobe, h, cut, front);
}

// Integrals over a polygon seen from `position` (world space), for Lambert and for `lobe`. Zero
// behind a one-sided polygon and in the plane of any; whoever knows `position` less well than its
// last digit asks has_side (surface.glsl) as well. With `cut`, of what is in front of the plane with
// unit normal `front` (shading space).
//
// The edge sum of the polygon in cosine space is a vector, its vector irradiance. The z component
// is the integral; the direction is the mean direction of the part of the polygon that counts,
// and M carries it back to shading space. It tells which Fresnel reflectance that light meets.
fn ltc_integrate_polygon_part(polygon: i32, position: vec3f, frame: ltc_Frame, lobe: ltc_Lobe,
                              cut: bool, front: vec3f) -> ltc_LightIntegral {
  let sight = ltc_see_polygon(polygon, position);
  var diffuse = ltc_no_small_share();
  var specular = diffuse;
  // Uniform shortcut.
  if (!sight.large) {
    let small = ltc_small_polygon(polygon, sight, ltc_to_shading(frame, sight.to_center), frame);
    diffuse = ltc_small_share(small, ltc_cosine_lobe(), cut, front);
    specular = ltc_small_share(small, lobe, cut, front);
  }

  var sums = ltc_no_edge_sums();
  // Uniform shortcut: no lane is on a lit side and wants the edges.
  if (sight.side != 0.0 && (diffuse.by_edges > 0.0 || specular.by_edges > 0.0)) {
    sums = ltc_sum_polygon_edges(polygon, position, frame, lobe, cut, front);
  }
  return ltc_light_integral(sums.diffuse * (sight.side * diffuse.by_edges) + diffuse.sum,
                            sums.specular * (sight.side * specular.by_edges) + specular.sum, lobe,
                            ltc_small_outline2(sums, specular.by_edges));
}

// Integrals over a polygon seen from `position` (world space), for Lambert and for `lobe`. Zero
// behind a one-sided polygon and in the plane of any; whoever knows `position` less well than its
// last digit asks has_side (surface.glsl) as well. With `cut`, of what is in front of the plane with
// unit normal `front` (shading space).
//
// The edge sum of the polygon in cosine space is a vector, its vector irradiance. The z component
// is the integral; the direction is the mean direction of the part of the polygon that counts,
// and M carries it back to shading space. It tells which Fresnel reflectance that light meets.
fn ltc_integrate_quad_part(quad: ltc_Quad, position: vec3f, frame: ltc_Frame, lobe: ltc_Lobe,
                           cut: bool, front: vec3f) -> ltc_LightIntegral {
  let sight = ltc_see_quad(quad, position);
  var diffuse = ltc_no_small_share();
  var specular = diffuse;
  // Uniform shortcut.
  if (!sight.large) {
    let small = ltc_small_quad(quad, sight, ltc_to_shading(frame, sight.to_center), frame);
    diffuse = ltc_small_share(small, ltc_cosine_lobe(), cut, front);
    specular = ltc_small_share(small, lobe, cut, front);
  }

  var sums = ltc_no_edge_sums();
  // Uniform shortcut: no lane is on a lit side and wants the edges.
  if (sight.side != 0.0 && (diffuse.by_edges > 0.0 || specular.by_edges > 0.0)) {
    sums = ltc_sum_quad_edges(quad, position, frame, lobe, sight.h, cut, front);
  }
  return ltc_light_integral(sums.diffuse * (sight.side * diffuse.by_edges) + diffuse.sum,
                            sums.specular * (sight.side * specular.by_edges) + specular.sum, lobe,
                            ltc_small_outline2(sums, specular.by_edges));
}

// Of a polygon over the plane through `position` with that unit normal, world space.
fn ltc_polygon_heights(polygon: i32, position: vec3f, normal: vec3f) -> ltc_Heights {
  var heights: ltc_Heights;
  heights.low = dot(normal, ltc_polygon_point(polygon, 0) - position);
  heights.high = heights.low;
  let count = ltc_polygon_point_count(polygon);
  for (var i = 1; i < count; i++) {
    let height = dot(normal, ltc_polygon_point(polygon, i) - position);
    heights.low = min(heights.low, height);
    heights.high = max(heights.high, height);
  }
  return heights;
}

// Of a polygon over the plane through `position` with that unit normal, world space.
fn ltc_quad_heights(quad: ltc_Quad, position: vec3f, normal: vec3f) -> ltc_Heights {
  var heights: ltc_Heights;
  heights.low = dot(normal, ltc_quad_point(quad, 0) - position);
  heights.high = heights.low;
  let count = 5;
  for (var i = 1; i < count; i++) {
    let height = dot(normal, ltc_quad_point(quad, i) - position);
    heights.low = min(heights.low, height);
    heights.high = max(heights.high, height);
  }
  return heights;
}

// ---- polygon surface ----------------------------------------------------------------------------
//
// A polygon as a surface sees it, less what the surface's triangle hides: by the fitted lobe (polygon.glsl), or by
// GGX itself, along the same edges (exact/half_vector.glsl).

// Both in one lane, which passes over what it does not need.
fn ltc_polygon_integral_in_one_lane(s: ltc_Surface, polygon: i32) -> ltc_LightIntegral {
  let front = ltc_front_shading(s);
  var integral = ltc_integrate_polygon_part(polygon, s.position, s.frame, s.fitted.lobe, s.tilted,
                                            front);
  if (s.tilted) {
    integral = ltc_unless_hidden(s, ltc_polygon_heights(polygon, s.position, s.geometric), integral);
  }
  return ltc_unless_in_plane(s, ltc_polygon_origin(polygon), ltc_polygon_normal(polygon), integral);
}

// Both in one lane, which passes over what it does not need.
fn ltc_quad_integral_in_one_lane(s: ltc_Surface, quad: ltc_Quad) -> ltc_LightIntegral {
  let front = ltc_front_shading(s);
  var integral = ltc_integrate_quad_part(quad, s.position, s.frame, s.fitted.lobe, s.tilted, front);
  if (s.tilted) {
    integral = ltc_unless_hidden(s, ltc_quad_heights(quad, s.position, s.geometric), integral);
  }
  return ltc_unless_in_plane(s, ltc_quad_origin(quad), ltc_quad_normal(quad), integral);
}

// The integral by the lobes. Uniform shortcut: no lane's triangle reaches the light.
fn ltc_lobes_polygon_integral(s: ltc_Surface, polygon: i32) -> ltc_LightIntegral {
  return ltc_polygon_integral_in_one_lane(s, polygon);
}

// The integral by the lobes. Uniform shortcut: no lane's triangle reaches the light.
fn ltc_lobes_quad_integral(s: ltc_Surface, quad: ltc_Quad) -> ltc_LightIntegral {
  return ltc_quad_integral_in_one_lane(s, quad);
}

// The integral over a polygon as a surface sees it: what its triangle hides is left out, and all of it
// without a side of the polygon.
fn ltc_surface_polygon_integral(s: ltc_Surface, polygon: i32) -> ltc_LightIntegral {
  return ltc_lobes_polygon_integral(s, polygon);
}

// The integral over a polygon as a surface sees it: what its triangle hides is left out, and all of it
// without a side of the polygon.
fn ltc_surface_quad_integral(s: ltc_Surface, quad: ltc_Quad) -> ltc_LightIntegral {
  return ltc_lobes_quad_integral(s, quad);
}

// Light that a surface reflects of a polygon of radiance 1, without shadow.
fn ltc_shade_polygon_parts(s: ltc_Surface, polygon: i32) -> ltc_ShadedLight {
  return ltc_shade_integral(s, ltc_surface_polygon_integral(s, polygon));
}

// Light that a surface reflects of a polygon of radiance 1, without shadow.
fn ltc_shade_quad_parts(s: ltc_Surface, quad: ltc_Quad) -> ltc_ShadedLight {
  return ltc_shade_integral(s, ltc_surface_quad_integral(s, quad));
}

// Light that a surface reflects of it, for radiance 1 and without shadow: shade_polygon_parts, both together.
// Not by way of shade_polygon_parts, nor of what it asks: where a compiler does not inline
// these, each copies the surface, 3 % of a quad's instructions.
fn ltc_shade_polygon(s: ltc_Surface, polygon: i32) -> vec3f {
  let by_lobes = ltc_without_exact(s);
  return ltc_both_parts(ltc_shade_integral(by_lobes,
                                           ltc_polygon_integral_in_one_lane(by_lobes, polygon)));
}

// Light that a surface reflects of it, for radiance 1 and without shadow: shade_polygon_parts, both together.
// Not by way of shade_polygon_parts, nor of what it asks: where a compiler does not inline
// these, each copies the surface, 3 % of a quad's instructions.
fn ltc_shade_quad(s: ltc_Surface, quad: ltc_Quad) -> vec3f {
  let by_lobes = ltc_without_exact(s);
  return ltc_both_parts(ltc_shade_integral(by_lobes, ltc_quad_integral_in_one_lane(by_lobes, quad)));
}

// ---- ellipse ------------------------------------------------------------------------------------
//
// The integral of a lobe over a flat ellipse or disk, exact, clipped to both horizons: a cone in
// shading space for Lambert, and its image under M^-1 for the lobe. See cone.glsl.

// A flat ellipse in world space; emits along half_u x half_v.
struct ltc_Ellipse {
  center: vec3f,  // world space
  half_u: vec3f,  // semi-axes, perpendicular, metres
  half_v: vec3f,  // the other one
  two_sided: f32, // 0 or 1
}

// Unit, to the emitting side.
fn ltc_ellipse_normal(ellipse: ltc_Ellipse) -> vec3f {
  let normal = cross(ellipse.half_u, ellipse.half_v);
  return normal * inverseSqrt(max(dot(normal, normal), ltc_k_tiny));
}

// 2 pi times the vector irradiances of a cone of directions.
struct ltc_ConeSums {
  diffuse: vec3f,  // in shading space, clipped to the horizon
  specular: vec3f, // in cosine space, clipped to both horizons
  outline2: f32,   // see light_concentration
}

// Those of the cone of directions to a flat ellipse, all in shading space; where `cut`, of its part
// in front of the plane with unit normal `front`.
fn ltc_sum_ellipse_cone(center: vec3f, u: vec3f, v: vec3f, lobe: ltc_Lobe, front: vec3f,
                        cut: bool) -> ltc_ConeSums {
  var sums: ltc_ConeSums;
  sums.specular = vec3f(0.0, 0.0, 0.0);
  var now = ltc_cosine_lobe();
  for (var i = 0; i < 2; i++) {
    let cone = ltc_make_cone(ltc_to_cosine(now, center), ltc_to_cosine(now, u),
                             ltc_to_cosine(now, v));
    let up = ltc_horizon_normal_cosine(now);
    sums.diffuse = sums.specular;
    sums.outline2 = ltc_cone_outline2(cone);
    if (cut) {
      sums.specular = ltc_clipped_cone_in_front(cone, up, ltc_plane_normal_cosine(now, front));
    } else {
      sums.specular = ltc_clipped_cone(cone, up);
    }
    now = lobe;
  }
  return sums;
}

// 1 where an ellipse, shading space, shines on the point, 0 elsewhere.
fn ltc_ellipse_side(center: vec3f, u: vec3f, v: vec3f, two_sided: f32) -> f32 {
  let normal = cross(u, v);
  let h = dot(center, normal) * inverseSqrt(max(dot(normal, normal), ltc_k_tiny));
  var side = select(two_sided, 1.0, h < 0.0);
  side = select(side, 0.0, ltc_lies_in_plane(h, center, 0.0));
  // Its highest point: an ellipse below the horizon gives nothing, rounding or not.
  let reach = sqrt(u.z * u.z + v.z * v.z);
  return select(0.0, side, center.z + reach > 0.0);
}

// integrate_ellipse; where `cut`, over what is in front of the plane with unit normal `front`
// (shading space).
fn ltc_integrate_ellipse_part(ellipse: ltc_Ellipse, position: vec3f, frame: ltc_Frame,
                              lobe: ltc_Lobe, front: vec3f, cut: bool) -> ltc_LightIntegral {
  let center = ltc_to_shading(frame, ellipse.center - position);
  let u = ltc_to_shading(frame, ellipse.half_u);
  let v = ltc_to_shading(frame, ellipse.half_v);
  let sums = ltc_sum_ellipse_cone(center, u, v, lobe, front, cut);
  let side = ltc_ellipse_side(center, u, v, ellipse.two_sided);
  return ltc_light_integral(sums.diffuse * side, sums.specular * side, lobe, sums.outline2);
}

// Of an ellipse over the plane through `position` with that unit normal, world space.
fn ltc_ellipse_heights(ellipse: ltc_Ellipse, position: vec3f, normal: vec3f) -> ltc_Heights {
  let middle = dot(normal, ellipse.center - position);
  let u = dot(normal, ellipse.half_u);
  let v = dot(normal, ellipse.half_v);
  let reach = sqrt(u * u + v * v);
  var heights: ltc_Heights;
  heights.low = middle - reach;
  heights.high = middle + reach;
  return heights;
}

// The integral over an ellipse as a surface sees it; see surface_polygon_integral.
fn ltc_surface_ellipse_integral(s: ltc_Surface, ellipse: ltc_Ellipse) -> ltc_LightIntegral {
  var heights = ltc_no_heights();
  var cut = false;
  if (s.tilted) {
    heights = ltc_ellipse_heights(ellipse, s.position, s.geometric);
    cut = heights.low < 0.0;
  }
  var integral = ltc_integrate_ellipse_part(ellipse, s.position, s.frame, s.fitted.lobe,
                                            ltc_front_shading(s), cut);
  if (cut) {
    integral = ltc_unless_hidden(s, heights, integral);
  }
  return ltc_unless_in_plane(s, ellipse.center, ltc_ellipse_normal(ellipse), integral);
}

// Light that a surface reflects of an ellipse of radiance 1, without shadow.
fn ltc_shade_ellipse_parts(s: ltc_Surface, ellipse: ltc_Ellipse) -> ltc_ShadedLight {
  return ltc_shade_integral(s, ltc_surface_ellipse_integral(s, ellipse));
}

// Light that a surface reflects of it, for radiance 1 and without shadow: shade_ellipse_parts, both together.
fn ltc_shade_ellipse(s: ltc_Surface, ellipse: ltc_Ellipse) -> vec3f {
  return ltc_both_parts(ltc_shade_ellipse_parts(s, ellipse));
}

// ---- sphere -------------------------------------------------------------------------------------
//
// The integral of a lobe over a sphere, exact, clipped to both horizons: the cone of directions that
// touch it is that of a disk. See cone.glsl.

// A sphere, which emits outwards.
struct ltc_Sphere {
  center: vec3f, // world space
  radius: f32,   // metres
}

// Semi-axes of a disk around p that fills the same directions as the sphere of that radius around
// p, |p| > radius: its radius is |p| tan s with sin s = radius / |p|.
fn ltc_tangent_disk_radius(distance2: f32, radius: f32) -> f32 {
  // tan^2 = sin^2 / (1 - sin^2); the difference is formed of lengths so that it does not cancel.
  let distance = sqrt(distance2);
  let leg2 = max((distance - radius) * (distance + radius), 1.0e-12 * distance2);
  return distance * radius * inverseSqrt(max(leg2, ltc_k_tiny));
}

// integrate_sphere; where `cut`, over what is in front of the plane with unit normal `front` (shading
// space).
fn ltc_integrate_sphere_part(sphere: ltc_Sphere, position: vec3f, frame: ltc_Frame,
                             lobe: ltc_Lobe, front: vec3f, cut: bool) -> ltc_LightIntegral {
  let center = ltc_to_shading(frame, sphere.center - position);
  let distance2 = dot(center, center);
  let axis = center * inverseSqrt(max(distance2, ltc_k_tiny));
  let radius = ltc_tangent_disk_radius(distance2, sphere.radius);
  var u = ltc_any_perpendicular(axis);
  let v = cross(axis, u) * radius;
  u = u * radius;
  let sums = ltc_sum_ellipse_cone(center, u, v, lobe, front, cut);
  // Below the horizon it gives nothing, rounding or not.
  let seen = distance2 > sphere.radius * sphere.radius && center.z + sphere.radius > 0.0;
  let outside = select(0.0, 1.0, seen);
  return ltc_light_integral(sums.diffuse * outside, sums.specular * outside, lobe, sums.outline2);
}

// Of a sphere over the plane through `position` with that unit normal, world space.
fn ltc_sphere_heights(sphere: ltc_Sphere, position: vec3f, normal: vec3f) -> ltc_Heights {
  let middle = dot(normal, sphere.center - position);
  var heights: ltc_Heights;
  heights.low = middle - sphere.radius;
  heights.high = middle + sphere.radius;
  return heights;
}

// The integral over a sphere as a surface sees it; see surface_polygon_integral.
fn ltc_surface_sphere_integral(s: ltc_Surface, sphere: ltc_Sphere) -> ltc_LightIntegral {
  var heights = ltc_no_heights();
  var cut = false;
  if (s.tilted) {
    heights = ltc_sphere_heights(sphere, s.position, s.geometric);
    cut = heights.low < 0.0;
  }
  let integral = ltc_integrate_sphere_part(sphere, s.position, s.frame, s.fitted.lobe,
                                           ltc_front_shading(s), cut);
  if (cut) {
    return ltc_unless_hidden(s, heights, integral);
  }
  return integral;
}

// Light that a surface reflects of a sphere of radiance 1, without shadow.
fn ltc_shade_sphere_parts(s: ltc_Surface, sphere: ltc_Sphere) -> ltc_ShadedLight {
  return ltc_shade_integral(s, ltc_surface_sphere_integral(s, sphere));
}

// Light that a surface reflects of it, for radiance 1 and without shadow: shade_sphere_parts, both together.
fn ltc_shade_sphere(s: ltc_Surface, sphere: ltc_Sphere) -> vec3f {
  return ltc_both_parts(ltc_shade_sphere_parts(s, sphere));
}

// ---- line ---------------------------------------------------------------------------------------
//
// The integral of a lobe over a straight line of vanishing width, exact, clipped to both horizons.
//
// Source: Heitz and Hill 2017, "Real-Time Line- and Disk-Light Shading with Linearly Transformed
// Cosines": the integral of the cosine along a line, and the width that M^-1 gives it. Clipped here
// to the surface's horizon too, and kept as a vector for the mean direction.
//
// With f the foot of the perpendicular from the point to the line, at distance d, t the line's
// direction and b the angle from f, a strip of width w around the line has
//   2 pi times its vector irradiance = (w/d) ( f/d [b + sin b cos b] + t [sin^2 b] ),
// the brackets taken between its ends. M^-1 turns the width across the line of sight by
// det |p x q| / |p_o x q_o| for any two points p, q of the line: areas of triangles with the origin
// change by the cofactors of M^-1, volumes by its determinant.

// A straight line without a width; see the intensity per metre of openltc::Line.
struct ltc_Line {
  from_: vec3f, // one end, world space
  to: vec3f,    // the other
}

// 2 pi times the vector irradiance of the strip of width 1 around the segment from p to q, seen
// from the origin.
fn ltc_line_term(p: vec3f, q: vec3f) -> vec3f {
  let axis = q - p;
  let length2 = max(dot(axis, axis), ltc_k_tiny);
  let t = axis * inverseSqrt(length2);
  let from_ = dot(p, t);
  let to = dot(q, t);
  let foot = p - t * from_;
  // The point on the line itself sees it end-on.
  let d2 = max(dot(foot, foot), 1.0e-12 * (dot(p, p) + dot(q, q)) + ltc_k_tiny);
  let inv_d = inverseSqrt(d2);
  let d = d2 * inv_d;
  let from_r2 = d2 + from_ * from_;
  let to_r2 = d2 + to * to;
  let angle = ltc_angle_of(d2 + from_ * to, d * (to - from_));
  let along = to * to / to_r2 - from_ * from_ / from_r2;
  let across = angle + to * d / to_r2 - from_ * d / from_r2;
  return (foot * (inv_d * across) + t * along) * inv_d;
}

// The same of a segment in cosine space, clipped to both horizons; see clip_edge.
fn ltc_clipped_line_term(a_o: vec3f, b_o: vec3f, a_z: f32, b_z: f32) -> vec3f {
  let edge = ltc_clip_edge(a_o, b_o, a_z, b_z);
  return select(ltc_line_term(edge.p0, edge.p1), vec3f(0.0, 0.0, 0.0), edge.outside);
}

// 2 pi times the vector irradiance of a strip of width 1 in shading space around the segment from a
// to b, also shading space, in the space that `lobe` leads to.
fn ltc_sum_line(a: vec3f, b: vec3f, lobe: ltc_Lobe) -> vec3f {
  let a_o = ltc_to_cosine(lobe, a);
  let b_o = ltc_to_cosine(lobe, b);
  let triangle = cross(a, b - a);
  let triangle_o = cross(a_o, b_o - a_o);
  let ratio2 = dot(triangle, triangle) / max(dot(triangle_o, triangle_o), ltc_k_tiny);
  return ltc_clipped_line_term(a_o, b_o, a.z, b.z) * (lobe.det * sqrt(ratio2));
}

// Integrals over the segment from a to b, shading space; see integrate_line.
fn ltc_integrate_segment(a: vec3f, b: vec3f, lobe: ltc_Lobe) -> ltc_LightIntegral {
  let diffuse = ltc_sum_line(a, b, ltc_cosine_lobe());
  let specular = ltc_sum_line(a, b, lobe);
  var result: ltc_LightIntegral;
  result.diffuse = min(max(diffuse.z * ltc_k_half_inv_pi, 0.0), 1.0e15);
  result.specular = min(max(specular.z * ltc_k_half_inv_pi, 0.0), 1.0e15);
  result.diffuse_direction = ltc_safe_direction(diffuse);
  result.specular_direction = ltc_safe_direction(ltc_from_cosine(lobe, ltc_safe_direction(specular)));
  result.second = 0.0;
  result.concentration = 0.0; // it has none; see segment_ratio
  return result;
}

// Integrals over a line seen from `position` (world space), per metre of its width: without an
// upper bound.
fn ltc_integrate_line(line: ltc_Line, position: vec3f, frame: ltc_Frame,
                      lobe: ltc_Lobe) -> ltc_LightIntegral {
  return ltc_integrate_segment(ltc_to_shading(frame, line.from_ - position),
                               ltc_to_shading(frame, line.to - position), lobe);
}

// The same over what is in front of the plane with unit normal `front` (shading space).
fn ltc_integrate_line_in_front(line: ltc_Line, position: vec3f, frame: ltc_Frame, lobe: ltc_Lobe,
                               front: vec3f) -> ltc_LightIntegral {
  let part = ltc_segment_in_front(ltc_to_shading(frame, line.from_ - position),
                                  ltc_to_shading(frame, line.to - position), front);
  var integral = ltc_integrate_segment(part.a, part.b, lobe);
  integral.diffuse = select(0.0, integral.diffuse, part.some);
  integral.specular = select(0.0, integral.specular, part.some);
  return integral;
}

// Of a line over the plane through `position` with that unit normal, world space.
fn ltc_line_heights(line: ltc_Line, position: vec3f, normal: vec3f) -> ltc_Heights {
  let from_ = dot(normal, line.from_ - position);
  let to = dot(normal, line.to - position);
  var heights: ltc_Heights;
  heights.low = min(from_, to);
  heights.high = max(from_, to);
  return heights;
}

// The integral over a line as a surface sees it; see surface_polygon_integral.
fn ltc_surface_line_integral(s: ltc_Surface, line: ltc_Line) -> ltc_LightIntegral {
  var heights = ltc_no_heights();
  var cut = false;
  if (s.tilted) {
    heights = ltc_line_heights(line, s.position, s.geometric);
    cut = heights.low < 0.0;
  }
  if (!cut) {
    let integral = ltc_integrate_line(line, s.position, s.frame, s.fitted.lobe);
    return integral;
  }
  let integral = ltc_integrate_line_in_front(line, s.position, s.frame, s.fitted.lobe,
                                             ltc_front_shading(s));
  return ltc_unless_hidden(s, heights, integral);
}

// Pieces into which the ratio to the BRDF divides a segment.
const ltc_k_line_pieces: i32 = 6;

// Means over a segment, weighted by the lobe.
struct ltc_SegmentRatio {
  scale: f32,  // of blended_ratio
  bias: f32,   // of blended_ratio times Schlick's weight
  direct: f32, // Schlick's weight in the mean direction of the whole segment
}

// blended_ratio of a long light: a mean over pieces that span equal angles in cosine space, each taken in
// its own mean direction. a, b: its ends, shading space; w: see blended_ratio.
//
// A long light has no one direction, least of all one low over the horizon, where the BRDF vanishes and
// the lobe does not. The weights are line_term's, whose angles are steps of a rotation.
fn ltc_segment_ratio(s: ltc_Surface, lobe: ltc_Lobe, a: vec3f, b: vec3f,
                     w: f32) -> ltc_SegmentRatio {
  let edge = ltc_clip_edge(ltc_to_cosine(lobe, a), ltc_to_cosine(lobe, b), a.z, b.z);
  let t = ltc_safe_direction(edge.p1 - edge.p0);
  let from_ = dot(edge.p0, t);
  let to = dot(edge.p1, t);
  let foot = edge.p0 - t * from_;
  let d2 = max(dot(foot, foot),
               1.0e-12 * (dot(edge.p0, edge.p0) + dot(edge.p1, edge.p1)) + ltc_k_tiny);
  let inv_d = inverseSqrt(d2);
  let d = d2 * inv_d;
  let f = foot * inv_d;
  let step = ltc_angle_of(d2 + from_ * to, d * (to - from_)) * (1.0 / f32(ltc_k_line_pieces));
  let step_cos = cos(step);
  let step_sin = sin(step);
  let inv_r = inverseSqrt(d2 + from_ * from_);
  var c = d * inv_r;
  var n = from_ * inv_r;
  var total = ltc_k_tiny;
  var mean: ltc_SegmentRatio;
  mean.scale = 0.0;
  mean.bias = 0.0;
  var all = vec3f(0.0, 0.0, 0.0);
  for (var i = 0; i < ltc_k_line_pieces; i++) {
    let next_c = c * step_cos - n * step_sin;
    let next_n = n * step_cos + c * step_sin;
    let sum = f * (step + next_n * next_c - n * c) + t * (next_n * next_n - n * n);
    let weight = max(sum.z, 0.0);
    let wi = ltc_safe_direction(ltc_from_cosine(lobe, sum));
    let part = weight * ltc_blended_ratio(s, wi, w);
    mean.scale = mean.scale + part;
    mean.bias = mean.bias + part * ltc_fresnel_weight(s.wo, wi);
    total = total + weight;
    all = all + sum;
    c = next_c;
    n = next_n;
  }
  let inv_total = select(1.0 / total, 0.0, edge.outside);
  mean.scale = mean.scale * inv_total;
  mean.bias = mean.bias * inv_total;
  mean.direct = ltc_fresnel_weight(s.wo, ltc_safe_direction(ltc_from_cosine(lobe, all)));
  return mean;
}

// Specular light of a line from a to b, shading space, of which the lobes have these shares. Each lobe is
// divided by itself, against the density of both: the balance heuristic of importance sampling.
fn ltc_segment_reflectance(s: ltc_Surface, a: vec3f, b: vec3f, first: f32) -> vec3f {
  let ratio = ltc_segment_ratio(s, s.fitted.lobe, a, b, 1.0);
  let scale = ratio.scale * first;
  let bias = ratio.bias * first;
  return (s.f0 * scale + (s.f90 - s.f0) * bias) * s.fitted.n1;
}

// Reflected light of a light of no width, whose integral is per metre of it and has no upper bound.
fn ltc_shade_line_integral(s: ltc_Surface, line: ltc_Line,
                           integral: ltc_LightIntegral) -> ltc_ShadedLight {
  let first = s.inv_share * integral.specular;
  let second = s.second_inv_share * integral.second;
  var shaded: ltc_ShadedLight;
  shaded.diffuse = s.diffuse * integral.diffuse;
  if (s.corrected) {
    shaded.specular = ltc_segment_reflectance(s, ltc_to_shading(s.frame, line.from_ - s.position),
                                              ltc_to_shading(s.frame, line.to - s.position), first);
  } else {
    let fresnel = s.f0 + (s.f90 - s.f0) * ltc_fresnel_weight(s.wo, integral.specular_direction);
    shaded.specular = fresnel * (s.fitted.n1 * (first + second));
  }
  return shaded;
}

// Light that a surface reflects of a line of 1 cd/m, without shadow.
fn ltc_shade_line_parts(s: ltc_Surface, line: ltc_Line) -> ltc_ShadedLight {
  return ltc_shade_line_integral(s, line, ltc_surface_line_integral(s, line));
}

// Light that a surface reflects of it, for radiance 1 and without shadow: shade_line_parts, both together.
fn ltc_shade_line(s: ltc_Surface, line: ltc_Line) -> vec3f {
  return ltc_both_parts(ltc_shade_line_parts(s, line));
}

// ---- tube ---------------------------------------------------------------------------------------
//
// The integral of a lobe over a round tube: a cylinder, open or closed, or a capsule. Exact, clipped
// to both horizons.
//
// From outside, a closed tube is convex, and its outline is made of two straight edges, where planes
// through the point touch the whole length, and of an arc around each end: of the end's disk, or of
// the sphere that rounds it off. Under M^-1 planes stay planes and cones stay elliptic cones
// (cone.glsl), so the outline keeps its form, and the integral is the sum of two edges and two arcs.
// An open tube shows its lateral surface alone: at an end whose disk one would look into, the near
// half of the rim bounds it instead of the far one.
//
// In shading space, with u the axis, w the unit vector from the point to the axis' line at distance
// h, and v = u x w, the touching planes have the normals g = -sin a w +- cos a v, sin a = radius / h,
// and touch the ends at their centres + radius g, disks and spheres alike.

// A round tube along a straight axis, which emits outwards.
struct ltc_Tube {
  from_: vec3f, // ends of the axis, world space
  to: vec3f,    // the other end
  radius: f32,  // metres
  caps: f32,    // 0: none, the lateral surface alone; 1: flat; 2: round, a capsule
}

// Whether its ends are closed.
fn ltc_has_caps(tube: ltc_Tube) -> bool { return tube.caps > 0.5; }

// Whether its ends are hemispheres.
fn ltc_has_round_caps(tube: ltc_Tube) -> bool { return tube.caps > 1.5; }

// A tube around the origin of shading space.
struct ltc_TubeView {
  from_: vec3f, // one end of the axis
  to: vec3f,    // the other
  axis: vec3f,  // unit
  w: vec3f,     // unit, from the origin to the axis' line
  v: vec3f,     // axis x w
  height: f32,  // distance to the axis' line
  left: vec3f,  // radius times the normal of one touching plane
  right: vec3f, // and of the other
  beside: bool, // outside of the infinite cylinder
}

// A tube as `position`, world space, sees it.
fn ltc_tube_view(tube: ltc_Tube, position: vec3f, frame: ltc_Frame) -> ltc_TubeView {
  var view: ltc_TubeView;
  view.from_ = ltc_to_shading(frame, tube.from_ - position);
  view.to = ltc_to_shading(frame, tube.to - position);
  view.axis = ltc_safe_direction(view.to - view.from_);
  let foot = view.from_ - view.axis * dot(view.from_, view.axis);
  let height2 = dot(foot, foot);
  let on_axis = height2 <= 1.0e-12 * dot(view.from_, view.from_) + ltc_k_tiny;
  view.w = select(foot * inverseSqrt(max(height2, ltc_k_tiny)), ltc_any_perpendicular(view.axis),
                  on_axis);
  view.v = cross(view.axis, view.w);
  view.height = sqrt(height2);
  view.beside = view.height > tube.radius && !on_axis;
  let sine = min(tube.radius / max(view.height, ltc_k_tiny), 1.0);
  let cosine = sqrt(max((1.0 - sine) * (1.0 + sine), 0.0));
  view.left = (view.v * cosine - view.w * sine) * tube.radius;
  view.right = (-(view.v * cosine) - view.w * sine) * tube.radius;
  return view;
}

// Which part of the outline of an end's cone bounds the tube.
struct ltc_TubeEnd {
  cone: ltc_Cone,       // of directions to the end, cosine space
  part: ltc_Arc,        // of its outline
  sign: f32,            // -1: followed clockwise, 0: not at all
  left: vec3f,          // where it meets the edges, on the cone, unit, cosine space
  right: vec3f,         // and where it meets the other one
  left_touched: vec3f,  // where the planes through the point touch it there, cosine space
  right_touched: vec3f, // and on the other side
}

// No end: sign 0.
fn ltc_no_tube_end() -> ltc_TubeEnd {
  let none = vec3f(0.0, 0.0, 0.0);
  var end: ltc_TubeEnd;
  end.cone.e1 = none;
  end.cone.e2 = none;
  end.cone.e3 = none;
  end.cone.k1 = 0.0;
  end.cone.k2 = 0.0;
  end.cone.c1 = 1.0;
  end.cone.c2 = 1.0;
  end.part.start = 0.0;
  end.part.extent = 0.0;
  end.sign = 0.0;
  end.left = none;
  end.right = none;
  end.left_touched = none;
  end.right_touched = none;
  return end;
}

// The same end with left and right exchanged: as the outline comes by on its way back.
fn ltc_turned_end(end: ltc_TubeEnd) -> ltc_TubeEnd {
  var turned = end;
  turned.left = end.right;
  turned.right = end.left;
  turned.left_touched = end.right_touched;
  turned.right_touched = end.left_touched;
  return turned;
}

// One end. `center`, `away`: its centre and the unit direction out of it along the axis, shading
// space; `first`: whether it is the one at Tube.from, through which the outline runs from right to
// left; `whole`: whether this end is what points that are not beside the tube see.
fn ltc_tube_end(tube: ltc_Tube, view: ltc_TubeView, center: vec3f, away: vec3f, first: bool,
                whole: bool, lobe: ltc_Lobe) -> ltc_TubeEnd {
  let round = ltc_has_round_caps(tube);
  let distance2 = dot(center, center);
  let direction = center * inverseSqrt(max(distance2, ltc_k_tiny));
  let u = ltc_any_perpendicular(direction);
  let radius = select(tube.radius, ltc_tangent_disk_radius(distance2, tube.radius), round);
  let a = select(view.w, u, round) * radius;
  let b = select(view.v, cross(direction, u), round) * radius;
  var result: ltc_TubeEnd;
  result.cone = ltc_make_cone(ltc_to_cosine(lobe, center), ltc_to_cosine(lobe, a),
                              ltc_to_cosine(lobe, b));
  result.left_touched = ltc_to_cosine(lobe, center + view.left);
  result.right_touched = ltc_to_cosine(lobe, center + view.right);
  let left = ltc_outline_parameter(result.cone, result.left_touched);
  let right = ltc_outline_parameter(result.cone, result.right_touched);
  result.left = ltc_cone_direction(result.cone, left);
  result.right = ltc_cone_direction(result.cone, right);
  // An open end that one looks into: the other arc, backwards.
  let into = !ltc_has_caps(tube) && dot(center, away) < 0.0;
  let forth = ltc_wrapped_turn(select(right - left, left - right, first));
  let back = ltc_wrapped_turn(select(left - right, right - left, first));
  let begin = select(left, right, first);
  let end = select(right, left, first);
  result.part.start = select(begin, end, into);
  result.part.extent = select(2.0 * ltc_k_pi, select(forth, back, into), view.beside);
  result.sign = select(select(0.0, 1.0, whole), select(1.0, -1.0, into), view.beside);
  return result;
}

// Area of half of an end of a thin tube, which bulges out beyond the strip around its axis, at a right angle to
// the view; less than 0 for an open end that one looks into. `facing`: the cosine between its direction and that
// out of it along the axis.
fn ltc_thin_end_area(tube: ltc_Tube, facing: f32) -> f32 {
  let into = !ltc_has_caps(tube) && facing < 0.0;
  return 0.5 * ltc_k_pi * tube.radius * tube.radius *
         select(abs(facing), 1.0, ltc_has_round_caps(tube)) * select(1.0, -1.0, into);
}

// 2 pi times the vector irradiance of that, as a small light (density times solid angle: docs/method.md,
// section 9).
fn ltc_thin_end_term(tube: ltc_Tube, center: vec3f, away: vec3f, lobe: ltc_Lobe) -> vec3f {
  let distance2 = max(dot(center, center), ltc_k_tiny);
  let distance = sqrt(distance2);
  let area = ltc_thin_end_area(tube, dot(center, away) / distance);
  // Solid angle area / r^2, in cosine space det / |M^-1 w|^3 times that, w = center / r.
  let o = ltc_to_cosine(lobe, center);
  let inv_o = inverseSqrt(max(dot(o, o), ltc_k_tiny));
  let solid_angle_o = area * lobe.det * (distance * inv_o) * (inv_o * inv_o);
  let above = center.z > 0.0 && o.z > 0.0;
  return select(vec3f(0.0, 0.0, 0.0), o * (2.0 * solid_angle_o * inv_o), above);
}

// Angular radius of a tube in the space that `lobe` leads to, at most, where it is closest.
fn ltc_tube_thickness(tube: ltc_Tube, view: ltc_TubeView, lobe: ltc_Lobe) -> f32 {
  let a = ltc_to_cosine(lobe, view.from_);
  let d = ltc_to_cosine(lobe, view.to) - a;
  let t = min(max(-dot(a, d) / max(dot(d, d), ltc_k_tiny), 0.0), 1.0);
  let nearest = a + d * t;
  return tube.radius * sqrt(ltc_lobe_stretch2(lobe) / max(dot(nearest, nearest), ltc_k_tiny));
}

// Whether a point that is not beside the tube is in front of its closed end at `center`, shading space: that lies
// `along` metres ahead, on the way into the tube.
fn ltc_sees_end(tube: ltc_Tube, center: vec3f, along: f32) -> bool {
  return along > 0.0 && ltc_has_caps(tube) &&
         (!ltc_has_round_caps(tube) || dot(center, center) > tube.radius * tube.radius);
}

// Both ends of a tube.
struct ltc_TubeEnds {
  first: ltc_TubeEnd,  // at Tube.from
  second: ltc_TubeEnd, // at Tube.to
}

// Those of a tube in the space that `lobe` leads to; see_from, see_to: see tube_end's `whole`.
fn ltc_tube_ends(tube: ltc_Tube, view: ltc_TubeView, see_from: bool, see_to: bool,
                 lobe: ltc_Lobe) -> ltc_TubeEnds {
  var ends: ltc_TubeEnds;
  ends.second = ltc_no_tube_end();
  for (var i = 0; i < 2; i++) {
    let first = i == 0;
    ends.first = ends.second;
    ends.second = ltc_tube_end(tube, view, select(view.to, view.from_, first),
                               select(view.axis, -view.axis, first), first,
                               select(see_to, see_from, first), lobe);
  }
  return ends;
}

// One end after the other, along the outline: that one first, and left what was right.
fn ltc_turned_ends(ends: ltc_TubeEnds) -> ltc_TubeEnds {
  var turned: ltc_TubeEnds;
  turned.first = ltc_turned_end(ends.second);
  turned.second = ltc_turned_end(ends.first);
  return turned;
}

// Some point where the outline crosses the plane with unit normal `front`, if it does. inside: a point within the
// end that one sees who is not beside the tube; beside: 1 or 0.
fn ltc_tube_crossing(ends: ltc_TubeEnds, beside: bool, inside: vec3f, front: vec3f) -> vec3f {
  var now = ends;
  var q = select(inside, ends.first.left, beside);
  for (var i = 0; i < 2; i++) {
    q = select(q, ltc_arc_crossing(now.first.cone, now.first.part, front, q), now.first.sign != 0.0);
    now = ltc_turned_ends(now);
  }
  for (var j = 0; j < 2; j++) {
    q = select(q, ltc_edge_crossing(now.first.left, now.second.left, front, q), beside);
    now = ltc_turned_ends(now);
  }
  return q;
}

// Vector irradiance times 2 pi of a tube in the space that `lobe` leads to, by its outline; where
// `cut`, of its part in front of the plane with unit normal `front` (that space).
fn ltc_sum_tube_outline(tube: ltc_Tube, view: ltc_TubeView, lobe: ltc_Lobe, front: vec3f,
                        cut: bool) -> vec3f {
  // Not beside the tube: in front of one of its ends.
  let see_from = ltc_sees_end(tube, view.from_, dot(view.from_, view.axis));
  let see_to = ltc_sees_end(tube, view.to, -dot(view.to, view.axis));
  var ends = ltc_tube_ends(tube, view, see_from, see_to, lobe);
  let edges = select(0.0, 1.0, view.beside);
  let up = ltc_horizon_normal_cosine(lobe);
  var whole = ltc_cone_is_above(ends.first.cone, up) && ltc_cone_is_above(ends.second.cone, up);
  if (cut) {
    whole = whole && ltc_cone_is_above(ends.first.cone, front) &&
            ltc_cone_is_above(ends.second.cone, front);
  }
  // The apex is on the side where the y axis comes closest to the tube's line: if it meets the tube,
  // it does so around there. A point that is not beside the tube sees one end alone.
  let along = -(view.from_.x * view.axis.x + view.from_.z * view.axis.z) /
              max(view.axis.x * view.axis.x + view.axis.z * view.axis.z, 1.0e-12);
  let inside = select(ends.second.cone.e3, ends.first.cone.e3, see_from);
  let y = select(inside.y, view.from_.y + view.axis.y * along, view.beside);
  let s = select(1.0, -1.0, y < 0.0);
  // Uniform shortcut: no lane needs to clip.
  let clip = !whole;
  var q = inside;
  if (cut) {
    if (clip) {
      q = ltc_tube_crossing(ends, view.beside, inside, front);
    }
  }
  var all = vec3f(0.0, 0.0, 0.0);
  var clipped = all;
  // The edge from one end to the other and the arc around the one, then back again.
  for (var i = 0; i < 2; i++) {
    var a = ends.first.left_touched;
    var b = ends.second.left_touched;
    all = all + ltc_edge_term(a, b, b - a) * edges +
          ltc_arc_term(ends.first.cone, ends.first.part) * ends.first.sign;
    if (clip) {
      // Between the very points where the arcs end, so that all is one closed outline.
      a = ends.first.left;
      b = ends.second.left;
      if (cut) {
        clipped = clipped + ltc_edge_in_front(a, b, q, up, front, s) * edges +
                  ltc_arc_in_front(ends.first.cone, ends.first.part, q, up, front, s) *
                  ends.first.sign;
      } else {
        clipped = clipped + ltc_closed_edge_term(a, b, dot(up, a), dot(up, b), s) * edges +
                  ltc_clipped_arc_term(ends.first.cone, ends.first.part, up, s) * ends.first.sign;
      }
    }
    ends = ltc_turned_ends(ends);
  }
  return select(clipped, all, whole);
}

// light_concentration's outline2 of a tube, whose length segment_ratio sees to: of the two points that
// are across from each other where it is nearest.
fn ltc_tube_outline2(tube: ltc_Tube, view: ltc_TubeView, lobe: ltc_Lobe) -> f32 {
  let a = ltc_to_cosine(lobe, view.from_);
  let d = ltc_to_cosine(lobe, view.to) - a;
  let t = min(max(-dot(a, d) / max(dot(d, d), ltc_k_tiny), 0.0), 1.0);
  let nearest = a + d * t;
  let across = ltc_to_cosine(lobe, view.v) * tube.radius;
  let distance2 = dot(nearest, nearest);
  return distance2 / max(distance2 + dot(across, across), ltc_k_tiny);
}

// Angular radius below which a tube is its strip and ends alone.
const ltc_k_wholly_thin: f32 = 0.004;

// 1 over how much more it takes to be its outline alone, from 0.008 on.
const ltc_k_inv_thin_range: f32 = 250.0;

// k_wholly_thin where a plane cuts the tube.
const ltc_k_wholly_thin_cut: f32 = 0.0005;

// And k_inv_thin_range there: its outline alone from 0.001 on.
const ltc_k_inv_thin_range_cut: f32 = 2000.0;

// The same for tubes of any thickness.
//
// The two edges of a thin tube nearly cancel, of which rounding makes 1e-7 over its angular radius.
// So from a hundredth downwards it is handed over, without a step, to the strip around its axis and
// the halves of its ends, which is wrong by the square of that radius. `heights`: over the plane with
// unit normal `front` (shading space); where that cuts it, `cut`, the strip would vanish all at once,
// and the outline, though less exact, serves for thinner ones.
fn ltc_sum_tube(tube: ltc_Tube, view: ltc_TubeView, lobe: ltc_Lobe, front: vec3f,
                heights: ltc_Heights, cut: bool) -> vec3f {
  let thickness = ltc_tube_thickness(tube, view, lobe);
  var exact = min(max((thickness - ltc_k_wholly_thin) * ltc_k_inv_thin_range, 0.0), 1.0);
  var from_ = view.from_;
  var to = view.to;
  var from_seen = true;
  var to_seen = from_seen;
  var strip_seen = from_seen;
  if (cut) {
    let thinner = min(max((thickness - ltc_k_wholly_thin_cut) * ltc_k_inv_thin_range_cut, 0.0), 1.0);
    exact = select(exact, thinner, heights.low < 0.0 && heights.high > 0.0);
    let part = ltc_segment_in_front(from_, to, front);
    from_seen = dot(front, from_) > 0.0;
    to_seen = dot(front, to) > 0.0;
    strip_seen = part.some;
    from_ = part.a;
    to = part.b;
  }
  var sum = vec3f(0.0, 0.0, 0.0);
  // Uniform shortcuts: no lane has one form or the other.
  if (exact > 0.0) {
    sum = ltc_sum_tube_outline(tube, view, lobe, ltc_plane_normal_cosine(lobe, front), cut) * exact;
  }
  if (exact < 1.0) {
    let none = vec3f(0.0, 0.0, 0.0);
    let thin = select(none, ltc_sum_line(from_, to, lobe) * (2.0 * tube.radius), strip_seen) +
               select(none, ltc_thin_end_term(tube, view.from_, -view.axis, lobe), from_seen) +
               select(none, ltc_thin_end_term(tube, view.to, view.axis, lobe), to_seen);
    sum = sum + select(none, thin * (1.0 - exact), exact < 1.0);
  }
  return sum;
}

// Of a tube over the plane through `position` with that unit normal, world space.
fn ltc_tube_heights(tube: ltc_Tube, position: vec3f, normal: vec3f) -> ltc_Heights {
  let from_ = dot(normal, tube.from_ - position);
  let to = dot(normal, tube.to - position);
  let axis = ltc_safe_direction(tube.to - tube.from_);
  let along = dot(normal, axis);
  let reach = tube.radius *
              select(sqrt(max(1.0 - along * along, 0.0)), 1.0, ltc_has_round_caps(tube));
  var heights: ltc_Heights;
  heights.low = min(from_, to) - reach;
  heights.high = max(from_, to) + reach;
  return heights;
}

// How far a plane lifts an end of a tube's axis, in radii: 0 where the tube stands out of it whole, 1 where it
// is below; the end is `height` over the plane.
fn ltc_lift_share(height: f32, radius: f32) -> f32 {
  let share = 0.5 * (radius - height) / max(radius, ltc_k_tiny);
  return min(max(share, 0.0), 1.0);
}

// 1 where a tube's highest point is above the horizon: below it gives nothing, rounding or not; else 0.
fn ltc_tube_seen_above(tube: ltc_Tube, view: ltc_TubeView) -> f32 {
  let reach = tube.radius *
              select(sqrt(max(1.0 - view.axis.z * view.axis.z, 0.0)), 1.0, ltc_has_round_caps(tube));
  return select(0.0, 1.0, max(view.from_.z, view.to.z) + reach > 0.0);
}

// integrate_tube; where `cut`, over what is in front of the plane with unit normal `front` (shading
// space), over which the tube has these heights.
fn ltc_integrate_tube_part(tube: ltc_Tube, position: vec3f, frame: ltc_Frame, lobe: ltc_Lobe,
                           front: vec3f, heights: ltc_Heights, cut: bool) -> ltc_LightIntegral {
  let view = ltc_tube_view(tube, position, frame);
  let seen = ltc_tube_seen_above(tube, view);
  var diffuse = vec3f(0.0, 0.0, 0.0);
  var specular = diffuse;
  var now = ltc_cosine_lobe();
  for (var i = 0; i < 2; i++) {
    diffuse = specular;
    specular = ltc_sum_tube(tube, view, now, front, heights, cut) * seen;
    now = lobe;
  }
  return ltc_light_integral(diffuse, specular, lobe, ltc_tube_outline2(tube, view, lobe));
}

// ---- tube surface -------------------------------------------------------------------------------
//
// A tube as a surface sees it, and the light that it reflects of it: of a long light neither the ratio to the
// BRDF nor Schlick's weight is that of one direction.

// The integral over a tube as a surface sees it; see surface_polygon_integral.
fn ltc_surface_tube_integral(s: ltc_Surface, tube: ltc_Tube) -> ltc_LightIntegral {
  var heights = ltc_no_heights();
  var cut = false;
  if (s.tilted) {
    heights = ltc_tube_heights(tube, s.position, s.geometric);
    cut = heights.low < 0.0;
  }
  let integral = ltc_integrate_tube_part(tube, s.position, s.frame, s.fitted.lobe,
                                         ltc_front_shading(s), heights, cut);
  if (cut) {
    return ltc_unless_hidden(s, heights, integral);
  }
  return integral;
}

// Radii by which a round end lengthens the segment that stands for a tube.
const ltc_k_round_reach: f32 = 0.7;

// An end of the segment that stands for a tube: in the middle of what stands out of the surface there, and
// over the lobe's own horizon, with unit normal `horizon`, for as long as some of the tube is.
fn ltc_segment_end(end: vec3f, horizon: vec3f, radius: f32) -> vec3f {
  var p = end;
  p.z = p.z + radius * ltc_lift_share(p.z, radius);
  let below = ltc_lift_share(dot(p, horizon), radius);
  return p + horizon * (radius * below * below * below);
}

// segment_ratio of that segment, whose ends, not yet lifted, are `from` and `to`, shading space.
fn ltc_tube_ratio(s: ltc_Surface, lobe: ltc_Lobe, from_: vec3f, to: vec3f, radius: f32,
                  w: f32) -> ltc_SegmentRatio {
  let horizon = ltc_safe_direction(vec3f(lobe.m20, 0.0, lobe.m22));
  return ltc_segment_ratio(s, lobe, ltc_segment_end(from_, horizon, radius),
                           ltc_segment_end(to, horizon, radius), w);
}

// What the light of a tube is multiplied by, and what Schlick's weight has beyond that in its mean direction.
struct ltc_TubeRatio {
  scale: f32,  // mean of blended_ratio
  beyond: f32, // see fresnel_weight
}

// Both by the pieces of its axis.
fn ltc_ratio_of_tube(s: ltc_Surface, tube: ltc_Tube, integral: ltc_LightIntegral,
                     share: f32) -> ltc_TubeRatio {
  let w = ltc_ratio_weight(integral, share);
  let axis = ltc_safe_direction(tube.to - tube.from_);
  let reach = select(0.0, ltc_k_round_reach * tube.radius, ltc_has_round_caps(tube));
  let from_ = ltc_to_shading(s.frame, tube.from_ - axis * reach - s.position);
  let to = ltc_to_shading(s.frame, tube.to + axis * reach - s.position);
  let ratio = ltc_tube_ratio(s, s.fitted.lobe, from_, to, tube.radius, w);
  let along = ratio.scale > 0.0;
  var result: ltc_TubeRatio;
  result.beyond = select(0.0, ratio.bias / max(ratio.scale, ltc_k_tiny) - ratio.direct, along);
  result.scale = select(1.0, ratio.scale, along);
  return result;
}

// Reflected light of a tube of radiance 1: shade_integral, but for the ratio to the BRDF, which is the
// mean along it, and so is what Schlick's weight has beyond that in the mean direction. Of that direction
// the outline tells more: the thicker the tube, the less its axis.
fn ltc_shade_tube_integral(s: ltc_Surface, tube: ltc_Tube,
                           integral: ltc_LightIntegral) -> ltc_ShadedLight {
  if (!s.corrected) {
    return ltc_shade_integral(s, integral);
  }
  let share = ltc_filled_share(s, integral);
  let ratio = ltc_ratio_of_tube(s, tube, integral, share);
  let weight = ltc_part_weight(s, integral.specular_direction, share) + ratio.beyond;
  return ltc_shade_filled(s, integral, weight, min(share * ratio.scale, 1.0));
}

// Light that a surface reflects of a tube of radiance 1, without shadow.
fn ltc_shade_tube_parts(s: ltc_Surface, tube: ltc_Tube) -> ltc_ShadedLight {
  return ltc_shade_tube_integral(s, tube, ltc_surface_tube_integral(s, tube));
}

// Light that a surface reflects of it, for radiance 1 and without shadow: shade_tube_parts, both together.
fn ltc_shade_tube(s: ltc_Surface, tube: ltc_Tube) -> vec3f {
  return ltc_both_parts(ltc_shade_tube_parts(s, tube));
}

// ---- emission -----------------------------------------------------------------------------------
//
// The emission of a light with a texture, as a lobe sees it: the texture's mean over the light,
// weighted by the lobe.
//
// Source: Heitz, Dupuy, Hill, Neubelt 2016, "Real-Time Polygonal-Light Shading with Linearly
// Transformed Cosines", section 5.2, approximates the weight by one Gaussian in the light's plane
// and looks up a texture that was convolved by it beforehand. That blurs what a stretched lobe
// keeps sharp, and knows no horizon. The weight is known, though: a point x of the light's plane,
// seen in cosine space at p = M^-1 x, has
//   K(x) = D(x/|x|) times solid angle per area = constant * max(0, p.z) / |p|^4,
// because M^-1 is linear and |p|^4 takes up both D's own fall-off and the plane's. So we integrate
// it: a few points, each with its own exact weight, and the texture prefiltered to the width of the
// point's cell, so that it need only be K that they resolve.
//
// The cells. m is where the mean direction of the light, the vector irradiance of its closed form,
// meets the plane. About m, |p|^2 grows by a square over a width that is one radian in cosine space:
// along a unit vector e of the plane, |p_m| over the part of M^-1 e at right angles to p_m. The axes
// are those of that quadratic form, with a little of the light's own rectangle added so that a
// round lobe divides a rectangle along its sides. Along each axis 1/(1 + y^2)^2, seen from the side,
// is (1 + y^2)^-3/2, whose integral is t = y / sqrt(1 + y^2): cells are equal steps of t between
// the light's ends.
//
// The prelude of each target gives the texture, the same for all lanes; see light/emission_stack.h:
//   Vec4 emission_texel(EmissionTexture, Vec2 uv, Real level)  trilinear, uv in [0, 1] over the
//                                     light's bounding rectangle: r g b times the light's share of
//                                     the place, and that share
//   Vec2 emission_texel_count(EmissionTexture)    columns and rows of level 0
//   Vec3 emission_corner, emission_axis_u, emission_axis_v(EmissionTexture)   that rectangle, world
//                                     space; unit axes at right angles
//   Vec2 emission_extent(EmissionTexture)         its sides in metres

// Cells along the narrow axis. 24 in all reach a third of the error of one look, 9 half of it; 96 an
// eighth.
const ltc_k_emission_narrow_cells: i32 = 4;

// And along the wide one.
const ltc_k_emission_wide_cells: i32 = 6;

// Texels of a level to a cell's side. The error is flat from 0.5 to 0.7: a texel stands for a
// Gaussian of 0.5 and the interpolation between texels.
const ltc_k_emission_texels_per_cell: f32 = 0.65;

// Share of the lobe's own axis in the direction of m. The vector irradiance weighs all of the light
// alike; a little of the axis draws m towards where the lobe is dense, and more loses lights that
// the axis misses.
const ltc_k_emission_axis_share: f32 = 0.25;

// Share of the light's rectangle in the form whose axes the cells follow.
const ltc_k_emission_rectangle_share: f32 = 0.5;

// 1 / (2 ln 2): half the binary logarithm, from the natural one.
const ltc_k_half_inv_ln2: f32 = 0.72134752044448170368;

// Integral variable t = y / sqrt(1 + y^2).
fn ltc_emission_step_from_width(y: f32) -> f32 { return y * inverseSqrt(1.0 + y * y); }

// Its inverse, y of t in (-1, 1).
fn ltc_emission_width_from_step(t: f32) -> f32 {
  return t * inverseSqrt(max(1.0 - t * t, 1.0e-10));
}

// Part of an axis that a cell takes, in metres from the middle of the kernel.
struct ltc_EmissionCell {
  center: f32,  // where its middle lies
  side: f32,    // length of the part that matters: no longer than its weight is
  measure: f32, // length per step of t, times the step
}

// Cell `cell` of `cells` that are even in t from `low` to `high`; `width`: metres for y = 1.
fn ltc_emission_cell(width: f32, low: f32, high: f32, cell: i32, cells: i32) -> ltc_EmissionCell {
  let step = (high - low) / f32(cells);
  let t0 = low + step * f32(cell);
  let t = t0 + step * 0.5;
  let inv_root = inverseSqrt(max(1.0 - t * t, 1.0e-10));
  var result: ltc_EmissionCell;
  result.center = width * ltc_emission_width_from_step(t);
  result.measure = width * step * inv_root * inv_root * inv_root;
  result.side = min(width *
                    (ltc_emission_width_from_step(t0 + step) - ltc_emission_width_from_step(t0)),
                    result.measure);
  return result;
}

// The part of a length that lies on a light.
struct ltc_EmissionOverlap {
  center: f32, // of the part
  share: f32,  // of the length, 0..1
}

// The part of [center - half_length, center + half_length] that lies in [0, end], metres.
fn ltc_emission_overlap(center: f32, half_length: f32, end: f32) -> ltc_EmissionOverlap {
  let low = min(max(center - half_length, 0.0), end);
  let high = min(max(center + half_length, 0.0), end);
  var result: ltc_EmissionOverlap;
  result.center = 0.5 * (low + high);
  result.share = (high - low) * 0.5 / max(half_length, ltc_k_tiny);
  return result;
}

// The share of a cell above a plane: `height` of its middle, `rise` from side to side.
fn ltc_emission_share_above(height: f32, rise: f32) -> f32 {
  return min(max(0.5 + height / max(rise, ltc_k_tiny), 0.0), 1.0);
}

// Mean of the texture over the light, weighted by `lobe` and clipped to both horizons, as seen
// from `position` (world space). `mean_direction` (shading space, unit) is that of the light's
// closed form for the same lobe: LightIntegral.diffuse_direction or specular_direction. It only
// places the cells. Times the light's radiance, this is what the lobe's integral is multiplied by.
// Where `cut`, the mean over what is in front of the plane with unit normal `front` (shading space).
fn ltc_emission_seen_part(emission: ltc_Quad, emission_picture: texture_2d<f32>,
                          emission_picture_sampler: sampler, position: vec3f, frame: ltc_Frame,
                          lobe: ltc_Lobe, mean_direction: vec3f, front: vec3f, cut: bool) -> vec3f {
  let extent = ltc_emission_extent(emission, emission_picture, emission_picture_sampler);
  let axis_u = ltc_to_shading(frame,
                              ltc_emission_axis_u(emission, emission_picture,
                                                  emission_picture_sampler));
  let axis_v = ltc_to_shading(frame,
                              ltc_emission_axis_v(emission, emission_picture,
                                                  emission_picture_sampler));
  let corner = ltc_to_shading(frame,
                              ltc_emission_corner(emission, emission_picture,
                                                  emission_picture_sampler) - position);

  // Where the mean direction meets the plane, within the light's rectangle; its middle where it
  // does not.
  var mean_cosine = ltc_safe_direction(ltc_to_cosine(lobe, mean_direction));
  mean_cosine.z = mean_cosine.z + ltc_k_emission_axis_share;
  let aim = ltc_safe_direction(ltc_from_cosine(lobe, mean_cosine));
  let normal = cross(axis_u, axis_v);
  let height = dot(corner, normal);
  let slope = dot(aim, normal);
  let meets = slope * height > 0.0 && abs(slope) > 1.0e-6;
  let on_plane = aim * (height / select(1.0, slope, meets)) - corner;
  let m_u = select(extent.x * 0.5, min(max(dot(on_plane, axis_u), 0.0), extent.x), meets);
  let m_v = select(extent.y * 0.5, min(max(dot(on_plane, axis_v), 0.0), extent.y), meets);
  let m = corner + axis_u * m_u + axis_v * m_v;

  // The quadratic form about m, in 1 / metre^2, and its axes.
  let m_cosine = ltc_to_cosine(lobe, m);
  let u_cosine = ltc_to_cosine(lobe, axis_u);
  let v_cosine = ltc_to_cosine(lobe, axis_v);
  let inv_m2 = 1.0 / max(dot(m_cosine, m_cosine), ltc_k_tiny);
  let along_u = dot(m_cosine, u_cosine) * inv_m2;
  let along_v = dot(m_cosine, v_cosine) * inv_m2;
  // No cell is narrower than a micrometre, which also keeps squares in range.
  var form_uu = dot(u_cosine, u_cosine) * inv_m2 - along_u * along_u;
  var form_vv = dot(v_cosine, v_cosine) * inv_m2 - along_v * along_v;
  var form_uv = dot(u_cosine, v_cosine) * inv_m2 - along_u * along_v;
  form_uu = min(max(form_uu, 1.0e-12), 1.0e12);
  form_vv = min(max(form_vv, 1.0e-12), 1.0e12);
  form_uv = min(max(form_uv, -1.0e12), 1.0e12);
  let half_difference = 0.5 * (form_uu - form_vv) +
                        0.5 * ltc_k_emission_rectangle_share *
                        (1.0 / max(extent.x * extent.x, 1.0e-12) -
                         1.0 / max(extent.y * extent.y, 1.0e-12));
  let cos_double = half_difference *
                   inverseSqrt(max(half_difference * half_difference + form_uv * form_uv,
                                   ltc_k_tiny));
  let c = sqrt(max(0.5 + 0.5 * cos_double, 0.0));
  var s = sqrt(max(0.5 - 0.5 * cos_double, 0.0));
  s = select(s, -s, form_uv < 0.0);
  let cross_form = 2.0 * c * s * form_uv;
  let narrow_width = inverseSqrt(max(c * c * form_uu + s * s * form_vv + cross_form, 1.0e-12));
  let wide_width = inverseSqrt(max(s * s * form_uu + c * c * form_vv - cross_form, 1.0e-12));

  // How far the light reaches from m along them.
  let middle_u = 0.5 * extent.x - m_u;
  let middle_v = 0.5 * extent.y - m_v;
  let narrow_middle = c * middle_u + s * middle_v;
  let narrow_reach = 0.5 * (c * extent.x + abs(s) * extent.y);
  let wide_middle = c * middle_v - s * middle_u;
  let wide_reach = 0.5 * (abs(s) * extent.x + c * extent.y);
  let narrow_low = ltc_emission_step_from_width((narrow_middle - narrow_reach) / narrow_width);
  let narrow_high = ltc_emission_step_from_width((narrow_middle + narrow_reach) / narrow_width);
  let wide_low = ltc_emission_step_from_width((wide_middle - wide_reach) / wide_width);
  let wide_high = ltc_emission_step_from_width((wide_middle + wide_reach) / wide_width);

  let count = ltc_emission_texel_count(emission, emission_picture, emission_picture_sampler);
  let inv_u = 1.0 / max(extent.x, ltc_k_tiny);
  let inv_v = 1.0 / max(extent.y, ltc_k_tiny);
  // Texels per cell, squared, over the cell's area; the level is half its logarithm.
  let density = ltc_k_emission_texels_per_cell * ltc_k_emission_texels_per_cell * count.x *
                count.y * inv_u * inv_v;
  let narrow_rise = abs(axis_u.z * c + axis_v.z * s);
  let wide_rise = abs(axis_v.z * c - axis_u.z * s);
  var narrow_front = 0.0;
  var wide_front = 0.0;
  if (cut) {
    let front_u = dot(front, axis_u);
    let front_v = dot(front, axis_v);
    narrow_front = abs(front_u * c + front_v * s);
    wide_front = abs(front_v * c - front_u * s);
  }
  let inv_m = sqrt(inv_m2);
  var sum = ltc_emission_texel(emission, emission_picture, emission_picture_sampler,
                               vec2f(0.5, 0.5), 99.0) * 1.0e-25;
  for (var i = 0; i < ltc_k_emission_narrow_cells; i++) {
    let narrow = ltc_emission_cell(narrow_width, narrow_low, narrow_high, i,
                                   ltc_k_emission_narrow_cells);
    for (var j = 0; j < ltc_k_emission_wide_cells; j++) {
      let wide = ltc_emission_cell(wide_width, wide_low, wide_high, j, ltc_k_emission_wide_cells);
      // The cell's box along the rectangle's sides, as far as it lies in the rectangle.
      let in_u = ltc_emission_overlap(m_u + c * narrow.center - s * wide.center,
                                      0.5 * (c * narrow.side + abs(s) * wide.side), extent.x);
      let in_v = ltc_emission_overlap(m_v + s * narrow.center + c * wide.center,
                                      0.5 * (abs(s) * narrow.side + c * wide.side), extent.y);
      // K there, and the share of the cell above the surface's horizon.
      let x = corner + axis_u * in_u.center + axis_v * in_v.center;
      let p = ltc_to_cosine(lobe, x) * inv_m;
      let inv_p2 = 1.0 / max(dot(p, p), ltc_k_tiny);
      var above = ltc_emission_share_above(x.z, narrow_rise * narrow.side + wide_rise * wide.side);
      if (cut) {
        above = above *
                ltc_emission_share_above(dot(front, x),
                                         narrow_front * narrow.side + wide_front * wide.side);
      }
      let weight = max(p.z, 0.0) * inv_p2 * inv_p2 * above * in_u.share * in_v.share *
                   narrow.measure * wide.measure;
      let level = ltc_k_half_inv_ln2 * log(max(density * narrow.side * wide.side, 1.0e-12));
      sum = sum +
            ltc_emission_texel(emission, emission_picture, emission_picture_sampler,
                               vec2f(in_u.center * inv_u, in_v.center * inv_v), level) * weight;
    }
  }
  let inv_share = 1.0 / max(sum.w, ltc_k_tiny);
  return vec3f(sum.x * inv_share, sum.y * inv_share, sum.z * inv_share);
}

// ---- polynomial surface -------------------------------------------------------------------------
//
// What you call: a point of a surface, once for all lights.

// A point with any reflectance. `normal`, on the viewer's side, and `view`, to the eye, are unit, world
// space; `albedo` is that of the diffuse part, `f0` and `f90` the specular reflectance at normal and
// grazing incidence, `roughness` 0..1.
fn ltc_surface_at(position: vec3f, normal: vec3f, view: vec3f, albedo: vec3f, f0: vec3f,
                  f90: vec3f, roughness: f32) -> ltc_Surface {
  let fitted = ltc_eval_lobe_polynomial(ltc_alpha_from_roughness(roughness), dot(normal, view));
  return ltc_make_surface(fitted, position, normal, view, albedo, f0, f90, roughness);
}

// ---- gltf surface -------------------------------------------------------------------------------
//
// A point of glTF 2.0's material model, and what may be added to a point.

// A point of a surface by glTF's metallic-roughness model; all values 0..1, colours linear.
fn ltc_gltf_surface(position: vec3f, normal: vec3f, view: vec3f, base_color: vec3f, metallic: f32,
                    roughness: f32) -> ltc_Surface {
  let dielectric = vec3f(0.04, 0.04, 0.04);
  let f0 = dielectric + (base_color - dielectric) * metallic;
  return ltc_surface_at(position, normal, view, base_color * (1.0 - metallic), f0,
                        vec3f(1.0, 1.0, 1.0), roughness);
}

// ---- lights -------------------------------------------------------------------------------------
//
// What you call: lights. Each function returns the light that a surface reflects of one of radiance 1,
// without shadow; shade_X_parts has its diffuse and its specular part apart.

// A rectangle or parallelogram: its middle, and from there to the middles of two sides. It emits along
// half_u x half_v, or to both sides where two_sided is 1.
fn ltc_make_quad(center: vec3f, half_u: vec3f, half_v: vec3f, two_sided: f32) -> ltc_Quad {
  var quad: ltc_Quad;
  quad.center = center;
  quad.half_u = half_u;
  quad.half_v = half_v;
  quad.two_sided = two_sided;
  return quad;
}

// A disk, which emits along its unit normal.
fn ltc_make_disk(center: vec3f, normal: vec3f, radius: f32, two_sided: f32) -> ltc_Ellipse {
  let u = ltc_any_perpendicular(normal);
  var disk: ltc_Ellipse;
  disk.center = center;
  disk.half_u = u * radius;
  disk.half_v = cross(normal, u) * radius;
  disk.two_sided = two_sided;
  return disk;
}

// An ellipse by its perpendicular semi-axes; it emits along half_u x half_v.
fn ltc_make_ellipse(center: vec3f, half_u: vec3f, half_v: vec3f, two_sided: f32) -> ltc_Ellipse {
  var ellipse: ltc_Ellipse;
  ellipse.center = center;
  ellipse.half_u = half_u;
  ellipse.half_v = half_v;
  ellipse.two_sided = two_sided;
  return ellipse;
}

// A sphere, which emits outwards.
fn ltc_make_sphere(center: vec3f, radius: f32) -> ltc_Sphere {
  var sphere: ltc_Sphere;
  sphere.center = center;
  sphere.radius = radius;
  return sphere;
}

// A tube between two points. caps: 0 for an open one, 1 for a cylinder with flat ends, 2 for a capsule.
fn ltc_make_tube(from_: vec3f, to: vec3f, radius: f32, caps: f32) -> ltc_Tube {
  var tube: ltc_Tube;
  tube.from_ = from_;
  tube.to = to;
  tube.radius = radius;
  tube.caps = caps;
  return tube;
}

// A line between two points, which has no width: instead of radiance 1, an intensity of 1 per metre
// across it.
fn ltc_make_line(from_: vec3f, to: vec3f) -> ltc_Line {
  var line: ltc_Line;
  line.from_ = from_;
  line.to = to;
  return line;
}

// ---- textured -----------------------------------------------------------------------------------
//
// A rectangle with a picture.

// Light that a surface reflects of a rectangle whose radiance is a picture, without shadow. The picture's
// mean is taken over the light as each part of the surface's reflection sees it. half_u and half_v are at
// right angles.
fn ltc_shade_textured_quad(s: ltc_Surface, quad: ltc_Quad, picture: texture_2d<f32>,
                           picture_sampler: sampler) -> vec3f {
  let integral = ltc_surface_quad_integral(s, quad);
  let shaded = ltc_shade_integral(s, integral);
  let front = ltc_front_shading(s);
  let diffuse = ltc_emission_seen_part(quad, picture, picture_sampler, s.position, s.frame,
                                       ltc_cosine_lobe(), integral.diffuse_direction, front,
                                       s.tilted);
  var specular = vec3f(0.0, 0.0, 0.0);
  specular = ltc_emission_seen_part(quad, picture, picture_sampler, s.position, s.frame,
                                    s.fitted.lobe, integral.specular_direction, front, s.tilted);
  return shaded.diffuse * diffuse + shaded.specular * specular;
}
