// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
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

/// The lobe of a roughness and a view angle, and its amplitudes.
struct FittedLobe {
  Lobe lobe; ///< normalised: its integral is 1
  Real n1;   ///< directional albedo for F = 1
  Real n5;   ///< its Schlick-weighted part
};

/// A second lobe beside a fitted one: the two share n1.
struct SecondLobe {
  Lobe lobe;   ///< normalised: its integral is 1
  Real weight; ///< its share of n1, 0..1; the first has the rest
};

/// Texture coordinate of a table axis, whose texels are its nodes: x in [0, 1] over N nodes. The
/// half-texel rule: a texture's own 0 and 1 are half a texel outside of its first and last node.
FN Real table_coordinate(Real x, Real size) {
  ASSERT_THAT(size >= Real(1.0));
  Real inv_size = Real(1.0) / size;
  return min(max(x, Real(0.0)), Real(1.0)) * (size - Real(1.0)) * inv_size + Real(0.5) * inv_size;
}

/// The lobe and amplitudes at x = sqrt(alpha) and the cosine of the view angle. `width` is what the
/// table factors out of M^-1: alpha, or 1 for a BRDF whose lobe stays wide.
FN_INLINE FittedLobe fetch_lobe_of_width(LobeTable table, Real x, Real width, Real cos_theta) {
  Real c = min(max(cos_theta, Real(0.0)), Real(1.0));
  LobeTexel texel = lobe_table_texel(table, Vec2(x, sqrt(Real(1.0) - c)));
  FittedLobe fitted;
  fitted.lobe = lobe_from_mirror(texel.coefficients, width, c);
  fitted.n1 = texel.amplitudes.x;
  fitted.n5 = texel.amplitudes.y;
  return fitted;
}

/// The same of a microfacet BRDF's table, for its width alpha.
FN_INLINE FittedLobe fetch_lobe(LobeTable table, Real alpha, Real cos_theta) {
  return fetch_lobe_of_width(table, sqrt(alpha), alpha, cos_theta);
}

/// fetch_lobe of alpha_from_roughness(roughness).
FN_INLINE FittedLobe fetch_lobe_of_roughness(LobeTable table, Real roughness, Real cos_theta) {
  return fetch_lobe_of_width(table, max(roughness, Real(k_min_roughness)),
                             alpha_from_roughness(roughness), cos_theta);
}

/// The second lobe of a table that has one (lobe_table_has_second), at the same place.
FN SecondLobe fetch_second_lobe_of_width(LobeTable table, Real x, Real width, Real cos_theta) {
  Real c = min(max(cos_theta, Real(0.0)), Real(1.0));
  Vec2 at = Vec2(x, sqrt(Real(1.0) - c));
  SecondLobe second;
  second.lobe = lobe_from_mirror(lobe_table_second(table, at), width, c);
  second.weight = lobe_table_texel(table, at).second_weight;
  return second;
}

/// The same of a microfacet BRDF's table, for alpha_from_roughness(roughness).
FN SecondLobe fetch_second_lobe_of_roughness(LobeTable table, Real roughness, Real cos_theta) {
  return fetch_second_lobe_of_width(table, max(roughness, Real(k_min_roughness)),
                                    alpha_from_roughness(roughness), cos_theta);
}

/// Amplitude of the specular lobe: F0 n1 + (F90 - F0) n5, the albedo of the whole lobe.
FN Vec3 specular_amplitude(FittedLobe fitted, Vec3 f0, Vec3 f90) {
  return f0 * fitted.n1 + (f90 - f0) * fitted.n5;
}
