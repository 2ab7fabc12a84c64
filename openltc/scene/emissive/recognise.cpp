// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/emissive/recognise.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace openltc::scene {

namespace {

// A tetrahedron is no sphere within any sensible tolerance.
constexpr std::size_t k_fewest_triangles = 8;

} // namespace

double area_of(const Island& island) {
  double sum = 0;
  for (const std::uint32_t i : island.triangles)
    sum += island.mesh.areas[i];
  return sum;
}

std::vector<std::uint32_t> corners_of(const Island& island) {
  std::vector<std::uint32_t> corners;
  for (const std::uint32_t i : island.triangles)
    corners.insert(corners.end(), island.triangle(i).begin(), island.triangle(i).end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> open_edges(const Island& island) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> uses; // forth, back
  for (const std::uint32_t i : island.triangles) {
    const auto& t = island.triangle(i);
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t a = t[c], b = t[(c + 1) % 3];
      ++(a < b ? uses[{a, b}].first : uses[{b, a}].second);
    }
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open;
  for (const auto& [edge, count] : uses)
    if (count != std::pair{1, 1}) open.push_back(edge);
  return open;
}

std::optional<Vec3d> solve(const Vec3d (&m)[3], Vec3d b) {
  // Cramer's rule.
  const double determinant = dot(m[0], cross(m[1], m[2]));
  const double scale = length(m[0]) * length(m[1]) * length(m[2]);
  if (!(std::abs(determinant) > 1e-12 * scale)) return {};
  return Vec3d(dot(b, cross(m[1], m[2])), dot(m[0], cross(b, m[2])), dot(m[0], cross(m[1], b))) /
         determinant;
}

RoundShape recognise_shape(const Island& island, double plane) {
  if (island.triangles.size() < k_fewest_triangles) return {};
  if (const auto ellipse = recognise_ellipse(island, plane)) return *ellipse;
  if (const auto sphere = recognise_sphere(island)) return *sphere;
  if (const auto cylinder = recognise_cylinder(island)) return *cylinder;
  return {};
}

} // namespace openltc::scene
