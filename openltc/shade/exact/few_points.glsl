// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// GGX itself over a polygon on which it hardly changes: at a few points of it, as a ratio to the cosine there, times
// the integral of the cosine, which Lambert's edge sum knows. The quotient needs no solid angle, and is exact where
// the BRDF over the cosine is a constant.
//
// How far a light reaches in that sense is its angular radius over |B (wo + wi)|, over how far directions turn
// before the distribution falls (half_vector.glsl).

/// Sums over the points of a polygon.
struct FewPoints {
  Real cosine;    ///< of cos_i over the cube of the distance
  Real scale;     ///< the same times f_s for F = 1, over what all points have in common
  Real bias;      ///< and times Schlick's weight
  Vec3 direction; ///< of directions, by what they have of `scale`
};

/// No point yet.
FN FewPoints no_points() {
  FewPoints sums;
  sums.cosine = Real(0.0);
  sums.scale = Real(0.0);
  sums.bias = Real(0.0);
  sums.direction = Vec3(Real(0.0), Real(0.0), Real(0.0));
  return sums;
}

/// Adds the point at p, shading space, of that weight, above the horizon but for rounding; root_o: sqrt(cos_o^2 (1 - alpha^2) +
/// alpha^2).
///   f_s cos_i = alpha^2 / (2 pi) (c / t)^2 cos_i / (cos_i root_o + cos_o root_i)
/// with c = |wo + wi|^2 and t = |B (wo + wi)|^2: eval_ggx_terms by reciprocals.
FN FewPoints add_point(GIVEN(Surface) s, Real root_o, FewPoints sums, Vec3 p, Real weight) {
  Real inv_p = inverse_length(p);
  Vec3 wi = p * inv_p;
  Vec3 sum = wi + s.wo;
  Real across2 = sum.x * sum.x + sum.y * sum.y;
  Real up2 = sum.z * sum.z;
  Real alpha2 = s.alpha * s.alpha;
  Real c = max(across2 + up2, Real(k_tiny));
  Real slope = c * reciprocal(max(across2 + alpha2 * up2, Real(k_tiny)));
  Real cos_i = max(wi.z, Real(0.0));
  Real root2 = cos_i * cos_i * (Real(1.0) - alpha2) + alpha2;
  Real masking = cos_i * root_o + s.wo.z * (root2 * inversesqrt(root2));
  Real cosine = weight * cos_i * (inv_p * inv_p * inv_p);
  Real scale = cosine * (slope * slope) * reciprocal(max(masking, Real(k_tiny)));
  sums.cosine = sums.cosine + cosine;
  sums.scale = sums.scale + scale;
  sums.bias = sums.bias + scale * schlick_weight(Real(0.5) * c * inversesqrt(c));
  sums.direction = sums.direction + wi * scale;
  return sums;
}

/// Four points of a polygon with that centroid and spread (PolygonMoments), which have its area, centroid and second
/// moments.
FN FewPoints sum_four_points(GIVEN(Surface) s, Real root_o, Vec3 center, Vec3 u, Vec3 v) {
  FewPoints sums = add_point(s, root_o, no_points(), center + u, Real(1.0));
  sums = add_point(s, root_o, sums, center - u, Real(1.0));
  sums = add_point(s, root_o, sums, center + v, Real(1.0));
  return add_point(s, root_o, sums, center - v, Real(1.0));
}

/// Three points of Gauss along u of a parallelogram, those at its ends of that weight.
FN FewPoints add_row(GIVEN(Surface) s, Real root_o, FewPoints sums, Vec3 center, Vec3 u,
                     Real weight) {
  sums = add_point(s, root_o, sums, center - u, weight);
  sums = add_point(s, root_o, sums, center, Real(1.6) * weight);
  return add_point(s, root_o, sums, center + u, weight);
}

/// Nine points of Gauss of a parallelogram with those half edges, exact for polynomials of degree 5.
FN FewPoints sum_nine_points(GIVEN(Surface) s, Real root_o, Vec3 center, Vec3 half_u, Vec3 half_v) {
  Vec3 u = half_u * Real(0.7745966692414834);
  Vec3 v = half_v * Real(0.7745966692414834);
  FewPoints sums = add_row(s, root_o, no_points(), center - v, u, Real(1.0));
  sums = add_row(s, root_o, sums, center, u, Real(1.6));
  return add_row(s, root_o, sums, center + v, u, Real(1.0));
}

/// The integral over the light whose sums these are and whose integral of the cosine is `cosine`.
FN ExactIntegral integral_of_points(GIVEN(Surface) s, FewPoints sums, Real cosine) {
  Real of_all = Real(0.5) * k_inv_pi * (s.alpha * s.alpha);
  Real each = of_all * max(cosine, Real(0.0)) * reciprocal(max(sums.cosine, Real(k_tiny)));
  ExactIntegral result;
  result.light = sums.scale * each;
  result.bias = min(sums.bias * each, result.light);
  result.direction = safe_direction(sums.direction);
  return result;
}

/// Reach up to which all of a light is points, on a surface of GGX itself, if there are nine of them,
CONSTANT k_nine_points_reach = 0.4;
/// and if there are four;
CONSTANT k_four_points_reach = 0.1;
/// and on an adaptive surface, where four points err less than lobes.
CONSTANT k_adaptive_points_reach = 0.5;
/// 1 over what lies between that and where none is.
CONSTANT k_inv_points_range = 20.0;

/// |B (wo + wi)|^2 of the unit direction wi, shading space.
FN Real turn_square(GIVEN(Surface) s, Vec3 wi) {
  Vec3 sum = wi + s.wo;
  return sum.x * sum.x + sum.y * sum.y + s.alpha * s.alpha * sum.z * sum.z;
}

/// How much of a light is points, 0..1, of that centre, shading space, and radius; nine: whether there are nine of
/// them. Masking changes over heights of about alpha, too, and what is not wholly above the horizon is none.
FN Real share_of_points(GIVEN(Surface) s, Vec3 center, Real radius, bool nine) {
  Real inv_length = inverse_length(center);
  Vec3 wi = center * inv_length;
  Real z = max(wi.z, Real(0.0));
  Real up = wi.z + s.wo.z;
  Real masking = min(up * up, z * z + s.alpha * s.alpha);
  Real square = min(turn_square(s, wi), Real(4.0) * masking);
  Real reach = radius * inv_length * inversesqrt(max(square, Real(k_tiny)));
  Real most = nine ? Real(k_nine_points_reach) : Real(k_four_points_reach);
  if (s.adaptive) {
    most = Real(k_adaptive_points_reach);
  }
  Real small = Real(1.0) + (most - reach) * Real(k_inv_points_range);
  Real above = center.z * reciprocal(max(radius, Real(k_tiny))) - Real(1.0);
  return min(max(min(above, small), Real(0.0)), Real(1.0));
}

/// The integrals of the points as far as `points` says, 0..1, and that along the outline elsewhere.
FN ExactIntegral mix_points_in(ExactIntegral outline, ExactIntegral few, Real points) {
  Real rest = Real(1.0) - points;
  Mask none = points <= Real(0.0);
  Mask all = points >= Real(1.0);
  ExactIntegral result;
  result.light = select(none, outline.light,
                        select(all, few.light, outline.light * rest + few.light * points));
  result.bias =
      select(none, outline.bias, select(all, few.bias, outline.bias * rest + few.bias * points));
  result.direction =
      select(none, outline.direction,
             select(all, few.direction,
                    safe_direction(outline.direction * rest + few.direction * points)));
  return result;
}
