// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/lights/light_level.h"

#include "openltc/base/parallel.h"
#include "openltc/base/sampling.h"
#include "openltc/render/point_buffer.h"
#include "openltc/render/surface_point.h"

#include <algorithm>
#include <vector>

namespace openltc::render {

namespace {

// So many pairs of a ray and a light are enough; 32 rays a row, and some rows.
constexpr int k_most_pairs = 1 << 18;
constexpr int k_packets_across = 2; // of RayPacket::k_size rays each
constexpr int k_columns = k_packets_across * RayPacket::k_size;
constexpr int k_least_rows = 2, k_most_rows = 32;
// Light samples of each pair, where shadows are traced.
constexpr int k_samples = 2;

} // namespace

double light_level_nits(const scene::Scene& scene, const TextureSet& textures, const RayScene& rays,
                        const CameraRays& camera, int width, int height, const Kernel& kernel,
                        const KernelContext& context, int threads) {
  KernelContext level = context;
  // The reference's estimate of light that arrives; without shadows the closed form is that.
  level.integrator = context.trace ? Integrator::reference : Integrator::ltc;
  level.light_nodes = {};
  level.light_samples = k_samples;
  level.brdf_samples = 1;
  const int rows = std::clamp(k_most_pairs / (k_columns * std::max(context.area_light_count, 1)),
                              k_least_rows, k_most_rows);

  std::vector<float> levels(std::size_t(rows * k_columns), 0.0f);
  parallel_for(rows, threads, [&](std::int64_t row) {
    PointBuffer points(k_columns);
    std::vector<Vec3f> radiance(k_columns, Vec3f(0.0f));
    for (int first = 0; first < k_columns; first += RayPacket::k_size) {
      RayPacket packet{};
      for (int i = 0; i < RayPacket::k_size; ++i) {
        const CameraRay ray = camera.ray((float(first + i) + 0.5f) / k_columns * float(width),
                                         (float(row) + 0.5f) / float(rows) * float(height));
        packet.origin[0][i] = ray.origin.x;
        packet.origin[1][i] = ray.origin.y;
        packet.origin[2][i] = ray.origin.z;
        packet.direction[0][i] = ray.direction.x;
        packet.direction[1][i] = ray.direction.y;
        packet.direction[2][i] = ray.direction.z;
        packet.near[i] = ray.near;
        packet.far[i] = ray.far;
        packet.active[i] = -1;
      }
      const HitPacket hits = rays.intersect(packet);
      for (int i = 0; i < RayPacket::k_size; ++i) {
        if (hits.mesh[i] < 0) continue;
        const SurfacePoint point = evaluate_surface(
            scene, textures, std::uint32_t(hits.mesh[i]), hits.triangle[i], hits.u[i], hits.v[i],
            Vec3f(packet.direction[0][i], packet.direction[1][i], packet.direction[2][i]),
            camera.footprint(hits.distance[i]));
        PointTarget target;
        target.sample = std::uint32_t(first + i);
        target.pixel_seed = hash_combine(std::uint32_t(first + i), std::uint32_t(row));
        if (point.lit && point.alpha > 0) points.add(point, target);
      }
    }
    std::vector<float> no_ratio;
    points.shade(kernel, level, radiance, no_ratio, 1);
    for (std::size_t i = 0; i < radiance.size(); ++i)
      levels[std::size_t(row) * k_columns + i] =
          std::max({radiance[i].x, radiance[i].y, radiance[i].z});
  });

  levels.erase(std::remove_if(levels.begin(), levels.end(), [](float v) { return !(v > 0); }),
               levels.end());
  if (levels.empty()) return 0;
  const auto middle = levels.begin() + std::ptrdiff_t(levels.size() / 2);
  std::nth_element(levels.begin(), middle, levels.end());
  return double(*middle);
}

} // namespace openltc::render
