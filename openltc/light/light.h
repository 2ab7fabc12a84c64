// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Lights in photometric units, in world space, as the importer finds them and shading uses them.
//
// Lengths are metres, radiance is in nits (cd/m2), intensity in candela, illuminance in lux, each
// per linear Rec.709 channel.

#pragma once

#include "openltc/target/vec.h"

#include <cstdint>
#include <string>
#include <vector>

namespace openltc::light {

/// A planar Lambertian emitter bounded by one or more closed outlines.
///
/// Outlines are planar within rounding. Seen from the emitting side, outer rings run
/// counter-clockwise and holes clockwise, so that the signed area along `normal` is positive.
struct PolygonLight {
  std::string name;
  std::vector<Vec3f> vertices;         ///< all rings one after the other, world space
  std::vector<std::uint32_t> ring_end; ///< one past the last vertex of each ring, ascending
  Vec3f normal{0, 0, 1};               ///< unit, world space, towards the emitting side
  Vec3f radiance{0, 0, 0};             ///< nits, the same in every direction
  bool two_sided = false;              ///< emits to both sides with the same radiance
  /// Metres by which the surface that the light was made of leaves the light's plane; shadow rays
  /// stop before it. 0 for lights without a surface.
  float surface_deviation = 0;
};

enum class PunctualType { point, spot, directional };

/// A light without extent, as KHR_lights_punctual defines it.
struct PunctualLight {
  std::string name;
  PunctualType type = PunctualType::point;
  Vec3f position{0, 0, 0};   ///< world space; unused when directional
  Vec3f direction{0, 0, -1}; ///< unit, world space, the way the light travels; spot, directional
  Vec3f intensity{1, 1, 1};  ///< candela; lux when directional
  float range = 0;           ///< metres, 0 = unlimited
  float cos_inner = 1;       ///< spot: full intensity inside
  float cos_outer = 0.70710678f; ///< spot: none outside
};

struct Lights {
  std::vector<PolygonLight> polygons;
  std::vector<PunctualLight> punctual;

  bool empty() const { return polygons.empty() && punctual.empty(); }
};

} // namespace openltc::light
