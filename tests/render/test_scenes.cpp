// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "test_scenes.h"

#include "openltc/table/lobe_table.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace openltc::test {

scene::Material diffuse_material(Vec3f color) {
  scene::Material m;
  m.base_color = {color.x, color.y, color.z, 1};
  m.metallic = 0;
  m.roughness = 1;
  m.specular = 0;
  return m;
}

scene::Material glossy_material(Vec3f color, float roughness, bool metal) {
  scene::Material m;
  m.base_color = {color.x, color.y, color.z, 1};
  m.metallic = metal ? 1.0f : 0.0f;
  m.roughness = roughness;
  return m;
}

namespace {

scene::Mesh& add_mesh(scene::Scene& scene, const scene::Material& material) {
  scene.materials.push_back(material);
  scene.meshes.emplace_back();
  scene.meshes.back().material = int(scene.materials.size()) - 1;
  return scene.meshes.back();
}

} // namespace

void add_floor(scene::Scene& scene, float half, float height, const scene::Material& material) {
  scene::Mesh& mesh = add_mesh(scene, material);
  mesh.positions = {
      {-half, height, half}, {half, height, half}, {half, height, -half}, {-half, height, -half}};
  mesh.normals.assign(4, {0, 1, 0});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
}

void add_sphere(scene::Scene& scene, Vec3f center, float radius, const scene::Material& material) {
  scene::Mesh& mesh = add_mesh(scene, material);
  constexpr int rows = 96, columns = 192;
  constexpr float pi = std::numbers::pi_v<float>;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const float theta = pi * float(j) / rows, phi = 2 * pi * float(i) / columns;
      const Vec3f n(std::sin(theta) * std::cos(phi), std::cos(theta),
                    -std::sin(theta) * std::sin(phi));
      mesh.normals.push_back(n);
      mesh.positions.push_back(center + n * radius);
    }
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = j * (columns + 1) + i, b = a + columns + 1;
      if (j > 0) mesh.triangles.push_back({a, b, a + 1});
      if (j + 1 < rows) mesh.triangles.push_back({a + 1, b, b + 1});
    }
}

light::PolygonLight ceiling_light(const std::vector<std::vector<Vec2f>>& rings, float height,
                                  float nits) {
  light::PolygonLight light;
  light.name = "ceiling";
  for (const auto& ring : rings) {
    for (const Vec2f p : ring)
      light.vertices.push_back({p.x, height, p.y});
    light.ring_end.push_back(std::uint32_t(light.vertices.size()));
  }
  light.normal = {0, -1, 0};
  light.radiance = Vec3f(nits);
  return light;
}

light::PolygonLight ceiling_rectangle(float x0, float z0, float x1, float z1, float height,
                                      float nits) {
  // About -y: from +x to +z.
  return ceiling_light({{{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}}}, height, nits);
}

scene::Camera look_at(Vec3f from, Vec3f to, float fov_y_rad) {
  scene::Camera camera;
  camera.position = from;
  camera.forward = normalize(to - from);
  camera.right = normalize(cross(camera.forward, Vec3f(0, 1, 0)));
  camera.up = cross(camera.right, camera.forward);
  camera.fov_y_rad = fov_y_rad;
  return camera;
}

render::Picture rendered(const scene::Scene& scene, const render::RenderOptions& options) {
  auto picture = render::render(scene, scene.cameras.at(0), table::builtin_ggx_table(), options);
  REQUIRE(picture.ok());
  return std::move(*picture);
}

double max_difference(const image::Image& a, const image::Image& b) {
  double d = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i)
    d = std::max(d, std::abs(double(a.data[i]) - double(b.data[i])));
  return d;
}

} // namespace openltc::test
