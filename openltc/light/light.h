// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Lights in photometric units, in world space, as the importer finds them and shading uses them.
//
// Lengths are metres, radiance is in nits (cd/m2), intensity in candela, illuminance in lux, each
// per linear Rec.709 channel.

#pragma once

#include "openltc/image/texels.h"
#include "openltc/target/vec.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace openltc::light {

/// Metres: the coordinates of a file lie between minus this and this, and radii, lengths and views
/// are no larger. Of what lies within, areas squared are far from the end of single precision.
inline constexpr double k_max_metres = 1e8;

/// What every light with an extent has, whatever its shape.
struct Emitter {
  std::string name;
  Vec3f radiance{0, 0, 0}; ///< nits along the normal of the emitting surface
  /// p: the radiance at the angle t from the normal is radiance * cos(t)^p. 0 is Lambert's emitter,
  /// the same in every direction; larger ones are narrower.
  float cosine_power = 0;
  bool two_sided = false; ///< emits to both sides alike; polygons and ellipses only
  /// Metres by which the surface that the light was made of leaves the light's own shape; shadow
  /// rays stop before it. 0 for lights without a surface.
  float surface_deviation = 0;
  /// Index into Lights::textures of the texture that the radiance is multiplied by, -1 = none;
  /// polygons and ellipses only.
  int texture = -1;
  /// Where the texture lies, world space: its texture coordinates are
  ///   u = (p - texture_corner) . texture_u / |texture_u|^2, v alike; (0, 0) is the upper left
  ///   corner
  /// of the texture's first texel, v grows downwards, and the texture is clamped at its border.
  Vec3f texture_corner{0, 0, 0}, texture_u{1, 0, 0}, texture_v{0, -1, 0};
};

/// A planar emitter bounded by one or more closed outlines.
///
/// Outlines are planar within rounding. Seen from the emitting side, outer rings run
/// counter-clockwise and holes clockwise, so that the signed area along `normal` is positive.
struct PolygonLight : Emitter {
  std::vector<Vec3f> vertices;         ///< all rings one after the other, world space
  std::vector<std::uint32_t> ring_end; ///< one past the last vertex of each ring, ascending
  Vec3f normal{0, 0, 1};               ///< unit, world space, towards the emitting side
};

/// A flat ellipse; a disk when both semi-axes are equally long. Emits along half_u x half_v.
struct EllipseLight : Emitter {
  Vec3f center{0, 0, 0};
  Vec3f half_u{1, 0, 0}, half_v{0, 1, 0}; ///< semi-axes, perpendicular, world space
};

/// A sphere. Emits outwards; no light reaches points inside.
struct SphereLight : Emitter {
  Vec3f center{0, 0, 0};
  float radius = 1; ///< metres
};

enum class TubeCaps {
  none, ///< the lateral surface alone, which emits outwards
  flat, ///< a solid cylinder
  round ///< a capsule: a hemisphere at each end, beyond the ends of the axis
};

/// A round tube along a straight axis. Emits outwards; no light reaches points inside.
struct TubeLight : Emitter {
  Vec3f from{-0.5f, 0, 0}, to{0.5f, 0, 0}; ///< ends of the axis, world space
  float radius = 0.05f;                    ///< metres
  TubeCaps caps = TubeCaps::round;
};

/// A tube that is too thin to have a width: `radiance` times the tube's diameter is what it is
/// known by, its intensity per length across the axis. `radiance`, `cosine_power` and `two_sided`
/// of the Emitter are unused.
struct LineLight : Emitter {
  Vec3f from{-0.5f, 0, 0}, to{0.5f, 0, 0}; ///< world space
  Vec3f intensity_per_metre{1, 1, 1};      ///< cd/m, seen at a right angle to the line
};

struct IesProfile; // light/photometry/ies.h

enum class PunctualType { point, spot, directional };

/// A light without extent, as KHR_lights_punctual defines it.
struct PunctualLight {
  std::string name;
  PunctualType type = PunctualType::point;
  Vec3f position{0, 0, 0}; ///< world space; unused when directional
  /// Unit, world space, the way the light travels; spot, directional, and any with a profile, of
  /// which it is the aim, where both angles of the file are 0: the nadir of type C.
  Vec3f direction{0, 0, -1};
  /// Candela; lux when directional. With a profile, candela where the profile has its maximum: so
  /// the luminaire as measured has IesProfile::max_candela, times a colour of luminance 1.
  Vec3f intensity{1, 1, 1};
  float range = 0;               ///< metres, 0 = unlimited
  float cos_inner = 1;           ///< spot: full intensity inside
  float cos_outer = 0.70710678f; ///< spot: none outside
  /// Intensity by direction, relative to its maximum, times the cone of a spot. Null: the same in
  /// every direction. Point and spot only.
  std::shared_ptr<const IesProfile> profile;
  /// Unit, world space, perpendicular to `direction`: the profile's horizontal angle 0 of type C;
  /// 90 degrees is cross(right, direction). They are x and y of the light's own frame (ies.h).
  /// Unused without a profile. A node of the glTF extension EXT_lights_ies, which shines along its
  /// -Z, has it along its +X.
  Vec3f right{0, 1, 0};
};

struct Lights {
  std::vector<PolygonLight> polygons;
  std::vector<EllipseLight> ellipses;
  std::vector<SphereLight> spheres;
  std::vector<TubeLight> tubes;
  std::vector<LineLight> lines;
  std::vector<PunctualLight> punctual;
  std::vector<image::Texels> textures; ///< linear Rec.709, row 0 at the top

  /// Calls visit with every light that has an extent, shape by shape.
  template <class Visit> void for_each_area_light(const Visit& visit) const {
    for (const PolygonLight& light : polygons)
      visit(light);
    for (const EllipseLight& light : ellipses)
      visit(light);
    for (const SphereLight& light : spheres)
      visit(light);
    for (const TubeLight& light : tubes)
      visit(light);
    for (const LineLight& light : lines)
      visit(light);
  }

  /// Lights with an extent.
  std::size_t area_light_count() const {
    return polygons.size() + ellipses.size() + spheres.size() + tubes.size() + lines.size();
  }

  bool empty() const { return area_light_count() == 0 && punctual.empty(); }
};

} // namespace openltc::light
