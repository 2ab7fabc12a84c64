// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/deform.h"

#include <cmath>
#include <utility>

namespace openltc::scene {

namespace {

Transform mean_transform(const Influences& influences, std::size_t vertex,
                         std::span<const Transform> joints) {
  const std::size_t first = vertex * influences.per_vertex;
  double sum = 0;
  for (std::size_t i = 0; i < influences.per_vertex; ++i)
    sum += double(influences.weights[first + i]);
  if (!(sum > 0)) return joints[influences.joints[first]];
  Transform mean;
  for (Vec3d& column : mean.column)
    column = Vec3d(0, 0, 0);
  for (std::size_t i = 0; i < influences.per_vertex; ++i) {
    const double share = double(influences.weights[first + i]) / sum;
    if (share == 0) continue;
    const Transform& joint = joints[influences.joints[first + i]];
    for (std::size_t c = 0; c < 4; ++c)
      mean.column[c] += joint.column[c] * share;
  }
  return mean;
}

} // namespace

void bend(Mesh& mesh, const Influences& influences, std::span<const Transform> joints) {
  std::vector<bool> is_mirrored(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Transform t = mean_transform(influences, v, joints);
    const bool mirrors = t.determinant() < 0;
    is_mirrored[v] = mirrors;
    mesh.positions[v] = to_float(t.point(to_double(mesh.positions[v])));
    if (!mesh.normals.empty()) {
      const Vec3d n = t.normal(to_double(mesh.normals[v])) * (mirrors ? -1.0 : 1.0);
      const double l = length(n);
      const bool is_usable = l > 0 && std::isfinite(l);
      mesh.normals[v] = is_usable ? to_float(n / l) : Vec3f(0, 0, 0); // to be repaired
    }
    if (!mesh.tangents.empty()) {
      const Vec4f from = mesh.tangents[v];
      const Vec3d along = t.direction(Vec3d(double(from.x), double(from.y), double(from.z)));
      const double l = length(along);
      const Vec3f unit = l > 0 && std::isfinite(l) ? to_float(along / l) : Vec3f(0, 0, 0);
      mesh.tangents[v] = Vec4f(unit.x, unit.y, unit.z, mirrors ? -from.w : from.w);
    }
  }
  for (auto& triangle : mesh.triangles) {
    int mirrored = 0;
    for (const std::uint32_t corner : triangle)
      mirrored += is_mirrored[corner];
    if (mirrored >= 2) std::swap(triangle[1], triangle[2]);
  }
}

} // namespace openltc::scene
