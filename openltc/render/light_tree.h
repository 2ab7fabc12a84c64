// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A tree over a scene's lights that finds the few which matter to a batch of surface points.

#pragma once

#include "openltc/render/light_bound.h"
#include "openltc/render/shading_kernel.h"

#include <cstdint>
#include <span>
#include <vector>

namespace openltc::render {

/// How a batch of surface points is to be lit.
struct LightChoice {
  std::vector<std::int32_t> exact; ///< numbers of the lights to shade one by one, ascending
  std::vector<FarGroup> far;       ///< groups, and single lights, whose shadows are taken together
  double error_nits = 0;           ///< bound of what all this differs from shading every light
  /// Working memory.
  struct Entry {
    float error;
    std::int32_t node;
    LightBound bound;
  };
  std::vector<Entry> cut, leaves;
};

class LightTree {
public:
  LightTree() = default;
  explicit LightTree(std::span<const TreeLight> lights);

  /// Chooses how to light a batch so that the radiance of each point, in the closed form without
  /// shadow, is within `tolerance` nits, in any channel, of that of all lights.
  /// Of the lights to shade one by one, those after the `most_exact` with the largest bounds join
  /// the groups, if they have a far form. Returns the number of bounds that this took.
  std::size_t choose(const BatchBounds& batch, double tolerance, std::size_t most_exact,
                     LightChoice& choice) const;

  /// Typical distance from a light to the next, in metres.
  double spacing() const;

  /// The lights in the order in which the groups hold them, see FarGroup.
  std::span<const std::int32_t> order() const { return order_; }
  /// The running sum of their power, one more than there are lights; 0 for those without far form.
  std::span<const float> cdf() const { return cdf_; }

private:
  struct Node {
    TreeLight light;
    std::int32_t right = 0;          ///< second child, the first is the next node; 0 = leaf
    std::int32_t begin = 0, end = 0; ///< its lights in the order
  };

  void build(std::span<const TreeLight> lights, std::int32_t begin, std::int32_t end);

  std::vector<Node> nodes_;
  std::vector<std::int32_t> order_;
  std::vector<float> cdf_;
};

} // namespace openltc::render
