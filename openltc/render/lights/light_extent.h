// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights, and groups of them, as bounds see them.

#pragma once

#include "openltc/light/light.h"
#include "openltc/light/packed_polygon.h"

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

/// What a group of one-sided Lambertian polygons looks like from afar: the moments, about a point
/// in its middle, of its area vectors times radiance, dm = L n dA. Those of first and second order
/// are kept once for all channels, as if the group were of one colour, and those of second order as
/// if it were of one normal; what that is off by stands beside them.
struct FarLight {
  Vec3f center{0, 0, 0};
  Vec3f moment[3]; ///< integral of dm, nits m2, for r, g and b
  /// Columns of the integral of dm (p - center)^T, nits m3, the three channels together.
  Vec3f first[3] = {Vec3f(0), Vec3f(0), Vec3f(0)};
  Vec3f channel{0, 0, 0}; ///< each channel's share of that
  /// Mean of (p - center)(p - center)^T by |dm| of all channels, m2: xx yy zz yz xz xy.
  float covariance[6] = {0, 0, 0, 0, 0, 0};
};

/// Sizes of the moments of all channels together, nits m2.
double power_of(const FarLight& far);

/// What a far form errs by is bounded with, each for r, g and b.
struct FarError {
  Vec3f first{0, 0, 0};        ///< Frobenius norm of the first moments, nits m3
  Vec3f first_error{0, 0, 0};  ///< Frobenius norm of what channel * first is off by, nits m3
  Vec3f second_error{0, 0, 0}; ///< the same of moment times covariance, nits m4
  Vec3f second{0, 0, 0};       ///< integral of |p - center|^2 |dm|, nits m4
  Vec3f third{0, 0, 0};        ///< at least the integral of |p - center|^3 |dm|, nits m5
  bool valid = false;          ///< there is a far form
  bool planar = true; ///< whether all lies in one plane, a point being before all of it or none
};

/// Stands for infinite: the radiance of a line light, which has no width; a bound that says
/// nothing.
inline constexpr float k_unbounded = 1.0e20f;

/// A light, or a group of them.
struct TreeLight {
  LightExtent extent;
  FarError far_error; ///< valid for one-sided Lambertian polygons only
  FarLight far;
};

/// A light as bounds see it.
/// `packed` is of the same light, whose numbers it has.
TreeLight tree_light(const light::PolygonLight& light, const light::PackedPolygon& packed);
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
