// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Area lights in closed form, by linearly transformed cosines (LTC).
// Language: WGSL. Shapes: quad.
//
// Made by OpenLTC 0.1.0 from its shading source, and readable and yours to change like that:
//   openltc shaders --language wgsl --lobe table --shapes quad
//
// BRDF   GGX with height-correlated Smith masking and Schlick's Fresnel, over Lambert.
// Lobe   one, from textures that you bind: see "table data" below. Those of
//        `openltc fit --brdf ggx --size 64 -o ggx.dds` differ from the BRDF by a
//        total variation 0.037 in the mean, 0.29 at most, which bounds the error of every light
//        (docs/fitting.md).
//
// How to call it:
//   let surface = ltc_gltf_surface(coefficients, amplitudes, table_sampler, position, normal, view, base_color, metallic, roughness);
//   let lamp = ltc_make_quad(center, half_u, half_v, 0.0);
//   light += radiance * ltc_shade_quad(surface, lamp);
// `normal`, on the viewer's side, and `view`, to the eye, are unit and in world space, like all else;
// a lamp emits along half_u x half_v. The result has no shadow. One `surface` serves all lights.
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

// The roughness of k_min_alpha.
const ltc_k_min_roughness: f32 = 0.01;

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

// ---- table data ---------------------------------------------------------------------------------
//
// The fitted lobe as textures that the caller binds: linear filter, clamped, of 32-bit or 16-bit
// floats. Texel (i, j) of N x N is node i of sqrt(alpha) = roughness and j of sqrt(1 - cos theta), both
// from 0 to N - 1, so that a value x of 0..1 lies at (x (N - 1) + 0.5) / N of the texture:
//   coefficients   r g b a = A B C D, see lobe_from_mirror
//   amplitudes     r = n1, g = n5, b = the share of the second lobe (0 where there is one lobe)
//   second         r g b a = A B C D of the second lobe, in tables of two
// `openltc fit -o ggx.dds` writes them, one after the other, as ggx_1.dds, ggx_2.dds and ggx_3.dds.

// A node of the table, or what is interpolated between nodes.
struct ltc_LobeTexel {
  coefficients: vec4f, // A B C D
  amplitudes: vec2f,   // n1, n5
}

// Where `at`, both 0..1, lies in a texture of that size.
fn ltc_lobe_table_place(at: vec2f, size: vec2f) -> vec2f {
  return vec2f((min(max(at.x, 0.0), 1.0) * (size.x - 1.0) + 0.5) / size.x,
               (min(max(at.y, 0.0), 1.0) * (size.y - 1.0) + 0.5) / size.y);
}

// The lobe's numbers at (sqrt(alpha), sqrt(1 - cos theta)).
fn ltc_lobe_table_texel(table_coefficients: texture_2d<f32>, table_amplitudes: texture_2d<f32>,
                        table_sampler: sampler, at: vec2f) -> ltc_LobeTexel {
  let uv = ltc_lobe_table_place(at, vec2f(textureDimensions(table_coefficients)));
  let amplitudes = textureSampleLevel(table_amplitudes, table_sampler, uv, 0.0);
  var texel: ltc_LobeTexel;
  texel.coefficients = textureSampleLevel(table_coefficients, table_sampler, uv, 0.0);
  texel.amplitudes = vec2f(amplitudes.x, amplitudes.y);
  return texel;
}

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

// The lobe and amplitudes at x = sqrt(alpha) and the cosine of the view angle. `width` is what the
// table factors out of M^-1: alpha, or 1 for a BRDF whose lobe stays wide.
fn ltc_fetch_lobe_of_width(table_coefficients: texture_2d<f32>, table_amplitudes: texture_2d<f32>,
                           table_sampler: sampler, x: f32, width: f32,
                           cos_theta: f32) -> ltc_FittedLobe {
  let c = min(max(cos_theta, 0.0), 1.0);
  let texel = ltc_lobe_table_texel(table_coefficients, table_amplitudes, table_sampler,
                                   vec2f(x, sqrt(1.0 - c)));
  var fitted: ltc_FittedLobe;
  fitted.lobe = ltc_lobe_from_mirror(texel.coefficients, width, c);
  fitted.n1 = texel.amplitudes.x;
  fitted.n5 = texel.amplitudes.y;
  return fitted;
}

// fetch_lobe of alpha_from_roughness(roughness).
fn ltc_fetch_lobe_of_roughness(table_coefficients: texture_2d<f32>,
                               table_amplitudes: texture_2d<f32>, table_sampler: sampler,
                               roughness: f32, cos_theta: f32) -> ltc_FittedLobe {
  return ltc_fetch_lobe_of_width(table_coefficients, table_amplitudes, table_sampler,
                                 max(roughness, ltc_k_min_roughness),
                                 ltc_alpha_from_roughness(roughness), cos_theta);
}

