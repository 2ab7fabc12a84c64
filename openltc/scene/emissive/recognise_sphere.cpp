// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Centre: the algebraic least-squares sphere through the vertices p. With q = p - mean(p), the
// sphere |q - c|^2 = r^2 reads 2 q.c + (r^2 - c^2) = |q|^2; its normal equations are
//   sum(q q^T) c = sum(|q|^2 q) / 2,
// exact for vertices on a sphere, however unevenly they are spread.
//
// That the surface covers the sphere once is told by the solid angle of its triangles from the
// centre, which adds up to 4 pi: A. Van Oosterom and J. Strackee, "The Solid Angle of a Plane
// Triangle", 1983, eq. 8.

#include "openltc/scene/emissive/recognise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace openltc::scene {

namespace {

double solid_angle(Vec3d a, Vec3d b, Vec3d c) {
  const double la = length(a), lb = length(b), lc = length(c);
  return 2 * std::atan2(dot(a, cross(b, c)),
                        la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

// Distance from the origin to the plane of a triangle that its perpendicular foot lies in or near.
double distance_to_facet(Vec3d a, Vec3d normal) { return std::abs(dot(a, normal)); }

} // namespace

std::optional<light::SphereLight> recognise_sphere(const Island& island) {
  const std::vector<std::uint32_t> corners = corners_of(island);
  Vec3d mean{0, 0, 0};
  for (const std::uint32_t v : corners)
    mean += island.mesh.points[v] / double(corners.size());
  Vec3d m[3] = {Vec3d(0, 0, 0), Vec3d(0, 0, 0), Vec3d(0, 0, 0)}, b{0, 0, 0};
  for (const std::uint32_t v : corners) {
    const Vec3d q = island.mesh.points[v] - mean;
    m[0] += q * q.x;
    m[1] += q * q.y;
    m[2] += q * q.z;
    b += q * (0.5 * dot(q, q));
  }
  const auto offset = solve(m, b);
  if (!offset) return {};
  const Vec3d center = mean + *offset;

  const double radius = std::sqrt(area_of(island) / (4 * std::numbers::pi));
  const double allowed = island.tolerance * 2 * radius;
  double outside = 0;
  for (const std::uint32_t v : corners) {
    const double d = length(island.mesh.points[v] - center) - radius;
    if (!(std::abs(d) <= allowed)) return {};
    outside = std::max(outside, d);
  }
  double covered = 0;
  for (const std::uint32_t i : island.triangles) {
    const Vec3d a = island.corner(i, 0) - center;
    if (!(radius - distance_to_facet(a, island.mesh.normals[i]) <= allowed)) return {};
    covered += solid_angle(a, island.corner(i, 1) - center, island.corner(i, 2) - center);
  }
  if (island.two_sided) covered = std::abs(covered);
  if (!(std::abs(covered / (4 * std::numbers::pi) - 1) < 1e-6)) return {};
  if (!open_edges(island).empty()) return {};

  light::SphereLight light;
  light.center = Vec3f(float(center.x), float(center.y), float(center.z));
  light.radius = float(radius);
  light.surface_deviation = float(outside);
  return light;
}

} // namespace openltc::scene
