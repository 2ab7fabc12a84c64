// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Area lights in closed form, by linearly transformed cosines (LTC).
// Language: GLSL 4.50 (and 3.30 or later). Shapes: quad.
//
// Made by OpenLTC 0.1.0 from its shading source, and readable and yours to change like that:
//   openltc shaders --language glsl --shapes quad --lean
//
// BRDF   GGX with height-correlated Smith masking and Schlick's Fresnel, over Lambert.
// Lobe   one, by polynomials of degree 4 in this file: no texture. It differs from the BRDF by a
//        total variation 0.038 in the mean, 0.30 at most, which bounds the error of every light
//        (docs/fitting.md).
//
// How to call it:
//   ltc_Surface surface = ltc_gltf_surface(position, normal, view, base_color, metallic, roughness);
//   ltc_Quad lamp = ltc_make_quad(center, half_u, half_v, 0.0);
//   light += radiance * ltc_shade_quad(surface, lamp);
// `normal`, on the viewer's side, and `view`, to the eye, are unit and in world space, like all else;
// a lamp emits along half_u x half_v. The result has no shadow. One `surface` serves all lights.
//
// More:
//   ltc_surface_at              a surface of any reflectance, instead of glTF's
//   ltc_shade_..._parts         diffuse and specular light apart
//
// Comments are those of the source: names have no ltc_ there, a lane is an invocation, and files that
// they name are OpenLTC's, as is docs/method.md, where all is derived.

// ---- constants ----------------------------------------------------------------------------------
//
// Constants. CONSTANT is a compile-time scalar in every target.

// pi
const float ltc_k_pi = 3.14159265358979323846;

// 1 / (2 pi)
const float ltc_k_half_inv_pi = 0.15915494309189533577;

// Smallest microfacet width that shading uses: roughness 0.01. A perfect mirror has no finite
// density; at this width the lobe is 0.01 degrees wide, below what a pixel resolves, and single
// precision still carries it.
const float ltc_k_min_alpha = 1.0e-4;

// What rounding may make of a distance of 0 from a plane, relative to that from the plane's origin:
// four units in the last place of single precision.
const float ltc_k_plane_rounding = 2.5e-7;

// Rounding of a position on a triangle in world space, relative to its distance from the origin: some
// ten units in the last place of single precision.
const float ltc_k_position_rounding = 6.0e-7;

// Least share of a lobe above the horizon that its amplitude is divided by. Fitted lobes have 0.7
// and more there; a lobe of a damaged table must not magnify rounding.
const float ltc_k_min_share = 0.01;

// Added under a division or a square root whose argument may vanish; far below any length in use.
const float ltc_k_tiny = 1.0e-30;

// Added to the square of a length under an inverse root: the product of two inverse lengths, at most
// 1e11 each, and an inverse sine, at most 1e15, stays finite.
const float ltc_k_least_length2 = 1.0e-22;

// ---- quad data ----------------------------------------------------------------------------------
//
// A light of four corners, known by its middle.

// A rectangle or parallelogram in world space; emits along half_u x half_v.
struct ltc_Quad {
  vec3 center;     // world space
  vec3 half_u;     // from there to the middle of one side, metres
  vec3 half_v;     // and to that of the next, counter-clockwise as seen from the front
  float two_sided; // 0 or 1
};

// A point of its plane.
vec3 ltc_quad_origin(ltc_Quad quad) { return quad.center; }

// Unit, to the emitting side.
vec3 ltc_quad_normal(ltc_Quad quad) {
  vec3 normal = cross(quad.half_u, quad.half_v);
  return normal * inversesqrt(max(dot(normal, normal), ltc_k_tiny));
}

// Whether it emits to both sides.
bool ltc_quad_two_sided(ltc_Quad quad) { return quad.two_sided > 0.0; }

// Square metres.
float ltc_quad_area(ltc_Quad quad) {
  vec3 normal = cross(quad.half_u, quad.half_v);
  return sqrt(dot(normal, normal)) * 4.0;
}

// The middle of its area.
vec3 ltc_quad_centroid(ltc_Quad quad) { return quad.center; }

// From there to the middle of the side from corner 1 to 2.
vec3 ltc_quad_half_u(ltc_Quad quad) { return quad.half_u; }

// And of that from 2 to 3.
vec3 ltc_quad_half_v(ltc_Quad quad) { return quad.half_v; }

// The distance of the farthest corner from there.
float ltc_quad_radius(ltc_Quad quad) {
  return sqrt(dot(quad.half_u, quad.half_u) + dot(quad.half_v, quad.half_v) +
              2.0 * abs(dot(quad.half_u, quad.half_v)));
}

// sqrt(2/3): sqrt(2) times the standard deviation of -1..1.
const float ltc_k_quad_spread = 0.81649658092772603;

// Half of what stands for it where it is small: the mean over centroid +- spread_u and +- spread_v is
// that over its area for every quadratic function.
vec3 ltc_quad_spread_u(ltc_Quad quad) { return quad.half_u * ltc_k_quad_spread; }

// And the other half.
vec3 ltc_quad_spread_v(ltc_Quad quad) { return quad.half_v * ltc_k_quad_spread; }

// ---- frame --------------------------------------------------------------------------------------
//
// The shading frame: t1 in the plane of normal and view direction, t2 = n x t1, n.
//
// In it wo = (sin theta, 0, cos theta), so an isotropic BRDF depends on theta and roughness alone.

// The shading frame of a point: the axes x, y and z of shading space, orthonormal.
struct ltc_Frame {
  vec3 t1; // unit, world space
  vec3 t2; // n x t1
  vec3 n;  // the normal
};

// A unit vector perpendicular to the unit vector n, without a branch: Duff et al. 2017, "Building an
// Orthonormal Basis, Revisited", equation 3.
vec3 ltc_any_perpendicular(vec3 n) {
  float s = n.z < 0.0 ? -1.0 : 1.0;
  float a = -1.0 / (s + n.z);
  return vec3(1.0 + s * n.x * n.x * a, s * n.x * n.y * a, -s * n.x);
}

