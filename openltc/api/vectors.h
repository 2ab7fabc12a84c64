// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What is asked of numbers and vectors that come from outside, before anything is computed with
// them.
//
// The checks are comparisons that NaN fails. A compiler that was told that there is no NaN
// (-ffast-math, -ffinite-math-only) takes them out.

#pragma once

#include "openltc/target/vec.h"

#include <cmath>
#include <limits>

namespace openltc {

/// \addtogroup vectors
/// @{

/// Metres: positions further from the origin than this along an axis are not shaded, and lights
/// that reach further light nothing. Squares of areas are then far from the end of single
/// precision.
inline constexpr float k_max_coordinate = 4e8f;

/// Metres: radii, semi-axes and lengths of lights are above this.
inline constexpr float k_min_extent = 1e-12f;

/// Metres: and not above this.
inline constexpr float k_max_extent = 1e8f;

namespace detail {

/// x within 0..1; 0 for NaN.
inline float saturate(float x) { return x > 0.0f ? (x < 1.0f ? x : 1.0f) : 0.0f; }

inline bool is_place(Vec3f p) {
  return std::abs(p.x) <= k_max_coordinate && std::abs(p.y) <= k_max_coordinate &&
         std::abs(p.z) <= k_max_coordinate;
}

inline bool is_extent(float metres) { return metres > k_min_extent && metres <= k_max_extent; }

/// v / |v|; `fallback` where v has no direction to speak of: shorter than 1e-15, longer than 1e19,
/// or not finite.
inline Vec3f unit_or(Vec3f v, Vec3f fallback) {
  const float length2 = dot(v, v);
  return length2 > 1.0e-30f && length2 <= std::numeric_limits<float>::max() ? v / std::sqrt(length2)
                                                                            : fallback;
}

/// Bends a unit normal that faces away from the viewer, as interpolation and normal maps make them,
/// until the view direction grazes it: shading has no lobe from below the horizon.
inline Vec3f towards_viewer(Vec3f normal, Vec3f view) {
  constexpr float k_grazing = 1.0e-3f;
  const float cos_view = dot(normal, view);
  if (cos_view >= k_grazing) return normal;
  return unit_or(normal + view * (k_grazing - cos_view), view);
}

/// Nothing but finite radiance that is not negative leaves; NaN becomes 0.
inline float finite_light(float x) { return x > 0.0f ? (x < 3.0e38f ? x : 3.0e38f) : 0.0f; }
inline Vec3f finite_light(Vec3f x) {
  return {finite_light(x.x), finite_light(x.y), finite_light(x.z)};
}

} // namespace detail

/// @}

} // namespace openltc
