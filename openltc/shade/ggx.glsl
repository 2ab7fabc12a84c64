// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
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

/// Microfacet width from the artists' perceptual roughness, both 0..1.
FN Real alpha_from_roughness(Real roughness) {
  return max(roughness * roughness, Real(k_min_alpha));
}

/// Perceptual roughness of a microfacet width.
FN Real roughness_from_alpha(Real alpha) { return sqrt(alpha); }

/// Distribution of normals D(h), 1/steradian; integral of D cos over the hemisphere is 1.
///
/// With tan terms kept apart, h.x^2 + h.y^2 + alpha^2 h.z^2, nothing cancels at low roughness, as
/// it does in cos^2 (alpha^2 - 1) + 1.
FN Real ggx_distribution(Vec3 h, Real alpha) {
  Real alpha2 = alpha * alpha;
  Real t = h.x * h.x + h.y * h.y + alpha2 * h.z * h.z;
  return alpha2 * k_inv_pi / max(t * t, Real(k_tiny));
}

/// Height-correlated Smith masking-shadowing G2, 0..1. For analysis; shading uses the visibility.
FN Real smith_g2(Real cos_o, Real cos_i, Real alpha) {
  Real alpha2 = alpha * alpha;
  Real lambda_o = cos_i * sqrt(cos_o * cos_o * (Real(1.0) - alpha2) + alpha2);
  Real lambda_i = cos_o * sqrt(cos_i * cos_i * (Real(1.0) - alpha2) + alpha2);
  return Real(2.0) * cos_o * cos_i / max(lambda_o + lambda_i, Real(k_tiny));
}

/// Visibility V = G2 / (4 cos_o cos_i): the BRDF's denominator is already inside.
FN Real smith_visibility(Real cos_o, Real cos_i, Real alpha) {
  Real alpha2 = alpha * alpha;
  Real lambda_o = cos_i * sqrt(cos_o * cos_o * (Real(1.0) - alpha2) + alpha2);
  Real lambda_i = cos_o * sqrt(cos_i * cos_i * (Real(1.0) - alpha2) + alpha2);
  return Real(0.5) / max(lambda_o + lambda_i, Real(k_tiny));
}

/// (1 - cos)^5, the weight of F90 in Schlick's approximation.
FN Real schlick_weight(Real o_dot_h) {
  Real m = min(max(Real(1.0) - o_dot_h, Real(0.0)), Real(1.0));
  Real m2 = m * m;
  return m2 * m2 * m;
}

/// schlick_weight at the microfacet that reflects one unit direction into the other, from their
/// cosine: wo.h = sqrt((1 + wo.wi) / 2).
FN Real schlick_weight_between(Real o_dot_i) {
  return schlick_weight(sqrt(max(Real(0.5) + Real(0.5) * o_dot_i, Real(0.0))));
}

/// Schlick's Fresnel reflectance; o_dot_h is the cosine at the microfacet, not at the surface.
FN Vec3 schlick_fresnel(Vec3 f0, Vec3 f90, Real o_dot_h) {
  return f0 + (f90 - f0) * schlick_weight(o_dot_h);
}

/// A GGX evaluation with Fresnel kept apart: f_s cos = f0 * scale + (f90 - f0) * bias.
struct GgxTerms {
  Real scale; ///< D V cos_i
  Real bias;  ///< D V cos_i (1 - wo.h)^5
};

/// D V cos_i and its Schlick part for a pair of directions; zero below the horizon.
FN GgxTerms eval_ggx_terms(Vec3 wo, Vec3 wi, Real alpha) {
  ASSERT_THAT(is_unit(wo) && is_unit(wi));
  ASSERT_THAT(alpha > Real(0.0));
  Vec3 sum = wo + wi;
  Vec3 h = sum * inversesqrt(max(dot(sum, sum), Real(k_tiny)));
  Real cos_o = wo.z;
  Real cos_i = wi.z;
  Mask above = cos_i > Real(0.0) && cos_o > Real(0.0);
  Real dv = ggx_distribution(h, alpha) *
            smith_visibility(max(cos_o, Real(0.0)), max(cos_i, Real(0.0)), alpha);
  GgxTerms terms;
  terms.scale = select(above, dv * cos_i, Real(0.0));
  terms.bias = terms.scale * schlick_weight(dot(wo, h));
  return terms;
}

