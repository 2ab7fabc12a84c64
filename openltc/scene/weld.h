// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A mesh with equal vertices joined, as whoever asks for its shape needs it.

#pragma once

#include "openltc/scene/scene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace openltc::scene {

/// Size of a mesh and the distances within which its parts count as equal.
struct Extent {
  Vec3d center{0, 0, 0};
  double diagonal = 0;
  double weld = 0;  ///< metres
  double plane = 0; ///< metres
};

/// `weld` and `plane` are relative to the diagonal of the bounding box; the rounding of
/// coordinates, here and in the file, is added, as far as it is small against the diagonal.
Extent extent_of(const Mesh& mesh, double weld, double plane);

/// The mesh with equal vertices joined and relative to the centre, without triangles of no area.
struct WeldedMesh {
  std::vector<Vec3d> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> source; ///< triangle of the mesh
  std::vector<Vec3d> normals;        ///< unit
  std::vector<double> areas;
};

/// Joins the vertices of `mesh` that are closer than extent.weld.
WeldedMesh weld(const Mesh& mesh, const Extent& extent);

/// The triangles `members` of `mesh`, with all of its points.
WeldedMesh part_of(const WeldedMesh& mesh, const std::vector<std::uint32_t>& members);

/// The islands of the mesh: triangles that hang together by vertices, in the order of their first
/// triangle.
std::vector<std::vector<std::uint32_t>> islands_of(const WeldedMesh& mesh);

} // namespace openltc::scene
