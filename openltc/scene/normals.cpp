// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Flat normals: glTF 2.0 specification, section 3.7.2.1.

#include "openltc/scene/normals.h"

#include <algorithm>
#include <cmath>

namespace openltc::scene {

namespace {

// Twice the area times the unit normal.
Vec3d area_normal(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const Vec3d a = to_double(mesh.positions[triangle[0]]);
  return cross(to_double(mesh.positions[triangle[1]]) - a,
               to_double(mesh.positions[triangle[2]]) - a);
}

Vec3f unit_or(Vec3d v, Vec3f otherwise) {
  const double l = length(v);
  if (!(l > 0) || !std::isfinite(l)) return otherwise;
  return {float(v.x / l), float(v.y / l), float(v.z / l)};
}

template <class T>
void expand(std::vector<T>& values, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if (values.empty()) return;
  std::vector<T> expanded;
  expanded.reserve(triangles.size() * 3);
  for (const auto& triangle : triangles)
    for (const std::uint32_t corner : triangle)
      expanded.push_back(values[corner]);
  values = std::move(expanded);
}

} // namespace

void make_flat_normals(Mesh& mesh) {
  expand(mesh.positions, mesh.triangles);
  expand(mesh.tex_coord_0, mesh.triangles);
  expand(mesh.tex_coord_1, mesh.triangles);
  expand(mesh.colors, mesh.triangles);
  mesh.tangents.clear();
  mesh.normals.assign(mesh.positions.size(), Vec3f(0, 0, 1));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t first = std::uint32_t(3 * t);
    mesh.triangles[t] = {first, first + 1, first + 2};
    const Vec3f normal = unit_or(area_normal(mesh, mesh.triangles[t]), Vec3f(0, 0, 1));
    for (std::uint32_t c = 0; c < 3; ++c)
      mesh.normals[first + c] = normal;
  }
}

std::size_t repair_normals(Mesh& mesh) {
  const auto is_usable = [](Vec3f n) {
    const double squared = dot(to_double(n), to_double(n));
    return squared > 1e-20 && std::isfinite(squared);
  };
  std::vector<std::size_t> bad;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    if (is_usable(mesh.normals[i]))
      mesh.normals[i] = unit_or(to_double(mesh.normals[i]), Vec3f(0, 0, 1));
    else
      bad.push_back(i);
  }
  if (bad.empty()) return 0;
  std::vector<Vec3d> sums(mesh.positions.size(), Vec3d(0, 0, 0));
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle)
      sums[corner] += area_normal(mesh, triangle);
  for (const std::size_t i : bad)
    mesh.normals[i] = unit_or(sums[i], Vec3f(0, 0, 1));
  return bad.size();
}

std::size_t drop_degenerate_triangles(Mesh& mesh) {
  const auto is_degenerate = [&](const std::array<std::uint32_t, 3>& t) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
    const double doubled_area = length(area_normal(mesh, t));
    // What single precision cannot tell from a line has no area.
    const double edge =
        std::max(length(to_double(mesh.positions[t[1]]) - to_double(mesh.positions[t[0]])),
                 length(to_double(mesh.positions[t[2]]) - to_double(mesh.positions[t[0]])));
    return !(doubled_area > 1e-12 * edge * edge);
  };
  const std::size_t before = mesh.triangles.size();
  mesh.triangles.erase(std::remove_if(mesh.triangles.begin(), mesh.triangles.end(), is_degenerate),
                       mesh.triangles.end());
  return before - mesh.triangles.size();
}

} // namespace openltc::scene
