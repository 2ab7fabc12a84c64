// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Surface points collected for one call of the shading kernel.

#pragma once

#include "openltc/render/kernel_types.h"
#include "openltc/render/surface_point.h"

#include <array>
#include <span>
#include <vector>

namespace openltc::render {

/// Where a point's light goes.
struct PointTarget {
  std::uint32_t sample = 0; ///< entry of the caller's camera samples
  std::uint32_t pixel = 0;  ///< of the tile
  std::uint32_t pixel_seed = 0;
  std::uint32_t sample_index = 0; ///< of the camera sample, in the sequence of its seed
  float weight = 1;               ///< share in the camera sample
};

/// Sums of the shadow ratio, as ShadingBatch wants them, and which part of them to add to.
struct RatioSums {
  std::vector<float>& values;
  int pixel_count;
  ShadingPart part = ShadingPart::both;
  const float* closed = nullptr; ///< see ShadingBatch::closed_sums
};

/// The lights of a batch; see the fields of ShadingBatch.
struct Lighting {
  std::span<const std::int32_t> lights, slots;
  FarSet far[2];
};

/// Surface points per kernel call, at most.
inline constexpr std::size_t k_most_points = 4096;

class PointBuffer {
public:
  explicit PointBuffer(std::size_t capacity);

  bool full() const { return count_ == capacity_; }
  void add(const SurfacePoint& point, const PointTarget& target);

  bool empty() const { return count_ == 0; }
  std::size_t size() const { return count_; }

  /// Some of the points, one at least; `begin` is a multiple of k_batch_padding.
  struct Range {
    std::size_t begin = 0, end = 0;
    std::size_t size() const { return end - begin; }
  };
  Range all() const { return {0, count_}; }

  /// Bounds of the points of a range, perhaps with a few more.
  BatchBounds measure(const Kernel& kernel, const KernelContext& context, Range range);

  /// Orders a range so that `field` is nowhere larger in its first half than in its second; returns
  /// where that one begins. There must be more than k_batch_padding points.
  std::size_t split(Range range, PointField field);

  /// What the i-th point sends to the viewer by itself, nits, largest channel.
  float emission(std::size_t i) const { return emission_[i]; }

  /// Appends about `count` points of a range, evenly chosen, to another buffer that has room; entry
  /// and pixel of the i-th are i, its weight is 1.
  void thin(Range range, std::size_t count, PointBuffer& to) const;

  /// Appends the i-th point to another buffer that has room, with a target of its own.
  void copy(std::size_t i, const PointTarget& target, PointBuffer& to) const;
  PointTarget target(std::size_t i) const {
    return {sample_[i], pixel_[i], seed_[i], index_[i], weight_[i]};
  }

  /// Shades a range as `lighting` says and adds to `samples` and `sums`.
  /// Ranges must be shaded in ascending order.
  void shade(const Kernel& kernel, const KernelContext& context, Range range,
             const Lighting& lighting, std::vector<Vec3f>& samples, RatioSums sums);
  /// Shades all points by all lights and becomes empty.
  void shade(const Kernel& kernel, const KernelContext& context, std::vector<Vec3f>& samples,
             std::vector<float>& ratio_sums, int pixel_count);

  void clear() { count_ = 0; }

private:
  void set_target(std::size_t i, const PointTarget& target);
  ShadingBatch batch(Range range);
  void shade(const Kernel& kernel, const KernelContext& context, Range range,
             const ShadingBatch& batch, std::vector<Vec3f>& samples);

  std::size_t capacity_, count_ = 0;
  std::array<std::vector<float>, k_point_field_count> fields_;
  std::array<std::vector<float>, 3> out_;
  std::vector<std::uint32_t> seed_, index_, pixel_, sample_;
  std::vector<float> weight_, emission_;
  std::vector<std::uint32_t> order_; // of a range, while it is split
  std::vector<float> moved_float_;
  std::vector<std::uint32_t> moved_uint_;
};

} // namespace openltc::render
