// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
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

/// A lobe by its matrix M^-1.
struct Lobe {
  Real m00; ///< M^-1, shading space to cosine space
  Real m02; ///< row 0, column 2
  Real m20; ///< row 2, column 0
  Real m22; ///< row 2, column 2
  Real det; ///< det M^-1 = m00 m22 - m02 m20, positive
};

/// The lobe of these elements, whose determinant is positive.
FN Lobe make_lobe(Real m00, Real m02, Real m20, Real m22) {
  Lobe lobe;
  lobe.m00 = m00;
  lobe.m02 = m02;
  lobe.m20 = m20;
  lobe.m22 = m22;
  lobe.det = m00 * m22 - m02 * m20;
  return lobe;
}

/// The lobe of Lambert's BRDF: M = identity.
FN Lobe cosine_lobe() { return make_lobe(Real(1.0), Real(0.0), Real(0.0), Real(1.0)); }

/// The lobe from its native packing in the mirror frame.
///
/// With x' = (cos, 0, sin), z' = (-sin, 0, cos), z' being the mirror direction of wo,
///   M^-1 = [ A 0 aB ; 0 1 0 ; aC 0 aD ] [ x' ; y ; z' ],   a = alpha.
/// As alpha vanishes A tends to cos and D to 2 cos: four smooth, bounded functions, which
/// therefore interpolate well down to a mirror. Multiplied out:
///   m00 = A cos - a B sin     m02 = A sin + a B cos
///   m20 = a (C cos - D sin)   m22 = a (C sin + D cos).
FN Lobe lobe_from_mirror(Vec4 abcd, Real alpha, Real cos_theta) {
  ASSERT_THAT(alpha > Real(0.0));
  Real sin_theta = sqrt(max(Real(1.0) - cos_theta * cos_theta, Real(0.0)));
  Real b = alpha * abcd.y;
  Lobe lobe;
  lobe.m00 = abcd.x * cos_theta - b * sin_theta;
  lobe.m02 = abcd.x * sin_theta + b * cos_theta;
  lobe.m20 = alpha * (abcd.z * cos_theta - abcd.w * sin_theta);
  lobe.m22 = alpha * (abcd.z * sin_theta + abcd.w * cos_theta);
  lobe.det = alpha * (abcd.x * abcd.w - alpha * abcd.y * abcd.z);
  return lobe;
}

/// Inverse of lobe_from_mirror: (A, B, C, D).
FN Vec4 mirror_from_lobe(Lobe lobe, Real alpha, Real cos_theta) {
  ASSERT_THAT(alpha > Real(0.0));
  Real sin_theta = sqrt(max(Real(1.0) - cos_theta * cos_theta, Real(0.0)));
  Real inv_alpha = Real(1.0) / alpha;
  return Vec4(lobe.m00 * cos_theta + lobe.m02 * sin_theta,
              (lobe.m02 * cos_theta - lobe.m00 * sin_theta) * inv_alpha,
              (lobe.m20 * cos_theta + lobe.m22 * sin_theta) * inv_alpha,
              (lobe.m22 * cos_theta - lobe.m20 * sin_theta) * inv_alpha);
}

/// M^-1 v: a vector of shading space in cosine space, not normalised.
FN Vec3 to_cosine(Lobe lobe, Vec3 v) {
  return Vec3(lobe.m00 * v.x + lobe.m02 * v.z, v.y, lobe.m20 * v.x + lobe.m22 * v.z);
}

/// M o up to a positive scale: the adjugate of M^-1 applied to a vector of cosine space.
FN Vec3 from_cosine(Lobe lobe, Vec3 o) {
  return Vec3(lobe.m22 * o.x - lobe.m02 * o.z, lobe.det * o.y, lobe.m00 * o.z - lobe.m20 * o.x);
}

/// An upper bound of the square by which M^-1 lengthens a vector: its Frobenius norm.
FN Real lobe_stretch2(Lobe lobe) {
  return Real(1.0) + lobe.m00 * lobe.m00 + lobe.m02 * lobe.m02 + lobe.m20 * lobe.m20 +
         lobe.m22 * lobe.m22;
}

/// The surface's normal in cosine space, unit: M^T z ~ (-m20, 0, m00), the normal of the plane to
/// which M^-1 takes the horizon.
FN Vec3 horizon_normal_cosine(Lobe lobe) {
  Real length2 = lobe.m00 * lobe.m00 + lobe.m20 * lobe.m20;
  Real inv_length = inversesqrt(max(length2, Real(k_tiny)));
  return Vec3(-lobe.m20 * inv_length, Real(0.0), lobe.m00 * inv_length);
}

/// Integral of the lobe over the directions above the surface's horizon, 0..1; the rest leaks.
///
/// In cosine space those directions are a lune, between the cosine's own horizon with normal z and
/// the surface's with normal m. Lambert's edge sum over its two edges, half circles of length pi,
/// makes (z + m) / 2 of it: the z component is this share, (1 + cos g) / 2 with g between z and m.
FN Real share_above_horizon(Lobe lobe) {
  return Real(0.5) + Real(0.5) * horizon_normal_cosine(lobe).z;
}

/// Mean direction of the part of the lobe above the horizon, shading space, not normalised: (z + m)
/// / 2, the whole vector of that edge sum, carried back by M.
FN Vec3 mean_above_horizon(Lobe lobe) {
  Vec3 m = horizon_normal_cosine(lobe);
  Real z = m.z + Real(1.0);
  return Vec3(lobe.m22 * m.x - lobe.m02 * z, Real(0.0), lobe.m00 * z - lobe.m20 * m.x);
}

/// Density D(w) per solid angle, 1 over the whole sphere; the lobe may reach below the horizon.
FN Real eval_lobe(Lobe lobe, Vec3 wi_shading) {
  Vec3 o = to_cosine(lobe, wi_shading);
  // Two divisions by |o|^2 instead of one by |o|^4 keep single precision from overflowing.
  Real inv_length2 = reciprocal(max(dot(o, o), Real(k_tiny)));
  return max(o.z, Real(0.0)) * inv_length2 * (lobe.det * inv_length2) * k_inv_pi;
}

/// Direction distributed as D, from two numbers in [0, 1).
FN Vec3 sample_lobe(Lobe lobe, Vec2 u) { return normalize(from_cosine(lobe, sample_lambert(u))); }

/// Density of sample_lobe per solid angle: D itself.
FN Real pdf_lobe(Lobe lobe, Vec3 wi_shading) { return eval_lobe(lobe, wi_shading); }
