// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What a light shows of its texture, reduced to as many pixels as a use of it needs: of a texture
// of any size no more than that is ever held as floats.

#pragma once

#include "openltc/base/result.h"
#include "openltc/image/texels.h"

#include <string>

namespace openltc::light {

/// The columns and rows from (x0, y0) on of a texture that was reduced to width x height pixels.
struct TexturePart {
  image::Image pixels; ///< 3 channels; neither negative nor infinite
  int x0 = 0, y0 = 0;
  int width = 1, height = 1;

  /// Between the pixels' centres, clamped to the texture; (0, 0) is its upper left corner, (1, 1)
  /// its lower right one. Only where it was asked for.
  Vec3f bilinear(double u, double v) const;
};

/// Coordinates of a texture, as of TexturePart::bilinear.
struct TextureRange {
  double u_low = 0, v_low = 0, u_high = 1, v_high = 1;
};

/// `texture` reduced to columns x rows pixels, no more than it has: each is the mean of what falls
/// into it, values that are negative or not a number being 0. Of these what bilinear can ask for in
/// `range`. An error, which begins with `name`, when memory_budget() has no room for it.
Result<TexturePart> reduced_part(const image::Texels& texture, int columns, int rows,
                                 const TextureRange& range, const std::string& name);

} // namespace openltc::light
