// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights, and groups of them, as bounds see them.

#pragma once

#include "openltc/light/light.h"

#include <span>

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
  bool planar = true; ///< whether all lies in one plane, a point being before all of it or none
};

/// Stands for infinite: the radiance of a line light, which has no width; a bound that says
/// nothing.
inline constexpr float k_unbounded = 1.0e20f;

/// A light, or a group of them.
struct TreeLight {
  LightExtent extent;
  FarLight far; ///< valid for one-sided Lambertian polygons only
};

/// A light as bounds see it.
TreeLight tree_light(const light::PolygonLight& light);
TreeLight tree_light(const light::EllipseLight& light);
TreeLight tree_light(const light::SphereLight& light);
TreeLight tree_light(const light::TubeLight& light);
TreeLight tree_light(const light::LineLight& light);

/// The same light with a picture on it, by which its radiance is multiplied from place to place:
/// `peak` its largest values, `mean` those over the light, by channel, of which a hundredth is
/// added for what they are off by. It has no far form.
TreeLight textured(TreeLight light, Vec3f peak, Vec3f mean);

/// A group of lights, one at least.
TreeLight united(std::span<const TreeLight> lights);

} // namespace openltc::render
