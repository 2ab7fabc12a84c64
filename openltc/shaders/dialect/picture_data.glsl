// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The picture of a light: a texture with all its mip levels, linear filter between texels and between
// levels, clamped. It covers a rectangle, with (0, 0) at center - half_u - half_v, u along half_u and v
// along half_v. Its alpha is the share of a texel that shines, by which its colour has been multiplied: 1
// everywhere for a light that is whole.

/// Columns and rows of the finest level.
FN Vec2 emission_texel_count(EmissionTexture emission) { return texture_size(emission_picture); }

/// The colour, times the share that shines, and that share.
FN Vec4 emission_texel(EmissionTexture emission, Vec2 uv, Real level) {
  return texture_at(emission_picture, emission_picture_sampler, uv, level);
}

/// Where u and v are 0.
FN Vec3 emission_corner(EmissionTexture emission) {
  return emission.center - emission.half_u - emission.half_v;
}

/// Unit, the direction of u.
FN Vec3 emission_axis_u(EmissionTexture emission) {
  return emission.half_u * inversesqrt(max(dot(emission.half_u, emission.half_u), Real(k_tiny)));
}

/// Unit, the direction of v.
FN Vec3 emission_axis_v(EmissionTexture emission) {
  return emission.half_v * inversesqrt(max(dot(emission.half_v, emission.half_v), Real(k_tiny)));
}

/// Its sides, metres.
FN Vec2 emission_extent(EmissionTexture emission) {
  return Vec2(Real(2.0) * sqrt(dot(emission.half_u, emission.half_u)),
              Real(2.0) * sqrt(dot(emission.half_v, emission.half_v)));
}
