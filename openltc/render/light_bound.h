// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A conservative bound of the light that reaches the viewer from a light, or a group of lights, by
// any surface point of a batch.

#pragma once

#include "openltc/light/light.h"
#include "openltc/render/batch_bounds.h"

#include <type_traits>

namespace openltc::render {

/// What bounds the light of an emitter, or of several: where it lies, where it faces, how much.
struct LightExtent {
  Vec3f lower{0, 0, 0}, upper{0, 0, 0};               ///< box around the surface, world space
  Vec3f normal_lower{0, 0, 0}, normal_upper{0, 0, 0}; ///< box around its emitting normals
  Vec3f radiance{0, 0, 0};                            ///< nits, largest; sum over a group
  Vec3f intensity{0, 0, 0}; ///< candela, radiance times largest projected area; sum over a group
  float area = 0;           ///< square metres, largest projected area; sum over a group
  float cosine_power = 0;   ///< of Emitter; least of a group
};

/// What a group of one-sided Lambertian polygons looks like from afar: a small patch in its centre,
/// whose area vector, times radiance, is the sum of theirs, m = L A n.
struct FarLight {
  Vec3f center{0, 0, 0};
  Vec3f moment[3];       ///< sum of m, nits m2, for r, g and b
  Vec3f first{0, 0, 0};  ///< Frobenius norm of the sum of m (p - center)^T, nits m3, r g b
  Vec3f second{0, 0, 0}; ///< integral of |p - center|^2 over L dA, nits m4, r g b
  bool valid = false;
};

/// Extents of the shapes. `texture_peak` is the largest value of the picture that multiplies the
/// radiance, 1 without one.
LightExtent light_extent(const light::PolygonLight& light, float texture_peak = 1);
LightExtent light_extent(const light::EllipseLight& light, float texture_peak = 1);
LightExtent light_extent(const light::SphereLight& light);
LightExtent light_extent(const light::TubeLight& light);
LightExtent light_extent(const light::LineLight& light);

/// The far form of a polygon light; not valid where its radiance depends on place, direction or
/// side.
FarLight far_light(const light::PolygonLight& light);

/// The extent of two groups together.
LightExtent united(const LightExtent& a, const LightExtent& b);

/// What a bound above it says: nothing is known, as around a line light.
inline constexpr float k_unbounded = 1.0e20f;

/// A light, or a group of them, as bounds want it.
struct TreeLight {
  LightExtent extent;
  FarLight far; ///< not valid for shapes that have none
};

template <class Light> TreeLight tree_light(const Light& light) {
  TreeLight result;
  result.extent = light_extent(light);
  if constexpr (std::is_same_v<Light, light::PolygonLight>) result.far = far_light(light);
  return result;
}

/// What can be said of the light of a group without shading it.
struct LightBound {
  float all = 0;             ///< at least what any point reflects of it, in nits and any channel
  float far_error = 0;       ///< at least the error, at any point, of the group's far form
  bool far_specular = false; ///< whether that form has a specular part; without one it errs less
};

/// Bounds of the radiance, in nits and in any channel, that any point of the batch reflects from
/// the lights of a group together, in the closed form without shadow. At most k_unbounded.
LightBound bound_light(const BatchBounds& batch, const TreeLight& light);

} // namespace openltc::render
