// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A tree over a scene's lights that finds the few which matter to a batch of surface points.

#pragma once

#include "openltc/render/kernel_types.h"
#include "openltc/render/lights/error_queue.h"
#include "openltc/render/lights/light_bound.h"

#include <cstdint>
#include <span>
#include <vector>

namespace openltc::render {

/// How a batch of surface points is to be lit.
struct LightChoice {
  /// A light to shade by itself, or a group to shade in its far form.
  struct Entry {
    float error; ///< of its cheaper form, at most
    std::int32_t node;
    LightBound bound;
    bool plain = false; ///< a far form without moments will do
    /// The share of its light that nothing blocks, 0 to 1, as far as is known.
    float reach = 1;
  };
  std::vector<Entry> entries; ///< the choice; lights by themselves come first
  std::size_t single_count = 0;
  double error_nits = 0; ///< bound of what all this differs from shading every light

  // What arrange() makes of the entries, and whose each is.
  std::vector<std::int32_t> exact; ///< numbers of the lights to shade one by one, ascending
  std::vector<FarGroup> far;       ///< groups, and single lights, whose shadows are taken together
  std::size_t far_open = 0;        ///< the first so many have a reach, the rest have none
  std::vector<std::uint32_t> exact_entry, far_entry;

  // The cut through the tree behind the entries, from which it is refined: lights by themselves,
  // and the others by their errors, those not bounded apart from the sum of those that are.
  std::vector<Entry> singles, dim;
  ErrorQueue<Entry> cut;
  double cut_error = 0;
  int cut_unbounded = 0;
  std::size_t bounded = 0; ///< nodes of the tree whose bounds this took
};

class LightTree {
public:
  LightTree() = default;
  explicit LightTree(std::span<const TreeLight> lights);

  /// Chooses the entries with which to light a batch so that the radiance of each point, in the
  /// closed form without shadow, is within `tolerance` nits, in any channel, of that of all lights.
  void choose(const BatchBounds& batch, double tolerance, LightChoice& choice) const;

  /// The same for the batch of which `choice` is, and a smaller tolerance.
  void refine(const BatchBounds& batch, double tolerance, LightChoice& choice) const;

  /// Says which lights have shadows of their own: the `most_exact` from which most arrives, and
  /// those without far form. All others join the groups. k_all_exact: there are no shadows, and the
  /// lights for which a far form will not do are shaded one by one.
  static constexpr std::size_t k_all_exact = ~std::size_t(0);
  void arrange(std::size_t most_exact, LightChoice& choice) const;

  /// Typical distance from a light to the next, in metres.
  double spacing() const;

  /// The lights in the order in which the groups hold them, see FarGroup.
  std::span<const std::int32_t> order() const { return order_; }
  /// The running sum of their power, one more than there are lights; 0 for those without far form.
  std::span<const float> cdf() const { return cdf_; }
  /// The tree as the reference draws lights from it, see LightNodes.
  std::span<const LightNode> nodes() const { return sampling_nodes_; }

private:
  // What bounds need, side by side.
  struct Node {
    LightExtent extent;
    FarError far_error;
    std::int32_t right = 0;          ///< second child, the first is the next node; 0 = leaf
    std::int32_t begin = 0, end = 0; ///< its lights in the order
  };

  void build(std::span<const TreeLight> lights, std::int32_t begin, std::int32_t end);
  void add_to_cut(const PreparedBatch& batch, std::int32_t node, LightChoice& choice) const;
  FarGroup group_of(const LightChoice::Entry& entry, bool exact) const;

  std::vector<Node> nodes_;
  std::vector<FarLight> far_; // of each node
  std::vector<LightNode> sampling_nodes_;

  std::vector<std::int32_t> order_;
  std::vector<float> cdf_;
};

} // namespace openltc::render
