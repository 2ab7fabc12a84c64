// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Facets moved into one plane, as a polygon light is made of them.

#pragma once

#include "openltc/light/light.h"
#include "openltc/scene/emissive/facet_planes.h"
#include "openltc/scene/emissive/outline.h"
#include "openltc/scene/weld.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace openltc::scene {

/// Triangles in one plane, counter-clockwise about its normal, that overlap nowhere.
struct FlatPart {
  std::vector<Vec3d> points; ///< relative to Extent::center
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> source; ///< triangle of the mesh that each is, or is a part of
  Vec3d normal{0, 0, 1};             ///< unit
  double deviation = 0;              ///< metres by which the facets' corners left the plane
  double stretch = 1;                ///< area of the facets over that of their image in the plane
  /// The triangles overlap so much that their union is too much work; they are then as they were.
  bool is_tangled = false;
};

/// The facets of `plane`, moved into the plane through them: area-weighted normal and centre.
/// Where they overlap the union is what is left.
FlatPart flatten(const WeldedMesh& mesh, const FacetPlane& plane, const Extent& extent);

/// Sum of the areas of the triangles, square metres.
double area_of(const FlatPart& part);

/// The outline of the part: see trace_outline.
std::vector<Ring> outline_of(const FlatPart& part, double tolerance, double straight);

/// Cuts a part along edges of its triangles until no outline has more than `most_corners`, if that
/// is possible. Nothing is lost: a light tree chooses among parts.
std::vector<FlatPart> split(FlatPart part, std::size_t most_corners, double tolerance,
                            double straight);

/// The polygon with that outline: vertices, ring_end, normal and surface_deviation.
light::PolygonLight polygon_of(const FlatPart& part, const std::vector<Ring>& rings,
                               const Extent& extent);

} // namespace openltc::scene
