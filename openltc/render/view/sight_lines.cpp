// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/view/sight_lines.h"

#include "openltc/scene/view/backdrop.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace openltc::render {

namespace {

// More triangles hide little more, and their ray structure takes seconds to build.
constexpr std::size_t k_most_triangles = 300000;
constexpr float k_faint_alpha = 0.5f;
constexpr double k_end = 1e-4;            // of a line's length
constexpr int k_most_layers_crossed = 64; // culled surfaces along one line

// Embree's robust traversal has room for coordinates whose squares are floats, and no more.
constexpr double k_largest_coordinate = 1e15;

bool is_traceable(Vec3d p) {
  return std::abs(p.x) < k_largest_coordinate && std::abs(p.y) < k_largest_coordinate &&
         std::abs(p.z) < k_largest_coordinate;
}

bool hides(const scene::Material& material) {
  return material.alpha_mode == scene::AlphaMode::opaque ||
         (material.alpha_mode == scene::AlphaMode::blend && material.base_color.w > k_faint_alpha);
}

// A scene of the triangles that count, their materials reduced to their sides.
std::unique_ptr<scene::Scene> large_triangles(const scene::Scene& scene) {
  std::vector<double> areas;
  for (const scene::Mesh& mesh : scene.meshes)
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      areas.push_back(length(scene::area_vector(mesh, t)));
  double least = 0;
  if (areas.size() > k_most_triangles) {
    const auto nth = areas.begin() + std::ptrdiff_t(k_most_triangles);
    std::nth_element(areas.begin(), nth, areas.end(), std::greater<>());
    least = *nth;
  }
  auto large = std::make_unique<scene::Scene>();
  for (const scene::Material& material : scene.materials) {
    large->materials.emplace_back();
    large->materials.back().double_sided = material.double_sided;
  }
  for (const scene::Mesh& mesh : scene.meshes) {
    if (!hides(scene.materials[std::size_t(mesh.material)]) ||
        !std::all_of(mesh.positions.begin(), mesh.positions.end(),
                     [](Vec3f p) { return is_traceable(to_double(p)); }))
      continue;
    scene::Mesh kept;
    kept.material = mesh.material;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      if (length(scene::area_vector(mesh, t)) >= least) kept.triangles.push_back(mesh.triangles[t]);
    if (kept.triangles.empty()) continue;
    kept.positions = mesh.positions;
    large->meshes.push_back(std::move(kept));
  }
  return large;
}

void set_ray(RayPacket& rays, int i, Vec3d origin, Vec3d direction, double near, double far) {
  const double from[3] = {origin.x, origin.y, origin.z};
  const double along[3] = {direction.x, direction.y, direction.z};
  for (int axis = 0; axis < 3; ++axis) {
    rays.origin[axis][i] = float(from[axis]);
    rays.direction[axis][i] = float(along[axis]);
  }
  rays.near[i] = float(near);
  rays.far[i] = float(far);
  rays.active[i] = -1;
}

/// Whether who looks along `direction` sees this triangle.
bool is_seen(const scene::Scene& scene, int mesh, std::uint32_t triangle, Vec3d direction) {
  const scene::Mesh& of = scene.meshes[std::size_t(mesh)];
  return scene.materials[std::size_t(of.material)].double_sided ||
         dot(scene::area_vector(of, triangle), direction) < 0;
}

} // namespace

Result<SightLines> SightLines::create(const scene::Scene& scene) {
  SightLines lines;
  lines.large_ = large_triangles(scene);
  lines.textures_ = std::make_unique<TextureSet>(*lines.large_);
  Result<std::unique_ptr<RayScene>> rays = RayScene::create(*lines.large_, *lines.textures_);
  if (!rays) return rays.error();
  lines.ray_scene_ = std::move(*rays);
  return lines;
}

void SightLines::trace(std::span<SightLine> lines, Blocks blocks) const {
  constexpr std::size_t n = RayPacket::k_size;
  for (std::size_t begin = 0; begin < lines.size(); begin += n) {
    const std::size_t count = std::min(n, lines.size() - begin);
    RayPacket rays{};
    Vec3d directions[n];
    double lengths[n];
    for (std::size_t i = 0; i < count; ++i) {
      SightLine& line = lines[begin + i];
      lengths[i] = length(line.to - line.from);
      line.is_free = true;
      if (!(lengths[i] > 0) || !is_traceable(line.from) || !is_traceable(line.to)) continue;
      directions[i] = (line.to - line.from) / lengths[i];
      set_ray(rays, int(i), line.from, directions[i], k_end * lengths[i], (1 - k_end) * lengths[i]);
    }
    for (int layer = 0; layer < k_most_layers_crossed; ++layer) {
      const HitPacket hits = ray_scene_->intersect(rays);
      bool any_left = false;
      for (std::size_t i = 0; i < count; ++i) {
        if (!rays.active[i]) continue;
        rays.active[i] = 0;
        if (hits.mesh[i] < 0) continue;
        if (blocks == Blocks::all ||
            is_seen(*large_, hits.mesh[i], hits.triangle[i], -directions[i])) {
          lines[begin + i].is_free = false;
          continue;
        }
        rays.near[i] = hits.distance[i] + float(k_end * lengths[i]); // crossed: it is culled
        rays.active[i] = -1;
        any_left = true;
      }
      if (!any_left) break;
    }
  }
}

double SightLines::free_distance(Vec3d origin, Vec3d direction, double far) const {
  if (!is_traceable(origin) || !(far < k_largest_coordinate)) return far;
  RayPacket rays{};
  set_ray(rays, 0, origin, direction, 0, far);
  for (int layer = 0; layer < k_most_layers_crossed; ++layer) {
    const HitPacket hits = ray_scene_->intersect(rays);
    if (hits.mesh[0] < 0) return far;
    if (is_seen(*large_, hits.mesh[0], hits.triangle[0], direction))
      return double(hits.distance[0]);
    rays.near[0] = hits.distance[0] + float(k_end * far);
  }
  return far;
}

} // namespace openltc::render
