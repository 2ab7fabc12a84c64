// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A hash over plane normal and offset finds the candidates, so that the time grows with the number
// of triangles and not with its square.

#include "openltc/scene/emissive/facet_planes.h"

#include "openltc/scene/grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace openltc::scene {

namespace {

using Corners = std::array<std::uint32_t, 3>;

// Facets that differ by little in normal and offset, but lie in planes of their own, are compared
// with each other. After so many comparisons, a second's work, what is left is taken triangle by
// triangle: join_planes puts neighbours together.
constexpr std::size_t k_most_comparisons = 100'000'000;

class PlaneFinder {
public:
  PlaneFinder(const WeldedMesh& mesh, const Extent& extent, double angle_rad, bool two_sided)
      : mesh_(mesh), extent_(extent), two_sided_(two_sided), cos_angle_(std::cos(angle_rad)),
        normal_cell_(1.05 * angle_rad),
        // Normals that differ by the angle shift the offset of a plane through the same point by up
        // to half the diagonal times the angle.
        offset_cell_(extent.diagonal * angle_rad + 2 * extent.plane),
        is_taken_(mesh.triangles.size(), false) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      grid_[cell_of(mesh.normals[i], offset_of(i))].push_back(std::uint32_t(i));
  }

  std::vector<FacetPlane> find() {
    std::vector<std::uint32_t> by_area(mesh_.triangles.size());
    std::iota(by_area.begin(), by_area.end(), 0u);
    std::stable_sort(by_area.begin(), by_area.end(), [&](std::uint32_t a, std::uint32_t b) {
      return mesh_.areas[a] > mesh_.areas[b];
    });
    std::vector<FacetPlane> planes;
    for (const std::uint32_t seed : by_area)
      if (!is_taken_[seed]) planes.push_back(collect(seed));
    return planes;
  }

private:
  double offset_of(std::size_t triangle) const {
    return dot(mesh_.normals[triangle], mesh_.points[mesh_.triangles[triangle][0]]);
  }

  Cell cell_of(Vec3d normal, double offset) const {
    return {std::llround(normal.x / normal_cell_), std::llround(normal.y / normal_cell_),
            std::llround(normal.z / normal_cell_), std::llround(offset / offset_cell_)};
  }

  FacetPlane collect(std::uint32_t seed) {
    FacetPlane plane;
    if (comparisons_ > k_most_comparisons) {
      is_taken_[seed] = true;
      plane.members = {seed};
      plane.triangles = {mesh_.triangles[seed]};
      return plane;
    }
    const Vec3d normal = mesh_.normals[seed];
    const double offset = offset_of(seed);
    gather(normal, offset, normal, offset, false, plane);
    // Light that leaves both sides does not care which side a triangle was drawn from.
    if (two_sided_) gather(-normal, -offset, normal, offset, true, plane);
    std::sort(plane.members.begin(), plane.members.end());
    remove_duplicates(plane, normal);
    return plane;
  }

  void gather(Vec3d key_normal, double key_offset, Vec3d normal, double offset, bool is_reversed,
              FacetPlane& plane) {
    for_neighbours(cell_of(key_normal, key_offset), 4, [&](const Cell& cell) {
      const auto found = grid_.find(cell);
      if (found == grid_.end()) return;
      std::vector<std::uint32_t>& candidates = found->second;
      comparisons_ += candidates.size();
      std::size_t left = 0;
      for (const std::uint32_t candidate : candidates) {
        if (is_taken_[candidate]) continue;
        const double cos_to_plane = dot(mesh_.normals[candidate], normal) * (is_reversed ? -1 : 1);
        if (cos_to_plane >= cos_angle_ && lies_in(candidate, normal, offset)) {
          is_taken_[candidate] = true;
          plane.members.push_back(candidate);
        } else {
          candidates[left++] = candidate;
        }
      }
      candidates.resize(left);
    });
  }

  bool lies_in(std::uint32_t triangle, Vec3d normal, double offset) const {
    for (const std::uint32_t corner : mesh_.triangles[triangle])
      if (!(std::abs(dot(mesh_.points[corner], normal) - offset) <= extent_.plane)) return false;
    return true;
  }

  // A triangle that stands twice in the same place shines once: the camera sees one of them.
  void remove_duplicates(FacetPlane& plane, Vec3d normal) const {
    std::set<Corners> seen;
    std::vector<std::uint32_t> members;
    for (const std::uint32_t member : plane.members) {
      Corners t = mesh_.triangles[member];
      if (dot(mesh_.normals[member], normal) < 0) std::swap(t[1], t[2]);
      Corners sorted = t;
      std::sort(sorted.begin(), sorted.end());
      if (!seen.insert(sorted).second) continue;
      members.push_back(member);
      plane.triangles.push_back(t);
    }
    plane.members = std::move(members);
  }

  const WeldedMesh& mesh_;
  const Extent& extent_;
  bool two_sided_;
  double cos_angle_;
  double normal_cell_;
  double offset_cell_;
  std::vector<bool> is_taken_;
  std::size_t comparisons_ = 0;
  Grid grid_;
};

} // namespace

std::vector<FacetPlane> find_planes(const WeldedMesh& mesh, const Extent& extent, double angle_rad,
                                    bool two_sided) {
  return PlaneFinder(mesh, extent, angle_rad, two_sided).find();
}

} // namespace openltc::scene
