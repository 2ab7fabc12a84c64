// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/error_by_surface.h"

#include "openltc/render/camera_rays.h"
#include "openltc/render/ray_scene.h"
#include "openltc/render/surface_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace openltc::render {

namespace {

constexpr int k_roughness_bins = 5;
constexpr float k_grazing_cosine = 0.26f; // 75 degrees

std::string kind_of(const SurfacePoint& p) {
  if (dot(p.emission, p.emission) > 0) return p.lit ? "emitter" : "unlit";
  const bool metal = dot(p.albedo, p.albedo) == 0 && std::max({p.f0.x, p.f0.y, p.f0.z}) > 0.1f;
  const int bin = std::min(int(p.roughness * k_roughness_bins), k_roughness_bins - 1);
  return fmt::format("{}, roughness {:.1f}-{:.1f}, {}", metal ? "metal" : "dielectric",
                     double(bin) / k_roughness_bins, double(bin + 1) / k_roughness_bins,
                     dot(p.normal, p.view) < k_grazing_cosine ? "grazing" : "front");
}

// Kinds of a row of up to sixteen pixels.
void row_kinds(const scene::Scene& scene, const TextureSet& textures, const RayScene& rays,
               const CameraRays& camera, int x, int y, int count, std::string* kinds) {
  RayPacket packet{};
  for (int i = 0; i < count; ++i) {
    const CameraRay ray = camera.ray(float(x + i) + 0.5f, float(y) + 0.5f);
    const Vec3f o = ray.origin, d = ray.direction;
    packet.origin[0][i] = o.x;
    packet.origin[1][i] = o.y;
    packet.origin[2][i] = o.z;
    packet.direction[0][i] = d.x;
    packet.direction[1][i] = d.y;
    packet.direction[2][i] = d.z;
    packet.near[i] = ray.near;
    packet.far[i] = ray.far;
    packet.active[i] = -1;
  }
  const HitPacket hits = rays.intersect(packet);
  for (int i = 0; i < count; ++i) {
    kinds[i] = "background";
    if (hits.mesh[i] < 0) continue;
    const Vec3f d(packet.direction[0][i], packet.direction[1][i], packet.direction[2][i]);
    kinds[i] =
        kind_of(evaluate_surface(scene, textures, std::uint32_t(hits.mesh[i]), hits.triangle[i],
                                 hits.u[i], hits.v[i], d, camera.footprint(hits.distance[i])));
  }
}

} // namespace

Result<std::vector<SurfaceError>> error_by_surface(const scene::Scene& scene,
                                                   const scene::Camera& camera,
                                                   const image::Image& a, const image::Image& b,
                                                   double eps) {
  const TextureSet textures(scene);
  auto rays = RayScene::create(scene, textures);
  if (!rays.ok()) return rays.error();
  const CameraRays camera_rays(camera, a.width, a.height);

  std::map<std::string, SurfaceError> kinds;
  double total = 0;
  for (int y = 0; y < a.height; ++y) {
    std::string kind[RayPacket::k_size];
    for (int x = 0; x < a.width; ++x) {
      const int lane = x % RayPacket::k_size;
      if (lane == 0)
        row_kinds(scene, textures, **rays, camera_rays, x, y,
                  std::min(RayPacket::k_size, a.width - x), kind);
      const Vec3f p = a.rgb(x, y), q = b.rgb(x, y);
      const auto relative = [&](float u, float v) {
        return std::abs(double(u) - double(v)) / (std::abs(double(v)) + eps);
      };
      const double error = (relative(p.x, q.x) + relative(p.y, q.y) + relative(p.z, q.z)) / 3;
      if (!std::isfinite(error)) continue;
      SurfaceError& sum = kinds[kind[lane]];
      ++sum.pixels;
      sum.mean_relative += error;
      total += error;
      if (error >= sum.max_relative) {
        sum.max_relative = error;
        sum.max_x = x;
        sum.max_y = y;
      }
    }
  }

  std::vector<SurfaceError> result;
  for (auto& [kind, sum] : kinds) {
    sum.surface = kind;
    sum.share = total > 0 ? sum.mean_relative / total : 0;
    sum.mean_relative /= sum.pixels;
    result.push_back(sum);
  }
  std::sort(result.begin(), result.end(), [](const SurfaceError& p, const SurfaceError& q) {
    return p.share != q.share ? p.share > q.share : p.surface < q.surface;
  });
  return result;
}

} // namespace openltc::render
