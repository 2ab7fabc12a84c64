// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The shadows of area lights in a tile of pixels: for each light and pixel the ratio of its light
// with to its light without shadow, both sampled, which the closed form is multiplied by.
//
// Source: Heitz, Hill, McGuire 2018, "Combining Analytic Direct Illumination and Stochastic
// Shadows".
//
// Most of a picture is wholly lit or wholly in shadow; there a few rays say as much as many. So the
// rays of a light come in two parts. A few go first. Where a pixel's neighbours and it have one
// ratio, it is taken; elsewhere, in a penumbra or at the edge of something, many more follow. The
// decision is of a neighbourhood, some 200 rays, since that of one pixel by itself would be biased:
// a pixel whose first rays happen to agree keeps them, one whose rays do not has its error averaged
// away.

#pragma once

#include "openltc/render/lights/light_tree.h"
#include "openltc/render/point_buffer.h"

#include <cstdint>
#include <vector>

namespace openltc::render {

/// Samples of the shadow ratio for each surface point and light.
struct ShadowPlan {
  struct Samples {
    int of_light = 0, of_brdf = 0;
  };
  int camera_samples = 1; ///< of a pixel
  Samples first;          ///< taken by the first half of a pixel's camera samples, rounded up
  Samples more;           ///< of all camera samples, where the first disagree
};

/// Such that the lit and the dark parts of a picture take about half of `shadow_samples` rays for
/// each pixel and light, and the others three times as many more; at least one of each kind.
ShadowPlan plan_shadows(int shadow_samples, int camera_samples);

/// For one tile; holds working memory.
class ShadowRatio {
public:
  /// Pixels of the tile are `columns` x `columns`. The context's sample counts do not count.
  ShadowRatio(const Kernel& kernel, const KernelContext& context, const ShadowPlan& plan,
              int columns);

  /// Camera samples `first` to `first + count` of all pixels come next; entry n * pixels of
  /// the camera samples is of sample `first` + n. `first` is even.
  void begin(int first, int count);
  /// Adds the closed form and the first rays of a range of points; all but area lights goes to
  /// `samples`.
  void shade(PointBuffer& points, PointBuffer::Range range, const LightChoice& choice,
             std::vector<Vec3f>& samples);
  /// Once all `points` are shaded: takes further rays where they are needed.
  void finish(const PointBuffer& points, std::vector<Vec3f>& samples);

  /// Light of all area lights in a pixel, summed over its camera samples, nits.
  Vec3d light(std::size_t pixel) const;

private:
  // Sums of the kernel, [slot][RatioSum][pixel].
  using Sums = std::vector<float>;
  struct ShadedRange {
    PointBuffer::Range range;
    LightChoice choice;
    std::vector<std::int32_t> slots; // of the lights that have their own
  };

  const float* sums_of(const Sums& sums, std::size_t slot) const {
    return sums.data() + slot * k_ratio_sum_count * std::size_t(pixels_);
  }
  void give_slots(ShadedRange& shaded);
  Lighting lighting(const ShadedRange& shaded) const;
  void shade_first_rays(const PointBuffer& points, const ShadedRange& shaded,
                        std::vector<Vec3f>& samples);
  void read_ratios(std::size_t slot);
  float light_of(std::size_t slot, std::size_t pixel) const;
  float ratio_spread(int x, int y) const;
  void find_disagreement(const std::vector<Vec3f>& samples);
  void start_round();
  void shade_more_rays(const PointBuffer& points, std::vector<Vec3f>& samples);
  void add_up();
  float radiance(std::size_t slot, int channel) const;

  const Kernel& kernel_;
  KernelContext first_context_, more_context_;
  ShadowPlan plan_;
  int columns_, pixels_;
  int first_sample_ = 0,
      first_count_ = 0; // of a round, and how many of its samples have first rays
  std::vector<std::int32_t> slot_of_light_, light_of_slot_; // below 0: groups of lights
  std::int32_t far_slots_[2] = {-1, -1};
  Sums total_, first_, more_; // the last two of a round; the closed form goes to the first at once
  std::vector<float> weight_, first_weight_; // [pixel], of the points of a round and of those with
                                             // first rays
  bool round_ended_ = false;
  std::vector<ShadedRange> ranges_;
  std::vector<std::uint8_t> wants_more_; // [slot][pixel]
  std::vector<std::uint8_t> slot_wants_more_;
  std::vector<float> ratio_, level_; // [pixel], of one slot; of all light
  PointBuffer chosen_;
};

} // namespace openltc::render
