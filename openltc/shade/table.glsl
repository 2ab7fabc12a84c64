// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A fitted lobe and the amplitudes that belong to it, looked up in a table.
//
// Axes of the native table, node (0,0) at roughness 0 and normal incidence:
//   x = sqrt(alpha) = roughness,   y = sqrt(1 - cos theta).
// Texel i of N lies at i/(N-1), so a texture is sampled at x (N-1)/N + 1/(2N): the half-texel rule.
//
// The prelude of each target gives a look-up with bilinear interpolation at uv in [0, 1]:
//   LobeTexel lobe_table_texel(LobeTable, uv)
//     .coefficients, Vec4  the mirror-frame coefficients A B C D
//     .amplitudes, Vec2    n1 = integral of D V cos, n5 = integral of D V cos (1 - wo.h)^5
//   Vec2 lobe_table_size(LobeTable)  nodes along x and y

struct FittedLobe {
  Lobe lobe;
  Real n1; // directional albedo for F = 1
  Real n5; // its Schlick-weighted part
};

/// Texture coordinate of a table axis: x in [0, 1] over N nodes.
FN Real table_coordinate(Real x, Real size) {
  Real inv_size = Real(1.0) / size;
  return min(max(x, Real(0.0)), Real(1.0)) * (size - Real(1.0)) * inv_size + Real(0.5) * inv_size;
}

/// The lobe and amplitudes for a microfacet width and the cosine of the view angle. `width` is what
/// the table factors out of M^-1: alpha, or 1 for a BRDF whose lobe stays wide.
FN FittedLobe fetch_lobe_of_width(LobeTable table, Real alpha, Real width, Real cos_theta) {
  Vec2 size = lobe_table_size(table);
  Real c = min(max(cos_theta, Real(0.0)), Real(1.0));
  Vec2 uv = Vec2(table_coordinate(sqrt(alpha), size.x),
                 table_coordinate(sqrt(Real(1.0) - c), size.y));
  LobeTexel texel = lobe_table_texel(table, uv);
  FittedLobe fitted;
  fitted.lobe = lobe_from_mirror(texel.coefficients, width, c);
  fitted.n1 = texel.amplitudes.x;
  fitted.n5 = texel.amplitudes.y;
  return fitted;
}

/// The same of a microfacet BRDF's table.
FN FittedLobe fetch_lobe(LobeTable table, Real alpha, Real cos_theta) {
  return fetch_lobe_of_width(table, alpha, alpha, cos_theta);
}

/// Amplitude of the specular lobe: F0 n1 + (F90 - F0) n5, the albedo of the whole lobe.
FN Vec3 specular_amplitude(FittedLobe fitted, Vec3 f0, Vec3 f90) {
  return f0 * fitted.n1 + (f90 - f0) * fitted.n5;
}
