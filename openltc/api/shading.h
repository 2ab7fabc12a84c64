// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Light that a surface reflects to the viewer, in closed form: no samples, no noise, no shadow.
//
// Sources: Heitz, Dupuy, Hill, Neubelt 2016, "Real-Time Polygonal-Light Shading with Linearly
// Transformed Cosines"; Heitz, Hill 2017, "Real-Time Line- and Disk-Light Shading with Linearly
// Transformed Cosines". Both horizons are clipped exactly (openltc/shade/polygon.glsl and its
// like); the Fresnel reflectance is taken where the light comes from (openltc/shade/surface.glsl).

#pragma once

#include "openltc/api/area_lights.h"
#include "openltc/api/polygon.h"
#include "openltc/api/surface.h"

namespace openltc {

/// \addtogroup closed_form
/// @{

/// Reflected light by what reflects it, per linear Rec.709 channel: in the unit of the light's
/// radiance.
struct ShadedParts {
  Vec3f diffuse{0, 0, 0};  ///< by the Lambertian part of the material
  Vec3f specular{0, 0, 0}; ///< by its microfacets
};

namespace detail {

inline ShadedParts parts_of(const f32::ShadedLight& shaded) {
  return {finite_light(shaded.diffuse), finite_light(shaded.specular)};
}

} // namespace detail

/// \name Parts, of lights with an extent
///
/// Reflected radiance, from a light of radiance 1, by parts. Finite and not negative, whatever
/// comes in. Each part is within what the same light from all directions would give; of a line,
/// whose light is per metre of its width, there is no bound.
/// @{

/// Of a polygon: nothing behind a one-sided one, or in the plane of any.
inline ShadedParts shade_parts(const Surface& surface, const Polygon& light) {
  if (!surface.usable || !light.usable()) return {};
  return detail::parts_of(f32::shade_polygon_parts(surface.point, light.view()));
}

/// Of an ellipse: nothing behind a one-sided one, or in the plane of any.
inline ShadedParts shade_parts(const Surface& surface, const Ellipse& light) {
  if (!surface.usable || !detail::is_usable(light)) return {};
  return detail::parts_of(f32::shade_ellipse_parts(surface.point, detail::dialect_of(light)));
}

/// Of a sphere: nothing inside of it.
inline ShadedParts shade_parts(const Surface& surface, const Sphere& light) {
  if (!surface.usable || !detail::is_usable(light)) return {};
  return detail::parts_of(f32::shade_sphere_parts(surface.point, detail::dialect_of(light)));
}

/// Of a tube: nothing inside of it.
inline ShadedParts shade_parts(const Surface& surface, const Tube& light) {
  if (!surface.usable || !detail::is_usable(light)) return {};
  return detail::parts_of(f32::shade_tube_parts(surface.point, detail::dialect_of(light)));
}

/// Of a line, for 1 cd/m.
inline ShadedParts shade_parts(const Surface& surface, const Line& light) {
  if (!surface.usable || !detail::is_usable(light)) return {};
  return detail::parts_of(f32::shade_line_parts(surface.point, detail::dialect_of(light)));
}

/// @}

/// Reflected radiance: of a Polygon, Ellipse, Sphere or Tube with that radiance, nits as a rule,
/// per linear Rec.709 channel; of a Line with that many cd/m; of a light of punctual_lights.h,
/// which has an intensity of its own, with 1.
template <class Light>
inline Vec3f shade(const Surface& surface, const Light& light, Vec3f radiance = Vec3f(1.0f)) {
  const ShadedParts parts = shade_parts(surface, light);
  return detail::finite_light((parts.diffuse + parts.specular) * radiance);
}

/// @}

} // namespace openltc
