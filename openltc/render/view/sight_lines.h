// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Which points of a scene see each other, roughly: to choose a view, not to shade one.

#pragma once

#include "openltc/base/result.h"
#include "openltc/render/ray_scene.h"
#include "openltc/scene/scene.h"

#include <memory>
#include <span>

namespace openltc::render {

/// A segment between two points, world space.
struct SightLine {
  Vec3d from, to;
  bool is_free = false; ///< set by SightLines::trace
};

/// The scene's larger triangles, without textures: alpha masks and faint blended surfaces hide
/// nothing.
class SightLines {
public:
  static Result<SightLines> create(const scene::Scene& scene);

  enum class Blocks {
    what_is_seen, ///< surfaces that show `to` a side which can be seen: fronts, or any if two-sided
    all           ///< every surface, as for light
  };
  /// Finds out which lines are free, but for a ten-thousandth of their length at both ends. What
  /// lies beyond 1e15 m in any coordinate blocks nothing, and lines to there are free.
  void trace(std::span<SightLine> lines, Blocks blocks) const;

  /// Metres from `origin` along `direction` (unit) to the first surface that can be seen from
  /// there; `far` where there is none before.
  double free_distance(Vec3d origin, Vec3d direction, double far) const;

private:
  SightLines() = default;
  std::unique_ptr<scene::Scene> large_; // ray_scene_ points into it, and into textures_
  std::unique_ptr<TextureSet> textures_;
  std::unique_ptr<RayScene> ray_scene_;
};

} // namespace openltc::render
