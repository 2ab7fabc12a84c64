// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/weld.h"

#include "openltc/scene/grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace openltc::scene {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

} // namespace

Extent extent_of(const Mesh& mesh, double weld, double plane) {
  Vec3d lower(1e300, 1e300, 1e300), upper(-1e300, -1e300, -1e300);
  double magnitude = 0;
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      const Vec3d p = to_double(mesh.positions[corner]);
      lower = Vec3d(std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z));
      upper = Vec3d(std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z));
      magnitude = std::max({magnitude, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
  }
  Extent extent;
  extent.center = (lower + upper) * 0.5;
  extent.diagonal = length(upper - lower);
  // Single-precision coordinates are known to 6e-8 of their size, here and in the file; but the
  // tolerances stay small against the mesh, or a small one far away would shrink to nothing.
  // Vertices that are the same in the file are rounded alike and need no more to be joined.
  const double rounding = 2.5e-7 * magnitude;
  extent.weld = weld * extent.diagonal + std::min(rounding, 1e-3 * extent.diagonal);
  extent.plane = plane * extent.diagonal +
                 std::min(std::max(rounding, 4 * double(mesh.rounding)), 1e-2 * extent.diagonal);
  return extent;
}

WeldedMesh weld(const Mesh& mesh, const Extent& extent) {
  constexpr std::uint32_t k_none = 0xFFFFFFFF;
  WeldedMesh welded;
  Grid grid;
  std::vector<std::uint32_t> joined(mesh.positions.size(), k_none);
  const double cell_size = std::max(extent.weld, 1e-30);
  const auto join = [&](std::uint32_t corner) {
    if (joined[corner] != k_none) return joined[corner];
    const Vec3d p = to_double(mesh.positions[corner]) - extent.center;
    const Cell cell = {std::llround(p.x / cell_size), std::llround(p.y / cell_size),
                       std::llround(p.z / cell_size), 0};
    for_neighbours(cell, 3, [&](const Cell& neighbour) {
      const auto found = grid.find(neighbour);
      if (found == grid.end()) return;
      for (const std::uint32_t known : found->second)
        if (joined[corner] == k_none && length(welded.points[known] - p) <= extent.weld)
          joined[corner] = known;
    });
    if (joined[corner] == k_none) {
      joined[corner] = std::uint32_t(welded.points.size());
      welded.points.push_back(p);
      grid[cell].push_back(joined[corner]);
    }
    return joined[corner];
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const Triangle corners = {join(t[0]), join(t[1]), join(t[2])};
    const Vec3d a = welded.points[corners[0]];
    const Vec3d n = cross(welded.points[corners[1]] - a, welded.points[corners[2]] - a);
    const double doubled_area = length(n);
    if (!(doubled_area > extent.weld * extent.weld)) continue;
    welded.triangles.push_back(corners);
    welded.source.push_back(std::uint32_t(i));
    welded.normals.push_back(n / doubled_area);
    welded.areas.push_back(0.5 * doubled_area);
  }
  return welded;
}

WeldedMesh part_of(const WeldedMesh& mesh, const std::vector<std::uint32_t>& members) {
  WeldedMesh part;
  part.points = mesh.points;
  for (const std::uint32_t i : members) {
    part.triangles.push_back(mesh.triangles[i]);
    part.source.push_back(mesh.source[i]);
    part.normals.push_back(mesh.normals[i]);
    part.areas.push_back(mesh.areas[i]);
  }
  return part;
}

std::vector<std::vector<std::uint32_t>> islands_of(const WeldedMesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.points.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root_of = [&](std::uint32_t v) {
    while (parent[v] != v)
      v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t corner : {t[1], t[2]})
      parent[root_of(corner)] = root_of(t[0]);

  constexpr std::uint32_t k_none = 0xFFFFFFFF;
  std::vector<std::uint32_t> island_of_root(mesh.points.size(), k_none);
  std::vector<std::vector<std::uint32_t>> islands;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    std::uint32_t& island = island_of_root[root_of(mesh.triangles[i][0])];
    if (island == k_none) {
      island = std::uint32_t(islands.size());
      islands.emplace_back();
    }
    islands[island].push_back(std::uint32_t(i));
  }
  return islands;
}

} // namespace openltc::scene
