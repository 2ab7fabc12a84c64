// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A conservative bound of the light that reaches the viewer from a light, or a group of lights, by
// any surface point of a batch.

#pragma once

#include "openltc/render/kernel_types.h"
#include "openltc/render/lights/light_extent.h"

namespace openltc::render {

/// What can be said of the light of a group without shading it.
struct LightBound {
  float all = 0;             ///< at least what any point reflects of it, in nits and any channel
  float likely = 0;          ///< `all` where GGX is as large as its lobes: no bound
  float far_error = 0;       ///< at least the error, at any point, of the group's far form
  float plain_error = 0;     ///< the same of its far form without moments
  bool far_specular = false; ///< whether that form has a specular part; without one it errs less
};

/// The bounds of a batch with four of its directions side by side, which is how they are used: the
/// axes x', y, z' of the mirror frame, and the normal.
struct PreparedBatch {
  explicit PreparedBatch(const BatchBounds& bounds);

  const BatchBounds& bounds; ///< outlives this
  alignas(16) float lower[3][4];
  alignas(16) float upper[3][4]; ///< [x y z][direction]
};

/// Bounds of the radiance, in nits and in any channel, that any point of the batch reflects from
/// the lights of a group together, in the closed form without shadow. At most k_unbounded.
LightBound bound_light(const PreparedBatch& prepared, const LightExtent& extent,
                       const FarError& far);

} // namespace openltc::render
