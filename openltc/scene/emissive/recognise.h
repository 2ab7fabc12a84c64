// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Round lights in a mesh: whether its facets stand for a sphere, a disk, an ellipse or a cylinder.
//
// The shape that is found has the area of the facets, so that the light's flux stays what it was;
// vertices of a convex mesh then lie a little outside of it, and `surface_deviation` says by how
// much.

#pragma once

#include "openltc/light/light.h"
#include "openltc/scene/weld.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace openltc::scene {

/// Triangles of a mesh that hang together.
struct Island {
  const WeldedMesh& mesh;
  std::span<const std::uint32_t> triangles;
  /// Whether the material emits to both sides; what lies inside a closed shape is not seen then.
  bool two_sided = false;
  /// By how much the facets may leave the shape, relative to its diameter; to the smaller one of an
  /// ellipse.
  double tolerance = 0.01;

  const std::array<std::uint32_t, 3>& triangle(std::uint32_t i) const { return mesh.triangles[i]; }
  Vec3d corner(std::uint32_t i, std::size_t c) const { return mesh.points[mesh.triangles[i][c]]; }
};

using RoundShape =
    std::variant<std::monostate, light::EllipseLight, light::SphereLight, light::TubeLight>;

/// What `island` is, in the coordinates of its mesh, without emission; monostate when none.
/// `plane` is how far, in metres, its corners may be from a plane in which they lie.
RoundShape recognise_shape(const Island& island, double plane);

/// A closed sphere that faces outwards.
std::optional<light::SphereLight> recognise_sphere(const Island& island);
/// The lateral surface of a circular cylinder, which faces outwards, with both ends flat or both
/// open. An open one of two sides is none: its inside would be seen.
std::optional<light::TubeLight> recognise_cylinder(const Island& island);
/// A flat disk or ellipse without holes.
std::optional<light::EllipseLight> recognise_ellipse(const Island& island, double plane);

// What the three have in common.

double area_of(const Island& island);
/// Each corner once, ascending.
std::vector<std::uint32_t> corners_of(const Island& island);
/// Edges that not just two triangles share in opposite directions.
std::vector<std::pair<std::uint32_t, std::uint32_t>> open_edges(const Island& island);
/// x of m x = b for the symmetric matrix with these columns; none when it is singular.
std::optional<Vec3d> solve(const Vec3d (&m)[3], Vec3d b);

} // namespace openltc::scene
