// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The fitted lobe as textures that the caller binds: linear filter, clamped, of 32-bit or 16-bit
// floats. Texel (i, j) of N x N is node i of sqrt(alpha) = roughness and j of sqrt(1 - cos theta), both
// from 0 to N - 1, so that a value x of 0..1 lies at (x (N - 1) + 0.5) / N of the texture:
//   coefficients   r g b a = A B C D, see lobe_from_mirror
//   amplitudes     r = n1, g = n5, b = the share of the second lobe (0 where there is one lobe)
//   second         r g b a = A B C D of the second lobe, in tables of two
// `openltc fit -o ggx.dds` writes them, one after the other, as ggx_1.dds, ggx_2.dds and ggx_3.dds.

/// A node of the table, or what is interpolated between nodes.
struct LobeTexel {
  Vec4 coefficients;  ///< A B C D
  Vec2 amplitudes;    ///< n1, n5
  Real second_weight; ///< share of n1 that the second lobe has
};

/// Where `at`, both 0..1, lies in a texture of that size.
FN Vec2 lobe_table_place(Vec2 at, Vec2 size) {
  return Vec2((min(max(at.x, Real(0.0)), Real(1.0)) * (size.x - Real(1.0)) + Real(0.5)) / size.x,
              (min(max(at.y, Real(0.0)), Real(1.0)) * (size.y - Real(1.0)) + Real(0.5)) / size.y);
}

/// The lobe's numbers at (sqrt(alpha), sqrt(1 - cos theta)).
FN LobeTexel lobe_table_texel(LobeTable table, Vec2 at) {
  Vec2 uv = lobe_table_place(at, texture_size(table_coefficients));
  Vec4 amplitudes = texture_at(table_amplitudes, table_sampler, uv, Real(0.0));
  LobeTexel texel;
  texel.coefficients = texture_at(table_coefficients, table_sampler, uv, Real(0.0));
  texel.amplitudes = Vec2(amplitudes.x, amplitudes.y);
  texel.second_weight = amplitudes.z;
  return texel;
}

/// A B C D of the second lobe there.
FN Vec4 lobe_table_second(LobeTable table, Vec2 at) {
  Vec2 uv = lobe_table_place(at, texture_size(table_second));
  return texture_at(table_second, table_sampler, uv, Real(0.0));
}
