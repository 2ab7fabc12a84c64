// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Surface points collected for one call of the shading kernel.

#pragma once

#include "openltc/render/shading_kernel.h"
#include "openltc/render/surface_point.h"

#include <array>
#include <vector>

namespace openltc::render {

class PointBuffer {
public:
  explicit PointBuffer(std::size_t capacity);

  bool full() const { return count_ == capacity_; }
  std::size_t count() const { return count_; }

  /// Adds a point; its light, times `weight`, belongs to entry `target` of the caller's samples.
  void add(const SurfacePoint& point, std::uint32_t pixel_seed, std::uint32_t sample_index,
           std::uint32_t target, float weight);

  /// Shades all points, adds to `samples` and becomes empty.
  void shade(const Kernel& kernel, const KernelContext& context, std::vector<Vec3f>& samples);

private:
  std::size_t capacity_, count_ = 0;
  std::array<std::vector<float>, k_point_field_count> fields_;
  std::array<std::vector<float>, 3> out_;
  std::vector<std::uint32_t> seed_, index_, target_;
  std::vector<float> weight_;
};

} // namespace openltc::render
