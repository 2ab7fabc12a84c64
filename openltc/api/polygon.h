// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Polygon lights: any planar outline, concave or convex, with holes or without, of one part or
// more.

#pragma once

#include "openltc/api/polygon_packing.h"
#include "openltc/api/vectors.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace openltc {

/// \addtogroup lights
/// @{

/// A planar light bounded by one or more closed outlines. Owns its arrays; copies are independent.
/// Made once, it is constant, and threads may share it.
///
/// World space, metres. Seen from the emitting side, outer rings run counter-clockwise and holes
/// clockwise: the light emits along its normal, and with `two_sided` against it too, the same
/// radiance in every direction (Lambert's emitter).
///
/// What cannot be shaded lights nothing, and error() says why.
class Polygon {
public:
  /// No outline: lights nothing.
  Polygon() = default;

  /// A rectangle, or parallelogram, around `center`: half_u and half_v lead from there to the
  /// middles of two neighbouring sides. Emits along half_u x half_v.
  static Polygon rectangle(Vec3f center, Vec3f half_u, Vec3f half_v, bool two_sided = false) {
    return from_vertices({center - half_u - half_v, center + half_u - half_v,
                          center + half_u + half_v, center - half_u + half_v},
                         two_sided);
  }

  /// One ring of three vertices or more, not closed by repeating the first.
  static Polygon from_vertices(const std::vector<Vec3f>& vertices, bool two_sided = false) {
    return Polygon(vertices, {std::uint32_t(vertices.size())}, two_sided);
  }

  /// Several rings: outlines, which run counter-clockwise, and holes, clockwise, in any order.
  static Polygon from_rings(const std::vector<std::vector<Vec3f>>& rings, bool two_sided = false) {
    std::vector<Vec3f> vertices;
    std::vector<std::uint32_t> ring_end;
    for (const std::vector<Vec3f>& ring : rings) {
      vertices.insert(vertices.end(), ring.begin(), ring.end());
      ring_end.push_back(std::uint32_t(vertices.size()));
    }
    return Polygon(vertices, ring_end, two_sided);
  }

  /// Null, or what is wrong with the outline: a text that lives as long as the program.
  const char* error() const { return error_; }
  bool usable() const { return error_ == nullptr; } ///< whether there is no error

  float area() const { return packed_.area; } ///< square metres, of one side; 0 when not usable
  /// Whether it emits against its normal too.
  bool two_sided() const { return packed_.view.two_sided; }
  /// Unit, towards the emitting side; world space.
  Vec3f normal() const {
    const float* n = packed_.view.normal;
    return {n[0], n[1], n[2]};
  }
  /// What the shading dialect reads; valid as long as this polygon is neither changed nor
  /// destroyed.
  const PolygonView& view() const { return packed_.view; }

private:
  Polygon(const std::vector<Vec3f>& vertices, const std::vector<std::uint32_t>& ring_end,
          bool two_sided) {
    Vec3d normal(0, 0, 0);
    error_ = find_error(vertices, ring_end, normal);
    if (error_) return;
    // The length of the sum of area vectors is the area that the rings' senses say; that of the
    // triangles goes by parity.
    const double signed_area = length(normal);
    PackedPolygon packed =
        pack_polygon(vertices, ring_end, to_float(normal / signed_area), two_sided);
    if (packed.view.point_count == 0)
      error_ = "the outline has no area";
    else if (std::abs(double(packed.area) - signed_area) > 1e-3 * signed_area)
      error_ = "outlines cross, or a hole runs the same way round as what it is in";
    else
      packed_ = std::move(packed);
  }

  /// Also finds the sum of the rings' area vectors.
  static const char* find_error(const std::vector<Vec3f>& vertices,
                                const std::vector<std::uint32_t>& ring_end, Vec3d& area_vector) {
    if (vertices.empty()) return "there are no vertices";
    if (vertices.size() > 1000000) return "there are more than a million vertices";
    double extent = 0, magnitude = 0;
    const Vec3d origin = to_double(vertices[0]);
    for (const Vec3f& p : vertices) {
      if (!detail::is_place(p)) return "a vertex is not finite, or further than 4e8 m away";
      extent = std::max(extent, length(to_double(p) - origin));
      magnitude = std::max(magnitude, length(to_double(p)));
    }
    if (!(extent <= 2 * double(k_max_extent))) return "the outline is larger than 2e8 m";
    std::size_t begin = 0;
    for (const std::uint32_t end : ring_end) {
      if (end < begin + 3) return "a ring has fewer than three vertices";
      const Vec3d first = to_double(vertices[begin]);
      for (std::size_t i = begin + 1; i + 1 < end; ++i)
        area_vector +=
            cross(to_double(vertices[i]) - first, to_double(vertices[i + 1]) - first) * 0.5;
      begin = end;
    }
    const double area = length(area_vector);
    if (!(area > double(k_min_extent) * double(k_min_extent))) return "the outline has no area";
    // Planar within rounding of the coordinates, or 1e-4 of the extent.
    for (const Vec3f& p : vertices)
      if (std::abs(dot(to_double(p) - origin, area_vector)) >
          (1e-4 * extent + 1e-6 * magnitude) * area)
        return "the vertices are not in one plane";
    return nullptr;
  }

  PackedPolygon packed_;
  const char* error_ = "there is no outline";
};

/// @}

} // namespace openltc