/// The `scale` of eval_ggx_terms by itself, by reciprocals instead of quotients and roots:
///   alpha^2 / (2 pi) (c / t)^2 cos_i / (cos_i root_o + cos_o root_i)
/// with c = |wo + wi|^2 and t = |diag(1, 1, alpha) (wo + wi)|^2.
FN Real eval_ggx_scale(Vec3 wo, Vec3 wi, Real alpha) {
  ASSERT_THAT(is_unit(wo) && is_unit(wi));
  ASSERT_THAT(alpha > Real(0.0));
  Vec3 sum = wo + wi;
  Real across2 = sum.x * sum.x + sum.y * sum.y;
  Real up2 = sum.z * sum.z;
  Real alpha2 = alpha * alpha;
  Real slope = (across2 + up2) * reciprocal(max(across2 + alpha2 * up2, Real(k_tiny)));
  Real cos_o = max(wo.z, Real(0.0));
  Real cos_i = max(wi.z, Real(0.0));
  Real root_o = cos_o * cos_o * (Real(1.0) - alpha2) + alpha2;
  Real root_i = cos_i * cos_i * (Real(1.0) - alpha2) + alpha2;
  Real masking = cos_i * (root_o * inversesqrt(root_o)) + cos_o * (root_i * inversesqrt(root_i));
  return (Real(0.5) * k_inv_pi * alpha2) * (slope * slope) * cos_i *
         reciprocal(max(masking, Real(k_tiny)));
}

/// GGX BRDF times cos_i.
FN Vec3 eval_ggx(Vec3 wo, Vec3 wi, Real alpha, Vec3 f0, Vec3 f90) {
  GgxTerms terms = eval_ggx_terms(wo, wi, alpha);
  return f0 * terms.scale + (f90 - f0) * terms.bias;
}

/// Direction wi reflected at a visible normal drawn with u in [0, 1)^2; may lie below the horizon,
/// where eval is zero.
FN Vec3 sample_ggx(Vec3 wo, Real alpha, Vec2 u) {
  ASSERT_THAT(is_unit(wo));
  ASSERT_THAT(alpha > Real(0.0));
  ASSERT_THAT(in_unit_square(u));
  // Stretch to the hemisphere configuration.
  Vec3 v = normalize(Vec3(alpha * wo.x, alpha * wo.y, wo.z));
  // Sample the spherical cap of reflected directions around v.
  Real phi = Real(2.0) * k_pi * u.x;
  Real z = (Real(1.0) - u.y) * (Real(1.0) + v.z) - v.z;
  Real sin_theta = sqrt(max(Real(1.0) - z * z, Real(0.0)));
  Vec3 c = Vec3(sin_theta * cos(phi), sin_theta * sin(phi), z);
  // Half vector, back to the ellipsoid configuration.
  Vec3 m = c + v;
  Vec3 h = normalize(Vec3(alpha * m.x, alpha * m.y, max(m.z, Real(1.0e-12))));
  return h * (Real(2.0) * dot(wo, h)) - wo;
}

/// Density of sample_ggx per solid angle of wi: G1(wo) D(h) / (4 cos_o), zero below the horizon.
FN Real pdf_ggx(Vec3 wo, Vec3 wi, Real alpha) {
  ASSERT_THAT(is_unit(wo) && is_unit(wi));
  ASSERT_THAT(alpha > Real(0.0));
  Vec3 sum = wo + wi;
  Vec3 h = sum * inversesqrt(max(dot(sum, sum), Real(k_tiny)));
  Real cos_o = max(wo.z, Real(0.0));
  Real alpha2 = alpha * alpha;
  Real root = sqrt(cos_o * cos_o * (Real(1.0) - alpha2) + alpha2);
  Real pdf = ggx_distribution(h, alpha) * Real(0.5) / max(cos_o + root, Real(k_tiny));
  return select(wi.z > Real(0.0) && wo.z > Real(0.0), pdf, Real(0.0));
}