// Amplitude of the specular lobe: F0 n1 + (F90 - F0) n5, the albedo of the whole lobe.
fn ltc_specular_amplitude(fitted: ltc_FittedLobe, f0: vec3f, f90: vec3f) -> vec3f {
  return f0 * fitted.n1 + (f90 - f0) * fitted.n5;
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

// Where an edge crosses a plane, in units of the edge, 0..1; a, b: heights of its ends, of which one is
// below and the other not. The bound is for targets whose reciprocal is not the last digit's: a place
// beyond the end would count as cut by the other horizon (clip_edge).
fn ltc_crossing_place(a: f32, b: f32) -> f32 {
  return min(abs(a) * (1.0 / max(abs(a) + abs(b), ltc_k_tiny)), 1.0);
}

// Angle of a unit vector (c, s) from (1, 0), -pi..pi.
fn ltc_angle_of_unit(c: f32, s: f32) -> f32 {
  let acute = s * ltc_acute_over_sin(c);
  let half_turn = select(ltc_k_pi, -ltc_k_pi, s < 0.0);
  return select(acute, half_turn - acute, c < 0.0);
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
fn ltc_add_in_front(outline: ltc_OutlineSums, a: vec3f, b: vec3f, lobe: ltc_Lobe,
                    front: vec3f) -> ltc_OutlineSums {
  var next = outline;
  var from_ = a;
  var to = b;
  var next_from = a;
  var next_to = a;
  var parts = 1;
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
  for (var i = 0; i < parts; i++) {
    next = ltc_add_to_outline(next, from_, to, lobe);
    // What joins the crossing to the first.
    from_ = next_from;
    to = next_to;
  }
  return next;
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
    outline = ltc_add_in_front(outline, a, b, lobe, front);
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
fn ltc_quad_integral_in_one_lane(s: ltc_Surface, quad: ltc_Quad) -> ltc_LightIntegral {
  let front = ltc_front_shading(s);
  var integral = ltc_integrate_quad_part(quad, s.position, s.frame, s.fitted.lobe, s.tilted, front);
  if (s.tilted) {
    integral = ltc_unless_hidden(s, ltc_quad_heights(quad, s.position, s.geometric), integral);
  }
  return ltc_unless_in_plane(s, ltc_quad_origin(quad), ltc_quad_normal(quad), integral);
}

// The integral by the lobes. Uniform shortcut: no lane's triangle reaches the light.
fn ltc_lobes_quad_integral(s: ltc_Surface, quad: ltc_Quad) -> ltc_LightIntegral {
  return ltc_quad_integral_in_one_lane(s, quad);
}

// The integral over a polygon as a surface sees it: what its triangle hides is left out, and all of it
// without a side of the polygon.
fn ltc_surface_quad_integral(s: ltc_Surface, quad: ltc_Quad) -> ltc_LightIntegral {
  return ltc_lobes_quad_integral(s, quad);
}

// Light that a surface reflects of a polygon of radiance 1, without shadow.
fn ltc_shade_quad_parts(s: ltc_Surface, quad: ltc_Quad) -> ltc_ShadedLight {
  return ltc_shade_integral(s, ltc_surface_quad_integral(s, quad));
}

// Light that a surface reflects of it, for radiance 1 and without shadow: shade_polygon_parts, both together.
// Not by way of shade_polygon_parts, nor of what it asks: where a compiler does not inline
// these, each copies the surface, 3 % of a quad's instructions.
fn ltc_shade_quad(s: ltc_Surface, quad: ltc_Quad) -> vec3f {
  let by_lobes = ltc_without_exact(s);
  return ltc_both_parts(ltc_shade_integral(by_lobes, ltc_quad_integral_in_one_lane(by_lobes, quad)));
}

// ---- table surface ------------------------------------------------------------------------------
//
// What you call: a point of a surface, once for all lights.

// A point with any reflectance. `normal`, on the viewer's side, and `view`, to the eye, are unit, world
// space; `albedo` is that of the diffuse part, `f0` and `f90` the specular reflectance at normal and
// grazing incidence, `roughness` 0..1.
fn ltc_surface_at(table_coefficients: texture_2d<f32>, table_amplitudes: texture_2d<f32>,
                  table_sampler: sampler, position: vec3f, normal: vec3f, view: vec3f,
                  albedo: vec3f, f0: vec3f, f90: vec3f, roughness: f32) -> ltc_Surface {
  let fitted = ltc_fetch_lobe_of_roughness(table_coefficients, table_amplitudes, table_sampler,
                                           roughness, dot(normal, view));
  return ltc_make_surface(fitted, position, normal, view, albedo, f0, f90, roughness);
}

// ---- gltf surface -------------------------------------------------------------------------------
//
// A point of glTF 2.0's material model, and what may be added to a point.

// A point of a surface by glTF's metallic-roughness model; all values 0..1, colours linear.
fn ltc_gltf_surface(table_coefficients: texture_2d<f32>, table_amplitudes: texture_2d<f32>,
                    table_sampler: sampler, position: vec3f, normal: vec3f, view: vec3f,
                    base_color: vec3f, metallic: f32, roughness: f32) -> ltc_Surface {
  let dielectric = vec3f(0.04, 0.04, 0.04);
  let f0 = dielectric + (base_color - dielectric) * metallic;
  return ltc_surface_at(table_coefficients, table_amplitudes, table_sampler, position, normal, view,
                        base_color * (1.0 - metallic), f0, vec3f(1.0, 1.0, 1.0), roughness);
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
