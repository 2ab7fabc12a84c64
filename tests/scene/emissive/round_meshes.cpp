// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "tests/scene/emissive/round_meshes.h"

#include <cmath>
#include <numbers>

namespace openltc::test {

namespace {

constexpr double k_pi = std::numbers::pi;

scene::Mesh finished(scene::Mesh mesh) {
  mesh.name = "lamp";
  mesh.normals.assign(mesh.positions.size(), Vec3f(0, 0, 1)); // shading normals do not matter
  return mesh;
}

} // namespace

scene::Mesh icosphere(int subdivisions) {
  scene::Mesh mesh;
  const float g = float(std::numbers::phi);
  for (const Vec3f p : {Vec3f(-1, g, 0), Vec3f(1, g, 0), Vec3f(-1, -g, 0), Vec3f(1, -g, 0),
                        Vec3f(0, -1, g), Vec3f(0, 1, g), Vec3f(0, -1, -g), Vec3f(0, 1, -g),
                        Vec3f(g, 0, -1), Vec3f(g, 0, 1), Vec3f(-g, 0, -1), Vec3f(-g, 0, 1)})
    mesh.positions.push_back(normalize(p));
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int s = 0; s < subdivisions; ++s) {
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& t : mesh.triangles) {
      std::uint32_t middle[3]; // shared ones are doubled; welding joins them
      for (std::size_t c = 0; c < 3; ++c) {
        middle[c] = std::uint32_t(mesh.positions.size());
        mesh.positions.push_back(normalize(mesh.positions[t[c]] + mesh.positions[t[(c + 1) % 3]]));
      }
      finer.push_back({t[0], middle[0], middle[2]});
      finer.push_back({t[1], middle[1], middle[0]});
      finer.push_back({t[2], middle[2], middle[1]});
      finer.push_back({middle[0], middle[1], middle[2]});
    }
    mesh.triangles = finer;
  }
  return finished(mesh);
}

scene::Mesh uv_sphere(std::uint32_t rings, std::uint32_t segments, double end_rad) {
  scene::Mesh mesh;
  for (std::uint32_t r = 0; r <= rings; ++r)
    for (std::uint32_t s = 0; s <= segments; ++s) {
      const double theta = k_pi * r / rings, phi = 2 * k_pi * s / segments;
      mesh.positions.push_back(Vec3f(float(std::sin(theta) * std::cos(phi)), float(std::cos(theta)),
                                     float(-std::sin(theta) * std::sin(phi))));
    }
  for (std::uint32_t r = 0; r < rings && k_pi * (r + 1) / rings <= end_rad; ++r)
    for (std::uint32_t s = 0; s < segments; ++s) {
      const std::uint32_t a = r * (segments + 1) + s, b = a + segments + 1;
      if (r != 0) mesh.triangles.push_back({a, b, a + 1});
      if (r + 1 != rings) mesh.triangles.push_back({a + 1, b, b + 1});
    }
  return finished(mesh);
}

scene::Mesh disk_mesh(std::uint32_t corners, double x, double y) {
  scene::Mesh mesh;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const double angle = 2 * k_pi * i / corners;
    mesh.positions.push_back(Vec3f(float(x * std::cos(angle)), float(y * std::sin(angle)), 0));
    mesh.triangles.push_back({corners, i, (i + 1) % corners});
  }
  mesh.positions.push_back(Vec3f(0));
  return finished(mesh);
}

scene::Mesh cylinder_mesh(std::uint32_t corners, double length, int ends, double share) {
  scene::Mesh mesh;
  const auto at = [&](std::uint32_t i, double x) {
    const double angle = 2 * k_pi * share * i / corners;
    return Vec3f(float(x), float(std::cos(angle)), float(std::sin(angle)));
  };
  for (std::uint32_t i = 0; i < corners; ++i) {
    const std::uint32_t k = std::uint32_t(mesh.positions.size());
    for (const Vec3f p : {at(i, 0), at(i, length), at(i + 1, length), at(i + 1, 0)})
      mesh.positions.push_back(p);
    mesh.triangles.push_back({k, k + 2, k + 1});
    mesh.triangles.push_back({k, k + 3, k + 2});
    for (int end = 0; end < ends; ++end) {
      const std::uint32_t c = std::uint32_t(mesh.positions.size());
      mesh.positions.push_back(Vec3f(end == 0 ? 0 : float(length), 0, 0));
      if (end == 0)
        mesh.triangles.push_back({c, k + 3, k});
      else
        mesh.triangles.push_back({c, k + 1, k + 2});
    }
  }
  return finished(mesh);
}

scene::Mesh together(scene::Mesh a, const scene::Mesh& b, Vec3f offset) {
  const std::uint32_t first = std::uint32_t(a.positions.size());
  for (const Vec3f p : b.positions)
    a.positions.push_back(p + offset);
  for (const auto& t : b.triangles)
    a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return finished(a);
}

scene::Mesh transformed(scene::Mesh mesh, double angle_rad, Vec3d scale, Vec3d offset) {
  const Vec3d axis = normalize(Vec3d(0.3, -0.5, 0.8));
  for (Vec3f& p : mesh.positions) {
    const Vec3d v(double(p.x) * scale.x, double(p.y) * scale.y, double(p.z) * scale.z);
    const Vec3d turned = v * std::cos(angle_rad) + cross(axis, v) * std::sin(angle_rad) +
                         axis * (dot(axis, v) * (1 - std::cos(angle_rad)));
    p = to_float(turned + offset);
  }
  return mesh;
}

} // namespace openltc::test
