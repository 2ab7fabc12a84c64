// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights with an extent, beside polygons. World space, metres; each emits the same radiance in
// every direction (Lambert's emitter).
//
// A light with a value that is not finite, an extent that is not between k_min_extent and
// k_max_extent, or a place beyond k_max_coordinate lights nothing.

#pragma once

#include "openltc/api/vectors.h"
#include "openltc/target/shade_f32.h"

namespace openltc {

/// \addtogroup lights
/// @{

/// A flat ellipse; a disk when both semi-axes are equally long. Emits along half_u x half_v.
struct Ellipse {
  Vec3f center{0, 0, 0};  ///< world space, metres
  Vec3f half_u{1, 0, 0};  ///< a semi-axis, world space, metres
  Vec3f half_v{0, 1, 0};  ///< the other, perpendicular within 1e-3; else no light
  bool two_sided = false; ///< whether it emits against its normal too
};

/// A sphere. Emits outwards; no light reaches points inside.
struct Sphere {
  Vec3f center{0, 0, 0}; ///< world space, metres
  float radius = 1;      ///< metres
};

/// What closes the ends of a tube.
enum class TubeCaps {
  none, ///< the lateral surface alone, which emits outwards
  flat, ///< a solid cylinder
  round ///< a capsule: a hemisphere at each end, beyond the ends of the axis
};

/// A round tube along a straight axis. Emits outwards; no light reaches points inside.
struct Tube {
  Vec3f from{-0.5f, 0, 0};         ///< one end of the axis, world space, metres
  Vec3f to{0.5f, 0, 0};            ///< the other end
  float radius = 0.05f;            ///< metres
  TubeCaps caps = TubeCaps::round; ///< what closes the ends
};

/// A tube too thin to have a width. What it emits is its intensity per metre across the axis, cd/m:
/// the radiance of a thin tube times its diameter. It stands where others have a radiance.
struct Line {
  Vec3f from{-0.5f, 0, 0}; ///< one end, world space, metres
  Vec3f to{0.5f, 0, 0};    ///< the other end
};

/// A disk around `center` of that radius, which emits along `normal`, of any length that is not 0.
inline Ellipse disk(Vec3f center, Vec3f normal, float radius, bool two_sided = false) {
  const Vec3f n = detail::unit_or(normal, Vec3f(0.0f));
  Ellipse ellipse;
  ellipse.center = center;
  ellipse.half_u = f32::any_perpendicular(n) * (detail::is_extent(radius) ? radius : 0.0f);
  ellipse.half_v = cross(n, ellipse.half_u);
  ellipse.two_sided = two_sided;
  return ellipse;
}

namespace detail {

inline bool is_usable(const Ellipse& e) {
  const float u = length(e.half_u), v = length(e.half_v);
  return is_place(e.center) && is_extent(u) && is_extent(v) &&
         std::abs(dot(e.half_u, e.half_v)) <= 1e-3f * u * v;
}
inline bool is_usable(const Sphere& s) { return is_place(s.center) && is_extent(s.radius); }
inline bool is_usable(const Tube& t) {
  return is_place(t.from) && is_place(t.to) && is_extent(t.radius) &&
         is_extent(length(t.to - t.from));
}
inline bool is_usable(const Line& l) {
  return is_place(l.from) && is_place(l.to) && is_extent(length(l.to - l.from));
}

// The lights as the shading dialect has them.

inline f32::Ellipse dialect_of(const Ellipse& e) {
  return {e.center, e.half_u, e.half_v, e.two_sided ? 1.0f : 0.0f};
}
inline f32::Sphere dialect_of(const Sphere& s) { return {s.center, s.radius}; }
inline f32::Tube dialect_of(const Tube& t) {
  const float caps = t.caps == TubeCaps::none ? 0.0f : t.caps == TubeCaps::flat ? 1.0f : 2.0f;
  return {t.from, t.to, t.radius, caps};
}
inline f32::Line dialect_of(const Line& l) { return {l.from, l.to}; }

} // namespace detail

/// @}

} // namespace openltc
