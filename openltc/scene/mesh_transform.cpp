// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/mesh_transform.h"

#include "openltc/scene/normals.h"

#include <algorithm>
#include <cmath>

namespace openltc::scene {

std::pair<Vec3d, Vec3d> box_of(std::span<const Vec3f> positions, const Transform& to_world) {
  Vec3d lower = to_double(positions[0]), upper = lower;
  const auto extend = [](Vec3d& low, Vec3d& high, Vec3d p) {
    low = Vec3d(std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z));
    high = Vec3d(std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z));
  };
  for (const Vec3f p : positions)
    extend(lower, upper, to_double(p));
  const Vec3d center = to_world.point((lower + upper) * 0.5);
  const Vec3d half = (upper - lower) * 0.5;
  const auto reach = [&](double x, double y, double z) {
    return std::abs(x) * half.x + std::abs(y) * half.y + std::abs(z) * half.z;
  };
  const auto* c = to_world.column;
  const Vec3d moved(reach(c[0].x, c[1].x, c[2].x), reach(c[0].y, c[1].y, c[2].y),
                    reach(c[0].z, c[1].z, c[2].z));
  return {center - moved, center + moved};
}

void apply_transform(Mesh& mesh, const Transform& to_world) {
  const bool mirrors = to_world.determinant() < 0;
  double largest = 0;
  for (Vec3f& p : mesh.positions) {
    largest =
        std::max({largest, std::abs(double(p.x)), std::abs(double(p.y)), std::abs(double(p.z))});
    p = to_float(to_world.point(to_double(p)));
  }
  const auto* column = to_world.column;
  const double scale = std::max({length(column[0]), length(column[1]), length(column[2])});
  mesh.rounding = float(largest * scale * std::exp2(-24));
  for (Vec3f& n : mesh.normals) {
    const Vec3d world = to_world.normal(to_double(n)) * (mirrors ? -1.0 : 1.0);
    const double l = length(world);
    n = l > 0 && std::isfinite(l) ? to_float(world / l) : Vec3f(0, 0, 0); // repaired below
  }
  if (mirrors)
    for (auto& triangle : mesh.triangles)
      std::swap(triangle[1], triangle[2]);
  drop_degenerate_triangles(mesh);
  repair_normals(mesh);
  for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
    Vec4f& t = mesh.tangents[i];
    const Vec3d n = to_double(mesh.normals[i]);
    Vec3d world = to_world.direction(Vec3d(double(t.x), double(t.y), double(t.z)));
    world = world - n * dot(n, world);
    double l = length(world);
    if (!(l > 0) || !std::isfinite(l)) {
      world = cross(n, std::abs(n.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0));
      l = length(world);
    }
    t = Vec4f(float(world.x / l), float(world.y / l), float(world.z / l), mirrors ? -t.w : t.w);
  }
}

} // namespace openltc::scene
