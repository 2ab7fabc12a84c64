// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Where the error of a picture lies: by what its pixels show.

#pragma once

#include "openltc/base/result.h"
#include "openltc/image/image.h"
#include "openltc/scene/scene.h"

#include <string>
#include <vector>

namespace openltc::render {

/// The pixels that show one kind of surface.
struct SurfaceError {
  std::string surface; ///< e.g. "metal, roughness 0.2-0.4, grazing", "emitter", "background"
  int pixels = 0;
  double mean_relative = 0; ///< mean of |a - b| / (|b| + eps) over them
  double max_relative = 0;  ///< largest of a pixel's three channels' mean
  int max_x = 0, max_y = 0; ///< where
  double share = 0;         ///< of the whole picture's error, 0..1
};

/// Sorts the error of picture `a` against `b`, of the same size, by what the middle of each pixel
/// shows of `scene` from `camera`: metal or dielectric, roughness in fifths, seen from the front or
/// grazing (beyond 75 degrees). `eps` is that of image::compare. Largest share first.
Result<std::vector<SurfaceError>> error_by_surface(const scene::Scene& scene,
                                                   const scene::Camera& camera,
                                                   const image::Image& a, const image::Image& b,
                                                   double eps);

} // namespace openltc::render
