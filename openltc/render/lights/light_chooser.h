// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// By which lights a tile's points are shaded: ranges of like points, and a choice for each.

#pragma once

#include "openltc/render/lights/light_tree.h"
#include "openltc/render/point_buffer.h"

#include <functional>
#include <vector>

namespace openltc::render {

/// What errors are measured against.
struct LightErrorScale {
  double light_error = 0; ///< allowed, relative to what the picture shows
  double view_nits = 0;   ///< light level of the view, shadows included, see light_level.h
};

/// A choice for the kernel; the slots are the caller's to give. A view of the choice.
Lighting lighting_of(const LightChoice& choice);

/// One for each thread; holds working memory.
class LightChooser {
public:
  /// The tree outlives this.
  LightChooser(const Kernel& kernel, const KernelContext& context, const LightTree& tree,
               LightErrorScale scale);

  /// Splits a range of points until all of it can be lit by one choice, and calls `shade` for each
  /// part, in ascending order. A part's choice is within light_error of what a few of its points
  /// show: what they reflect, shadows included, between a tenth and sixteen times the level of the
  /// view, and what they emit.
  using Shade = std::function<void(PointBuffer::Range, const LightChoice&)>;
  void light(PointBuffer& points, PointBuffer::Range range, const Shade& shade);

private:
  // `level`, in nits, is what the range is taken to show; `measured`, what it was found to.
  void light(PointBuffer& points, PointBuffer::Range range, double level, bool measured,
             const Shade& shade);
  void take_probe(const PointBuffer& points, PointBuffer::Range range);
  // Of the probe: a level that all but a few of its points have.
  double measure_level();
  double darker_emission();
  double darker_level();

  // By what points differ most: turned by a radian counts as much as being apart by the distance of
  // the lights from each other.
  struct Width {
    PointField field = k_position_x;
    double relative = 0; ///< to the distance of the lights from each other
  };
  Width widest_field(const BatchBounds& bounds) const;

  const Kernel& kernel_;
  const KernelContext& context_;
  const LightTree& tree_;
  LightErrorScale scale_;
  double light_spacing_; ///< metres, typical distance from one light to the next
  LightChoice choice_;
  // The few points that are asked what they show.
  PointBuffer probe_;
  std::vector<float> probe_levels_;
  std::vector<Vec3f> probe_radiance_;
  std::vector<float> probe_sums_, far_reach_;
  std::vector<std::int32_t> probe_slots_;
};

} // namespace openltc::render
