// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights without an extent, as the glTF extension KHR_lights_punctual defines them. The BRDF is
// evaluated in their one direction (GGX itself, not its fitted lobe); there is no shadow.

#pragma once

#include "openltc/api/shading.h"

namespace openltc {

/// \addtogroup lights
/// @{

/// Shines the same in every direction.
struct PointLight {
  Vec3f position{0, 0, 0};  ///< world space, metres
  Vec3f intensity{1, 1, 1}; ///< candela, per linear Rec.709 channel
  float range = 0;          ///< metres from which it has faded to nothing; 0 = unlimited
};

/// Shines in a cone.
struct SpotLight {
  Vec3f position{0, 0, 0};          ///< world space, metres
  Vec3f direction{0, 0, -1};        ///< the way the light travels; any length that is not 0
  Vec3f intensity{1, 1, 1};         ///< candela, along the axis
  float range = 0;                  ///< metres from which it has faded to nothing; 0 = unlimited
  float inner_angle = 0;            ///< radians from the axis: full intensity within
  float outer_angle = 0.785398163f; ///< and none outside; not below inner_angle, up to pi/2
};

/// Shines from far away, in parallel.
struct DirectionalLight {
  Vec3f direction{0, 0, -1};  ///< the way the light travels; any length that is not 0
  Vec3f illuminance{1, 1, 1}; ///< lux, on a surface that faces it
};

/// @}

namespace detail {

/// Light from one unit direction, for an illuminance of 1 on a surface that faces it; `offset`
/// leads to where it comes from.
inline ShadedParts parts_from(const f32::Surface& s, Vec3f wi_world, Vec3f offset) {
  if (f32::hidden_by_triangle(s, offset)) return {};
  const Vec3f wi = f32::to_shading(s.frame, wi_world);
  return {finite_light(s.diffuse * f32::eval_lambert(wi)),
          finite_light(f32::eval_ggx(s.wo, wi, s.alpha, s.f0, s.f90))};
}

inline ShadedParts scaled(const ShadedParts& parts, Vec3f by) {
  return {finite_light(parts.diffuse * by), finite_light(parts.specular * by)};
}

struct PointSeen {
  Vec3f offset, direction;
  float per_intensity; ///< illuminance on a surface that faces the light, per candela
};

inline PointSeen see_point(const f32::Surface& s, Vec3f position, float range) {
  const Vec3f offset = position - s.position;
  const float distance2 = f32::max(dot(offset, offset), 1.0e-12f);
  return {offset, offset * f32::inversesqrt(distance2),
          f32::range_window(distance2, range) / distance2};
}

} // namespace detail

/// \addtogroup closed_form
/// @{

/// \name Parts, of lights without an extent
///
/// Reflected radiance of a light, by parts, for the intensity that it has: nits where intensities
/// are candela and illuminances lux. A light whose place or direction is not finite, or has no
/// length, lights nothing.
/// @{

/// Of a point, by the inverse square of its distance and the window of its range.
inline ShadedParts shade_parts(const Surface& surface, const PointLight& light) {
  if (!surface.usable || !detail::is_place(light.position)) return {};
  const detail::PointSeen seen = detail::see_point(surface.point, light.position, light.range);
  return detail::scaled(detail::parts_from(surface.point, seen.direction, seen.offset),
                        light.intensity * seen.per_intensity);
}

/// Of a spot: the same, times its cone.
inline ShadedParts shade_parts(const Surface& surface, const SpotLight& light) {
  const Vec3f axis = detail::unit_or(light.direction, Vec3f(0.0f));
  if (!surface.usable || !detail::is_place(light.position) || !(dot(axis, axis) > 0.5f)) return {};
  const detail::PointSeen seen = detail::see_point(surface.point, light.position, light.range);
  const float cone = f32::spot_cone(-dot(seen.direction, axis), std::cos(light.inner_angle),
                                    std::cos(light.outer_angle));
  return detail::scaled(detail::parts_from(surface.point, seen.direction, seen.offset),
                        light.intensity * (seen.per_intensity * cone));
}

/// Of light from far away.
inline ShadedParts shade_parts(const Surface& surface, const DirectionalLight& light) {
  const Vec3f axis = detail::unit_or(light.direction, Vec3f(0.0f));
  if (!surface.usable || !(dot(axis, axis) > 0.5f)) return {};
  // Far enough to leave any scene behind, near enough for single precision.
  return detail::scaled(detail::parts_from(surface.point, -axis, axis * -1.0e6f),
                        light.illuminance);
}

/// @}
/// @}

} // namespace openltc
