// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Colour scales for numbers: equal steps of the number look like equal steps of colour, they are
// read the same by colour-blind people, and survive a black-and-white print.

#pragma once

#include "openltc/image/image.h"

namespace openltc::image {

enum class Colormap {
  magma,    ///< black over purple and orange to pale yellow: nothing is black
  viridis,  ///< dark purple over green to yellow
  blue_red, ///< diverging: blue below, near white at 1/2, red above; same lightness at equal
            ///< distance
};

/// Display-encoded (sRGB) colour of t; t outside of [0, 1] is clamped, NaN counts as 0.
/// The luminance of magma and viridis increases with t; that of blue_red up to 1/2 and then
/// decreases.
Vec3f map_color(Colormap map, float t);

} // namespace openltc::image