// Frame of a unit normal and a unit direction to the viewer, world space. When the two are
// parallel any tangent serves.
ltc_Frame ltc_shading_frame(vec3 n, vec3 wo) {
  vec3 in_plane = wo - n * dot(n, wo);
  float length2 = dot(in_plane, in_plane);

  // Below this sine, 1e-4, rounding would dominate the direction; the lobe is round there.
  bool parallel = length2 < 1.0e-8;
  vec3 t1 = in_plane * inversesqrt(max(length2, 1.0e-8));
  // Uniform shortcut: no lane looks along its normal.
  if (parallel) {
    t1 = ltc_any_perpendicular(n);
  }

  ltc_Frame frame;
  frame.t1 = t1;
  frame.t2 = cross(n, t1);
  frame.n = n;
  return frame;
}

// A vector of world space in shading space.
vec3 ltc_to_shading(ltc_Frame frame, vec3 v_world) {
  return vec3(dot(frame.t1, v_world), dot(frame.t2, v_world), dot(frame.n, v_world));
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
float ltc_alpha_from_roughness(float roughness) {
  return max(roughness * roughness, ltc_k_min_alpha);
}

// (1 - cos)^5, the weight of F90 in Schlick's approximation.
float ltc_schlick_weight(float o_dot_h) {
  float m = min(max(1.0 - o_dot_h, 0.0), 1.0);
  float m2 = m * m;
  return m2 * m2 * m;
}

// schlick_weight at the microfacet that reflects one unit direction into the other, from their
// cosine: wo.h = sqrt((1 + wo.wi) / 2).
float ltc_schlick_weight_between(float o_dot_i) {
  return ltc_schlick_weight(sqrt(max(0.5 + 0.5 * o_dot_i, 0.0)));
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
  float m00; // M^-1, shading space to cosine space
  float m02; // row 0, column 2
  float m20; // row 2, column 0
  float m22; // row 2, column 2
  float det; // det M^-1 = m00 m22 - m02 m20, positive
};

// The lobe of these elements, whose determinant is positive.
ltc_Lobe ltc_make_lobe(float m00, float m02, float m20, float m22) {
  ltc_Lobe lobe;
  lobe.m00 = m00;
  lobe.m02 = m02;
  lobe.m20 = m20;
  lobe.m22 = m22;
  lobe.det = m00 * m22 - m02 * m20;
  return lobe;
}

// The lobe of Lambert's BRDF: M = identity.
ltc_Lobe ltc_cosine_lobe() { return ltc_make_lobe(1.0, 0.0, 0.0, 1.0); }

// The lobe from its native packing in the mirror frame.
//
// With x' = (cos, 0, sin), z' = (-sin, 0, cos), z' being the mirror direction of wo,
//   M^-1 = [ A 0 aB ; 0 1 0 ; aC 0 aD ] [ x' ; y ; z' ],   a = alpha.
// As alpha vanishes A tends to cos and D to 2 cos: four smooth, bounded functions, which
// therefore interpolate well down to a mirror. Multiplied out:
//   m00 = A cos - a B sin     m02 = A sin + a B cos
//   m20 = a (C cos - D sin)   m22 = a (C sin + D cos).
ltc_Lobe ltc_lobe_from_mirror(vec4 abcd, float alpha, float cos_theta) {
  float sin_theta = sqrt(max(1.0 - cos_theta * cos_theta, 0.0));
  float b = alpha * abcd.y;
  ltc_Lobe lobe;
  lobe.m00 = abcd.x * cos_theta - b * sin_theta;
  lobe.m02 = abcd.x * sin_theta + b * cos_theta;
  lobe.m20 = alpha * (abcd.z * cos_theta - abcd.w * sin_theta);
  lobe.m22 = alpha * (abcd.z * sin_theta + abcd.w * cos_theta);
  lobe.det = alpha * (abcd.x * abcd.w - alpha * abcd.y * abcd.z);
  return lobe;
}

// M^-1 v: a vector of shading space in cosine space, not normalised.
vec3 ltc_to_cosine(ltc_Lobe lobe, vec3 v) {
  return vec3(lobe.m00 * v.x + lobe.m02 * v.z, v.y, lobe.m20 * v.x + lobe.m22 * v.z);
}

// M o up to a positive scale: the adjugate of M^-1 applied to a vector of cosine space.
vec3 ltc_from_cosine(ltc_Lobe lobe, vec3 o) {
  return vec3(lobe.m22 * o.x - lobe.m02 * o.z, lobe.det * o.y, lobe.m00 * o.z - lobe.m20 * o.x);
}

// An upper bound of the square by which M^-1 lengthens a vector: its Frobenius norm.
float ltc_lobe_stretch2(ltc_Lobe lobe) {
  return 1.0 + lobe.m00 * lobe.m00 + lobe.m02 * lobe.m02 + lobe.m20 * lobe.m20 +
         lobe.m22 * lobe.m22;
}

// The surface's normal in cosine space, unit: M^T z ~ (-m20, 0, m00), the normal of the plane to
// which M^-1 takes the horizon.
vec3 ltc_horizon_normal_cosine(ltc_Lobe lobe) {
  float length2 = lobe.m00 * lobe.m00 + lobe.m20 * lobe.m20;
  float inv_length = inversesqrt(max(length2, ltc_k_tiny));
  return vec3(-lobe.m20 * inv_length, 0.0, lobe.m00 * inv_length);
}

// Integral of the lobe over the directions above the surface's horizon, 0..1; the rest leaks.
//
// In cosine space those directions are a lune, between the cosine's own horizon with normal z and
// the surface's with normal m. Lambert's edge sum over its two edges, half circles of length pi,
// makes (z + m) / 2 of it: the z component is this share, (1 + cos g) / 2 with g between z and m.
float ltc_share_above_horizon(ltc_Lobe lobe) {
  return 0.5 + 0.5 * ltc_horizon_normal_cosine(lobe).z;
}

// Mean direction of the part of the lobe above the horizon, shading space, not normalised: (z + m)
// / 2, the whole vector of that edge sum, carried back by M.
vec3 ltc_mean_above_horizon(ltc_Lobe lobe) {
  vec3 m = ltc_horizon_normal_cosine(lobe);
  float z = m.z + 1.0;
  return vec3(lobe.m22 * m.x - lobe.m02 * z, 0.0, lobe.m00 * z - lobe.m20 * m.x);
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
  ltc_Lobe lobe; // normalised: its integral is 1
  float n1;      // directional albedo for F = 1
  float n5;      // its Schlick-weighted part
};

// Amplitude of the specular lobe: F0 n1 + (F90 - F0) n5, the albedo of the whole lobe.
vec3 ltc_specular_amplitude(ltc_FittedLobe fitted, vec3 f0, vec3 f90) {
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
  vec4 mirror;     // A B C D
  vec2 amplitudes; // n1 s
};

// At u and v, see above.
ltc_LobePolynomialSum ltc_sum_lobe_polynomial(float u, float v) {
  // Chebyshev's polynomials: un is T_n(u), vn is T_n(v).
  float u2 = 2.0 * u * u - 1.0;
  float u3 = 2.0 * u * u2 - u;
  float u4 = 2.0 * u * u3 - u2;
  float v2 = 2.0 * v * v - 1.0;
  float v3 = 2.0 * v * v2 - v;
  float v4 = 2.0 * v * v3 - v2;
  ltc_LobePolynomialSum sum;
  sum.mirror = vec4(0.6677733, -0.2839807, 0.6423568, 1.097253);
  sum.mirror = sum.mirror + vec4(0.03543778, -0.3508565, 0.1513957, -0.25154) * u;
  sum.mirror = sum.mirror + vec4(-0.03947054, -0.01649081, 0.03640917, -0.1250094) * u2;
  sum.mirror = sum.mirror + vec4(-0.03788963, 0.06603108, -0.1000224, -0.02221692) * u3;
  sum.mirror = sum.mirror + vec4(-0.01275793, 0.02818707, 0.01359907, 0.008370275) * u4;
  sum.mirror = sum.mirror + vec4(-0.4390807, -0.2865121, 0.6107541, -0.8337397) * v;
  sum.mirror = sum.mirror + vec4(0.04532699, -0.3207448, 0.2106151, 0.2377783) * (u * v);
  sum.mirror = sum.mirror + vec4(-0.04185048, 0.00981988, -0.07275826, 0.07755067) * (u2 * v);
  sum.mirror = sum.mirror + vec4(-0.04465733, 0.06849372, 0.015033, 0.002158859) * (u3 * v);
  sum.mirror = sum.mirror + vec4(-0.1106452, 0.009666363, 0.09600891, -0.2100363) * v2;
  sum.mirror = sum.mirror + vec4(0.01206078, 0.03199834, -0.1940915, 0.05398509) * (u * v2);
  sum.mirror = sum.mirror + vec4(-0.009938524, 0.0348854, 0.110808, 0.01473734) * (u2 * v2);
  sum.mirror = sum.mirror + vec4(0.001470969, 0.006227979, -0.03764246, -0.0002229243) * v3;
  sum.mirror = sum.mirror + vec4(-0.0001330755, 0.007741617, 0.05895613, -0.001076636) * (u * v3);
  sum.mirror = sum.mirror + vec4(0.002074114, -0.001229983, 0.009980159, 0.00201469) * v4;
  sum.amplitudes = vec2(0.8045086, 0.343843);
  sum.amplitudes = sum.amplitudes + vec2(-0.2724648, -0.05521916) * u;
  sum.amplitudes = sum.amplitudes + vec2(-0.07661926, 0.02603711) * u2;
  sum.amplitudes = sum.amplitudes + vec2(0.008226918, -0.009146704) * u3;
  sum.amplitudes = sum.amplitudes + vec2(0.01169145, -0.001905162) * u4;
  sum.amplitudes = sum.amplitudes + vec2(0.07112518, 0.363317) * v;
  sum.amplitudes = sum.amplitudes + vec2(0.1375234, -0.135376) * (u * v);
  sum.amplitudes = sum.amplitudes + vec2(0.07787056, -0.05730146) * (u2 * v);
  sum.amplitudes = sum.amplitudes + vec2(-0.003416058, 0.03913193) * (u3 * v);
  sum.amplitudes = sum.amplitudes + vec2(0.04123044, 0.04581396) * v2;
  sum.amplitudes = sum.amplitudes + vec2(0.07066337, -0.0722363) * (u * v2);
  sum.amplitudes = sum.amplitudes + vec2(0.02702755, 0.05455893) * (u2 * v2);
  sum.amplitudes = sum.amplitudes + vec2(0.01748315, 0.01933991) * v3;
  sum.amplitudes = sum.amplitudes + vec2(0.03402566, 0.01176714) * (u * v3);
  sum.amplitudes = sum.amplitudes + vec2(0.008494951, -0.01617918) * v4;
  return sum;
}

// The lobe and amplitudes for a microfacet width and the cosine of the view angle, whatever their
// values: n1 >= 0, n5 in [0, n1], a determinant above 0. `width` is what was factored out of
// M^-1: alpha, or 1 for a BRDF whose lobe stays wide.
ltc_FittedLobe ltc_eval_lobe_polynomial_of_width(float alpha, float width, float cos_theta) {
  float a = min(max(alpha, ltc_k_min_alpha), 1.0);
  float c = min(max(cos_theta, 0.0), 1.0);
  float u = 2.0 * sqrt(a) - 1.0;
  float v = 2.0 * sqrt(1.0 - c) - 1.0;
  ltc_LobePolynomialSum sum = ltc_sum_lobe_polynomial(u, v);
  ltc_FittedLobe fitted;
  fitted.lobe = ltc_lobe_from_mirror(sum.mirror, min(max(width, ltc_k_min_alpha), 1.0), c);
  fitted.lobe.det = max(fitted.lobe.det, ltc_k_tiny);
  fitted.n1 = max(sum.amplitudes.x, 0.0);
  float s = min(max(sum.amplitudes.y, 0.0), 1.0);
  float s2 = s * s;
  fitted.n5 = fitted.n1 * (s2 * s2 * s);
  return fitted;
}

// The same of a microfacet BRDF, which reflects no more than it receives: n1 in [0, 1].
ltc_FittedLobe ltc_eval_lobe_polynomial(float alpha, float cos_theta) {
  ltc_FittedLobe fitted = ltc_eval_lobe_polynomial_of_width(alpha, alpha, cos_theta);
  float excess = max(fitted.n1, 1.0);
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
float ltc_inverse_length(vec3 v) {
  return inversesqrt(v.x * v.x + (v.y * v.y + (v.z * v.z + ltc_k_least_length2)));
}

// v / |v|, or the normal where v has no direction to speak of.
vec3 ltc_safe_direction(vec3 v) {
  float length2 = dot(v, v);
  bool usable = length2 > ltc_k_tiny;
  return usable ? v * inversesqrt(max(length2, ltc_k_tiny)) : vec3(0.0, 0.0, 1.0);
}

// theta / sin(theta) from x = cos(theta), for 0 <= theta <= pi/2; of -x for x < 0.
//
// A rational minimax fit of degree 3/3, relative error 1.0e-9; smooth at 1, so that a cosine that
// rounding took beyond does no harm.
float ltc_acute_over_sin(float x) {
  float y = abs(x);
  float p = 1.5707963252152057 +
            y * (1.638642066993385 + y * (0.35581734455759484 + y * 0.004572514079188905));
  float q = 1.0 + y * (1.679811571269012 + y * (0.7959248032398663 + y * 0.09409187287776444));
  return p * (1.0 / q);
}

// theta / sin(theta) for 0 <= theta < pi, from `acute`, that of x = cos(theta), and sin2 =
// sin(theta)^2: beyond a right angle theta = pi - theta', which is exact. It grows without bound
// towards x = -1, where 1 - x^2 has no digits left; so the caller, who knows the vectors, passes
// sin2 as well.
float ltc_any_over_sin(float x, float sin2, float acute) {
  float inv_sin = inversesqrt(max(sin2, ltc_k_tiny));
  return x < 0.0 ? ltc_k_pi * inv_sin - acute : acute;
}

// Contribution of the arc from a to b = a + d to the vector irradiance, times 2 pi. d is passed by
// itself so that the cross product of a small, far edge does not cancel. Never longer than pi: a
// vector over its length, times an angle.
//
// inv_a, inv_b: one over the lengths of a and b.
vec3 ltc_edge_term_scaled(vec3 a, vec3 b, vec3 d, float inv_a, float inv_b) {
  float scale = inv_a * inv_b;
  vec3 c = cross(a, d);
  float x = dot(a, b) * scale;
  float weight = ltc_acute_over_sin(x);
  if (x < 0.0) {
    weight = ltc_any_over_sin(x, dot(c, c) * scale * scale, weight);
  }
  return c * (scale * weight);
}

// Where an edge crosses a plane, in units of the edge, 0..1; a, b: heights of its ends, of which one is
// below and the other not. The bound is for targets whose reciprocal is not the last digit's: a place
// beyond the end would count as cut by the other horizon (clip_edge).
float ltc_crossing_place(float a, float b) {
  return min(abs(a) * (1.0 / max(abs(a) + abs(b), ltc_k_tiny)), 1.0);
}

// Angle of a unit vector (c, s) from (1, 0), -pi..pi.
float ltc_angle_of_unit(float c, float s) {
  float acute = s * ltc_acute_over_sin(c);
  float half_turn = s < 0.0 ? -ltc_k_pi : ltc_k_pi;
  return c < 0.0 ? half_turn - acute : acute;
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
  float diffuse;           // integral of cos/pi over the light, 0..1
  float specular;          // integral of the lobe's density, both horizons respected, 0..1
  vec3 specular_direction; // shading space, unit
  float second;            // integral of a second lobe's density, see with_second_lobe; else 0
};

// From the vector irradiances times 2 pi; outline2: see light_concentration.
ltc_LightIntegral ltc_light_integral(vec3 diffuse, vec3 specular, ltc_Lobe lobe) {
  ltc_LightIntegral result;
  result.diffuse = min(max(diffuse.z * ltc_k_half_inv_pi, 0.0), 1.0);
  result.specular = min(max(specular.z * ltc_k_half_inv_pi, 0.0), 1.0);
  result.second = 0.0;
  result.specular_direction = ltc_safe_direction(ltc_from_cosine(lobe, specular));
  return result;
}

// Whether a point lies in a light's plane as far as can be told: h, its distance, is no more than
// that to which the point is known, whose square is `error2`, or than what rounding makes of 0. Such a
// point has no side, and gets no light. `to_origin` leads from the point to any point of the plane.
bool ltc_lies_in_plane(float h, vec3 to_origin, float error2) {
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
  vec3 position;         // world space
  // Square of the metres within which it is known; make_surface assumes single precision.
  float position_error2;
  ltc_Frame frame;       // shading space
  vec3 wo;               // shading space: (sin theta, 0, cos theta)
  vec3 diffuse;          // k_d c, albedo of the Lambertian part
  vec3 f0;               // specular reflectance at normal incidence
  vec3 f90;              // and at grazing incidence
  ltc_FittedLobe fitted; // the lobe for this roughness and view
  vec3 specular;         // F0 n1 + (F90 - F0) n5, the specular albedo
  float axis_weight;     // n5/n1 less Schlick's weight in the lobe's mean direction
  float inv_share;       // weight of the lobe, 1 if it is the only one, over its share_above_horizon
  ltc_Lobe second;       // the second lobe
};

// Schlick's weight at the microfacet that reflects wo, which has no y, into wi.
float ltc_fresnel_weight(vec3 wo, vec3 wi) {
  return ltc_schlick_weight_between(wo.x * wi.x + wo.z * wi.z);
}

// Prepares a point for shading. `fitted` is the lobe of alpha_from_roughness(roughness) and
// dot(normal, wo_world), from a table or a polynomial. `normal` and `wo_world` are unit; `albedo`
// is (1 - metallic) c.
ltc_Surface ltc_make_surface(ltc_FittedLobe fitted, vec3 position, vec3 normal, vec3 wo_world,
                             vec3 albedo, vec3 f0, vec3 f90) {
  ltc_Surface s;
  s.position = position;
  s.position_error2 = ltc_k_position_rounding * ltc_k_position_rounding * dot(position, position);
  s.frame = ltc_shading_frame(normal, wo_world);
  s.wo = vec3(dot(s.frame.t1, wo_world), 0.0, dot(normal, wo_world));
  s.f0 = f0;
  s.f90 = f90;
  s.fitted = fitted;
  s.specular = ltc_specular_amplitude(fitted, f0, f90);
  s.inv_share = 1.0 / max(ltc_share_above_horizon(fitted.lobe), ltc_k_min_share);
  vec3 mean = ltc_safe_direction(ltc_mean_above_horizon(fitted.lobe));
  s.axis_weight = fitted.n5 * (1.0 / max(fitted.n1, ltc_k_tiny)) - ltc_fresnel_weight(s.wo, mean);
  float taken = max(max(s.specular.x, s.specular.y), s.specular.z);
  s.diffuse = albedo * max(1.0 - taken, 0.0);
  s.second = fitted.lobe;
  return s;
}

// The share that a light fills of all that the lobes have above the horizon, 0..1.
float ltc_filled_share(ltc_Surface s, ltc_LightIntegral integral) {
  float share = integral.specular * s.inv_share;
  return min(share, 1.0);
}

// The same surface where no lane is GGX itself: one that asks its lobes alone.
ltc_Surface ltc_without_exact(ltc_Surface s) { return s; }

// Whether the point has a side of a flat light, whose plane holds `origin`: not on the emitter itself
// or on a wall flush with it, as far as its position is known. Without a side there is no light.
bool ltc_has_side(ltc_Surface s, vec3 origin, vec3 normal) {
  vec3 to_origin = origin - s.position;
  return !ltc_lies_in_plane(dot(to_origin, normal), to_origin, s.position_error2);
}

// An integral without what lanes have without a side of a flat light.
ltc_LightIntegral ltc_unless_in_plane(ltc_Surface s, vec3 origin, vec3 normal,
                                      ltc_LightIntegral integral) {
  bool sided = ltc_has_side(s, origin, normal);
  integral.diffuse = sided ? integral.diffuse : 0.0;
  integral.specular = sided ? integral.specular : 0.0;
  integral.second = sided ? integral.second : 0.0;
  return integral;
}

// A part of the hemisphere reflects no more than the whole, s.specular.
vec3 ltc_within_albedo(ltc_Surface s, vec3 part) {
  return vec3(min(part.x, s.specular.x), min(part.y, s.specular.y), min(part.z, s.specular.z));
}

// The share `filled` of n1 with this weight of F90 over F0, within the albedo.
vec3 ltc_reflectance_of_weight(ltc_Surface s, float weight, float filled) {
  vec3 fresnel = s.f0 + (s.f90 - s.f0) * min(max(weight, 0.0), 1.0);
  return ltc_within_albedo(s, fresnel * (s.fitted.n1 * filled));
}

// What a light that fills this share of the lobe has of Schlick's weight beyond that in its mean
// direction: all of the whole lobe's, axis_weight, for one that fills it, and by the square of the share
// less for others, since it comes from the lobe's rim, which a light around its middle does not reach.
float ltc_weight_of_rim(ltc_Surface s, float share) { return share * share * s.axis_weight; }

// Schlick's weight in the light of a share of what the lobe has above the horizon, 0..1, which comes from around
// wi.
//
// F0 n1 + (F90 - F0) n5 is the albedo of the whole lobe. Spread evenly over it, it gives light far
// from the mirror direction the Fresnel reflectance of the mirror direction: twice too much and
// more on a dielectric seen at an angle. So Schlick's weight is taken at wi instead, plus weight_of_rim:
// exact for a small light, w(wi), and for one that fills the hemisphere, n5/n1.
float ltc_part_weight(ltc_Surface s, vec3 wi, float share) {
  return ltc_fresnel_weight(s.wo, wi) + ltc_weight_of_rim(s, share);
}

// Reflected light of a light of radiance 1.
struct ltc_ShadedLight {
  vec3 diffuse;  // by the Lambertian part
  vec3 specular; // by the lobe
};

// Their sum.
vec3 ltc_both_parts(ltc_ShadedLight shaded) { return shaded.diffuse + shaded.specular; }

// Light of radiance 1 whose specular part has this weight of F90 over F0, and the share `filled` of n1; where the
// integral is that of GGX itself, its own.
ltc_ShadedLight ltc_shade_filled(ltc_Surface s, ltc_LightIntegral integral, float weight,
                                 float filled) {
  ltc_ShadedLight shaded;
  shaded.diffuse = s.diffuse * integral.diffuse;
  shaded.specular = ltc_reflectance_of_weight(s, weight, filled);
  return shaded;
}

// Light of radiance 1 in closed form, without shadow: its diffuse and its specular part.
ltc_ShadedLight ltc_shade_integral(ltc_Surface s, ltc_LightIntegral integral) {
  float share = ltc_filled_share(s, integral);
  float filled = share;
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
  vec3 diffuse;  // 2 pi times the vector irradiance of the clipped polygon in shading space
  vec3 specular; // the same in cosine space
};

// Of an outline without an edge.
ltc_EdgeSums ltc_no_edge_sums() {
  ltc_EdgeSums sums;
  sums.diffuse = vec3(0.0, 0.0, 0.0);
  sums.specular = sums.diffuse;
  return sums;
}

// ---- convex quad --------------------------------------------------------------------------------
//
// A convex quad cut by both horizons in one lane, without a loop and with next to no branch: what the surface's
// horizon leaves of it has five corners at most, and five that may coincide stand for every case. In cosine space
// their five edges are cut one by one and closed in their plane, as in lanes (close_outline).

// The point where an edge crosses the surface's horizon, shading space.
vec3 ltc_horizon_point(vec3 a, vec3 b) {
  float t = ltc_crossing_place(a.z, b.z);
  return vec3(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, 0.0);
}

// Five corners of a convex outline in its order, of which some may coincide.
struct ltc_FiveCorners {
  vec3 first;  // shading space
  vec3 second; // see first
  vec3 third;  // see first
  vec3 fourth; // see first
  vec3 fifth;  // see first
};

// The same, from the second on.
ltc_FiveCorners ltc_next_corner_first(ltc_FiveCorners corners) {
  ltc_FiveCorners next;
  next.first = corners.second;
  next.second = corners.third;
  next.third = corners.fourth;
  next.fourth = corners.fifth;
  next.fifth = corners.first;
  return next;
}

// 2 pi times the vector irradiance of what they bound, which is above the horizon, shading space.
vec3 ltc_sum_corners(ltc_FiveCorners corners) {
  ltc_FiveCorners left = corners;
  vec3 sum = vec3(0.0, 0.0, 0.0);
  vec3 a = corners.fifth;
  float inv_a = ltc_inverse_length(a);
  for (int i = 0; i < 5; ++i) {
    vec3 b = left.first;
    float inv_b = ltc_inverse_length(b);
    sum = sum + ltc_edge_term_scaled(a, b, b - a, inv_a, inv_b);
    a = b;
    inv_a = inv_b;
    left = ltc_next_corner_first(left);
  }
  return sum;
}

// The sum over a convex outline in cosine space, and where it crosses the cosine's horizon: at most once either way.
struct ltc_ConvexSum {
  vec3 term;   // 2 pi times the vector irradiance, not yet closed
  vec3 enters; // where the outline comes up, unit
  vec3 leaves; // and where it goes down
};

// No edges yet.
ltc_ConvexSum ltc_no_convex_edges() {
  ltc_ConvexSum sum;
  sum.term = vec3(0.0, 0.0, 0.0);
  sum.enters = vec3(1.0, 0.0, 0.0);
  sum.leaves = sum.enters;
  return sum;
}

// The edge from a to b, cosine space, cut by its horizon without a branch: of an edge below it the length is 0. inv_a,
// inv_b: 1 / their lengths.
ltc_ConvexSum ltc_add_convex_edge(ltc_ConvexSum sum, vec3 a, vec3 b, float inv_a, float inv_b) {
  bool a_up = a.z >= 0.0;
  bool b_up = b.z >= 0.0;
  vec3 along = b - a;
  float t = ltc_crossing_place(a.z, b.z);
  vec3 cut = vec3(a.x + along.x * t, a.y + along.y * t, 0.0);
  float inv_cut = ltc_inverse_length(cut);
  vec3 unit = cut * inv_cut;
  float extent = a_up ? (b_up ? 1.0 : t) : (b_up ? 1.0 - t : 0.0);
  ltc_ConvexSum next;
  next.term = sum.term +
              ltc_edge_term_scaled(a_up ? a : cut, b_up ? b : cut, along * extent,
                                   a_up ? inv_a : inv_cut, b_up ? inv_b : inv_cut);
  next.enters = b_up && !a_up ? unit : sum.enters;
  next.leaves = a_up && !b_up ? unit : sum.leaves;
  return next;
}

// The specular sum of a whole outline, closed along the cosine's horizon. way: negative where a positive angle about z
// leads backwards; it holds whatever rounding makes of an angle near 0.
vec3 ltc_close_convex_outline(ltc_ConvexSum sum, float way) {
  vec3 a = sum.leaves;
  vec3 b = sum.enters;
  float angle = abs(ltc_angle_of_unit(a.x * b.x + a.y * b.y, a.x * b.y - a.y * b.x));
  return vec3(sum.term.x, sum.term.y, sum.term.z + (way < 0.0 ? -angle : angle));
}

// sum_corners in cosine space. way: see close_convex_outline.
vec3 ltc_sum_corners_cosine(ltc_FiveCorners corners, ltc_Lobe lobe, float way) {
  ltc_FiveCorners left = corners;
  ltc_ConvexSum sum = ltc_no_convex_edges();
  vec3 a = ltc_to_cosine(lobe, corners.fifth);
  float inv_a = ltc_inverse_length(a);
  for (int i = 0; i < 5; ++i) {
    vec3 b = ltc_to_cosine(lobe, left.first);
    float inv_b = ltc_inverse_length(b);
    sum = ltc_add_convex_edge(sum, a, b, inv_a, inv_b);
    a = b;
    inv_a = inv_b;
    left = ltc_next_corner_first(left);
  }
  return ltc_close_convex_outline(sum, way);
}

// sum_edges, but for outline2, of a convex quad with these corners, shading space, in its order. h: signed
// distance of its plane along its normal.
ltc_EdgeSums ltc_sum_convex_quad(vec3 corner0, vec3 corner1, vec3 corner2, vec3 corner3, float h,
                                 ltc_Lobe lobe) {
  vec3 a = corner0;
  vec3 b = corner1;
  vec3 c = corner2;
  vec3 d = corner3;
  // Turned until it enters at a: a is above and d is not. One that is wholly above comes as it may.
  for (int i = 0; i < 3; ++i) {
    bool enters = a.z >= 0.0 && d.z < 0.0;
    vec3 first = a;
    a = enters ? a : b;
    b = enters ? b : c;
    c = enters ? c : d;
    d = enters ? d : first;
  }
  bool seen = a.z >= 0.0;
  bool two = b.z >= 0.0;
  bool three = two && c.z >= 0.0;
  bool four = d.z >= 0.0;
  vec3 last = three ? c : (two ? b : a);
  vec3 below = three ? d : (two ? c : b);
  vec3 leaves = four ? d : ltc_horizon_point(last, below);
  ltc_FiveCorners corners;
  corners.first = a;
  corners.second = two ? b : leaves;
  corners.third = three ? c : leaves;
  corners.fourth = leaves;
  corners.fifth = four ? d : ltc_horizon_point(d, a);
  vec3 none = vec3(0.0, 0.0, 0.0);
  ltc_EdgeSums sums;
  sums.diffuse = seen ? ltc_sum_corners(corners) : none;
  sums.specular = seen ? ltc_sum_corners_cosine(corners, lobe, h * lobe.det) : none;
  return sums;
}

// sum_edges_in_one_lane of a parallelogram at signed distance h along its normal: by its outline where a triangle's
// plane cuts it, and else as above.
ltc_EdgeSums ltc_sum_quad_in_one_lane(ltc_Quad quad, vec3 position, ltc_Frame frame,
                                      ltc_Lobe lobe, float h) {
  // Its middle and sides take three turns where four corners take four.
  vec3 middle = ltc_to_shading(frame, ltc_quad_centroid(quad) - position);
  vec3 u = ltc_to_shading(frame, ltc_quad_half_u(quad));
  vec3 v = ltc_to_shading(frame, ltc_quad_half_v(quad));
  vec3 a = middle - u - v;
  vec3 b = middle + u - v;
  vec3 c = middle + u + v;
  vec3 d = middle - u + v;
  ltc_EdgeSums sums = ltc_sum_convex_quad(a, b, c, d, h, lobe);
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
  vec3 center;       // its centroid
  vec3 u;            // its spread, see PolygonMoments
  vec3 v;            // and the one across
  float radius;      // around the centroid
  float area_height; // area times the distance from its plane
};

// What its small form has of a polygon's integral over one lobe.
struct ltc_SmallShare {
  vec3 sum;       // its part of 2 pi times the vector irradiance
  float by_edges; // the share, 0..1, of the sums over the edges, which are the rest
};

// All by the edges.
ltc_SmallShare ltc_no_small_share() {
  ltc_SmallShare share;
  share.sum = vec3(0.0, 0.0, 0.0);
  share.by_edges = 1.0;
  return share;
}

// Square of the angular radius below which the small form is all, 0.03.
const float ltc_k_wholly_small_radius2 = 0.0009;

// Square of the one below which it begins, 0.05.
const float ltc_k_small_radius2 = 0.0025;

// 1 over what lies between, over which the one fades into the other.
const float ltc_k_inv_small_range = 625.0;

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
ltc_SmallShare ltc_small_share(ltc_SmallPolygon small, ltc_Lobe lobe) {
  vec3 o = ltc_to_cosine(lobe, small.center);
  vec3 u = ltc_to_cosine(lobe, small.u);
  vec3 v = ltc_to_cosine(lobe, small.v);
  float inv_o2 = 1.0 / max(dot(o, o), ltc_k_tiny);
  float reach2 = small.radius * small.radius * ltc_lobe_stretch2(lobe) * inv_o2;
  bool above = small.center.z > small.radius && o.z > 0.0 && o.z * o.z * inv_o2 > reach2;
  ltc_SmallShare share;
  share.by_edges = above ?
                   min(max((reach2 - ltc_k_wholly_small_radius2) * ltc_k_inv_small_range, 0.0), 1.0) :
                   1.0;
  float x = dot(o, u) * inv_o2;
  float y = dot(o, v) * inv_o2;
  float middle = 1.0 + 6.0 * (x * x + y * y) - (dot(u, u) + dot(v, v)) * inv_o2;
  vec3 mean = o * middle - (u * x + v * y) * 2.0;
  float rest = 2.0 * small.area_height * (1.0 - share.by_edges);
  share.sum = share.by_edges < 1.0 ? mean * (rest * inv_o2 * (lobe.det * inv_o2)) :
              vec3(0.0, 0.0, 0.0);
  return share;
}

// The sign that its edge sums want: -1 in front, 1 behind a two-sided one, else 0. h: signed distance of
// its plane along its normal.
float ltc_quad_lit_side(ltc_Quad quad, float h, vec3 to_origin) {
  float side = h < 0.0 ? -1.0 : (ltc_quad_two_sided(quad) ? 1.0 : 0.0);
  return ltc_lies_in_plane(h, to_origin, 0.0) ? 0.0 : side;
}

// What a point knows of a polygon before it asks a lobe.
struct ltc_PolygonSight {
  float h;        // signed distance of its plane, along its normal
  float side;     // see lit_side
  vec3 to_center; // its centroid, from the point, world space
  float radius;   // around the centroid
  bool large;     // whether no lane sees it small, in shading space or in any lobe's cosine space
};

// Of a point at `position`, world space.
ltc_PolygonSight ltc_see_quad(ltc_Quad quad, vec3 position) {
  ltc_PolygonSight sight;
  vec3 to_origin = ltc_quad_origin(quad) - position;
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
ltc_SmallPolygon ltc_small_quad(ltc_Quad quad, ltc_PolygonSight sight, vec3 center,
                                ltc_Frame frame) {
  ltc_SmallPolygon small;
  small.center = center;
  small.u = ltc_to_shading(frame, ltc_quad_spread_u(quad));
  small.v = ltc_to_shading(frame, ltc_quad_spread_v(quad));
  small.radius = sight.radius;
  small.area_height = ltc_quad_area(quad) * abs(sight.h) * abs(sight.side);
  return small;
}

// The sums over its edges in whichever way suits its outline and what cuts it.
ltc_EdgeSums ltc_sum_quad_edges(ltc_Quad quad, vec3 position, ltc_Frame frame, ltc_Lobe lobe,
                                float h) {
  return ltc_sum_quad_in_one_lane(quad, position, frame, lobe, h);
}

// Integrals over a polygon seen from `position` (world space), for Lambert and for `lobe`. Zero
// behind a one-sided polygon and in the plane of any; whoever knows `position` less well than its
// last digit asks has_side (surface.glsl) as well. With `cut`, of what is in front of the plane with
// unit normal `front` (shading space).
//
// The edge sum of the polygon in cosine space is a vector, its vector irradiance. The z component
// is the integral; the direction is the mean direction of the part of the polygon that counts,
// and M carries it back to shading space. It tells which Fresnel reflectance that light meets.
ltc_LightIntegral ltc_integrate_quad_part(ltc_Quad quad, vec3 position, ltc_Frame frame,
                                          ltc_Lobe lobe) {
  ltc_PolygonSight sight = ltc_see_quad(quad, position);
  ltc_SmallShare diffuse = ltc_no_small_share();
  ltc_SmallShare specular = diffuse;
  // Uniform shortcut.
  if (!sight.large) {
    ltc_SmallPolygon small = ltc_small_quad(quad, sight, ltc_to_shading(frame, sight.to_center),
                                            frame);
    diffuse = ltc_small_share(small, ltc_cosine_lobe());
    specular = ltc_small_share(small, lobe);
  }

  ltc_EdgeSums sums = ltc_no_edge_sums();
  // Uniform shortcut: no lane is on a lit side and wants the edges.
  if (sight.side != 0.0 && (diffuse.by_edges > 0.0 || specular.by_edges > 0.0)) {
    sums = ltc_sum_quad_edges(quad, position, frame, lobe, sight.h);
  }
  return ltc_light_integral(sums.diffuse * (sight.side * diffuse.by_edges) + diffuse.sum,
                            sums.specular * (sight.side * specular.by_edges) + specular.sum, lobe);
}

// ---- polygon surface ----------------------------------------------------------------------------
//
// A polygon as a surface sees it, less what the surface's triangle hides: by the fitted lobe (polygon.glsl), or by
// GGX itself, along the same edges (exact/half_vector.glsl).

// Both in one lane, which passes over what it does not need.
ltc_LightIntegral ltc_quad_integral_in_one_lane(ltc_Surface s, ltc_Quad quad) {
  ltc_LightIntegral integral = ltc_integrate_quad_part(quad, s.position, s.frame, s.fitted.lobe);
  return ltc_unless_in_plane(s, ltc_quad_origin(quad), ltc_quad_normal(quad), integral);
}

// The integral by the lobes. Uniform shortcut: no lane's triangle reaches the light.
ltc_LightIntegral ltc_lobes_quad_integral(ltc_Surface s, ltc_Quad quad) {
  return ltc_quad_integral_in_one_lane(s, quad);
}

// The integral over a polygon as a surface sees it: what its triangle hides is left out, and all of it
// without a side of the polygon.
ltc_LightIntegral ltc_surface_quad_integral(ltc_Surface s, ltc_Quad quad) {
  return ltc_lobes_quad_integral(s, quad);
}

// Light that a surface reflects of a polygon of radiance 1, without shadow.
ltc_ShadedLight ltc_shade_quad_parts(ltc_Surface s, ltc_Quad quad) {
  return ltc_shade_integral(s, ltc_surface_quad_integral(s, quad));
}

// Light that a surface reflects of it, for radiance 1 and without shadow: shade_polygon_parts, both together.
// Not by way of shade_polygon_parts, nor of what it asks: where a compiler does not inline
// these, each copies the surface, 3 % of a quad's instructions.
vec3 ltc_shade_quad(ltc_Surface s, ltc_Quad quad) {
  ltc_Surface by_lobes = ltc_without_exact(s);
  return ltc_both_parts(ltc_shade_integral(by_lobes, ltc_quad_integral_in_one_lane(by_lobes, quad)));
}

// ---- polynomial surface -------------------------------------------------------------------------
//
// What you call: a point of a surface, once for all lights.

// A point with any reflectance. `normal`, on the viewer's side, and `view`, to the eye, are unit, world
// space; `albedo` is that of the diffuse part, `f0` and `f90` the specular reflectance at normal and
// grazing incidence, `roughness` 0..1.
ltc_Surface ltc_surface_at(vec3 position, vec3 normal, vec3 view, vec3 albedo, vec3 f0, vec3 f90,
                           float roughness) {
  ltc_FittedLobe fitted = ltc_eval_lobe_polynomial(ltc_alpha_from_roughness(roughness),
                                                   dot(normal, view));
  return ltc_make_surface(fitted, position, normal, view, albedo, f0, f90);
}

// ---- gltf surface -------------------------------------------------------------------------------
//
// A point of glTF 2.0's material model, and what may be added to a point.

// A point of a surface by glTF's metallic-roughness model; all values 0..1, colours linear.
ltc_Surface ltc_gltf_surface(vec3 position, vec3 normal, vec3 view, vec3 base_color,
                             float metallic, float roughness) {
  vec3 dielectric = vec3(0.04, 0.04, 0.04);
  vec3 f0 = dielectric + (base_color - dielectric) * metallic;
  return ltc_surface_at(position, normal, view, base_color * (1.0 - metallic), f0,
                        vec3(1.0, 1.0, 1.0), roughness);
}

// ---- lights -------------------------------------------------------------------------------------
//
// What you call: lights. Each function returns the light that a surface reflects of one of radiance 1,
// without shadow; shade_X_parts has its diffuse and its specular part apart.

// A rectangle or parallelogram: its middle, and from there to the middles of two sides. It emits along
// half_u x half_v, or to both sides where two_sided is 1.
ltc_Quad ltc_make_quad(vec3 center, vec3 half_u, vec3 half_v, float two_sided) {
  ltc_Quad quad;
  quad.center = center;
  quad.half_u = half_u;
  quad.half_v = half_v;
  quad.two_sided = two_sided;
  return quad;
}
