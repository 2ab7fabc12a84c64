// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The scene's triangles in Embree: what a ray meets first, and how much light passes.

#pragma once

#include "openltc/base/result.h"
#include "openltc/render/kernel_types.h"
#include "openltc/render/texture_sampler.h"
#include "openltc/scene/scene.h"

#include <memory>

namespace openltc::render {

/// Sixteen rays, structure of arrays.
struct RayPacket {
  static constexpr int k_size = 16;
  float origin[3][k_size];
  float direction[3][k_size]; ///< unit
  float near[k_size];
  float far[k_size];
  std::int32_t active[k_size]; ///< -1 traced, 0 not
};

/// What a packet met; mesh is -1 where a ray met nothing.
struct HitPacket {
  int mesh[RayPacket::k_size];
  std::uint32_t triangle[RayPacket::k_size];
  float distance[RayPacket::k_size];
  float u[RayPacket::k_size]; ///< barycentric: p = (1-u-v) a + u b + v c
  float v[RayPacket::k_size];
};

/// Acceleration structure over a scene; scene and textures outlive it.
class RayScene {
public:
  static Result<std::unique_ptr<RayScene>> create(const scene::Scene& scene,
                                                  const TextureSet& textures);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// Nearest hits. Masked-out surfaces (alpha test) are passed through; blended ones are hit.
  HitPacket intersect(const RayPacket& rays) const;

  /// Transmittance along shadow rays: masked surfaces by their alpha test, blended ones by
  /// 1 - alpha, others block.
  void trace_shadows(const ShadowRays& rays) const;

private:
  RayScene();
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace openltc::render
