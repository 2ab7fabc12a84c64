// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A picture in few colours: a quarter of the bytes, which a figure's smooth solids do not show.

#pragma once

#include "openltc/base/result.h"
#include "openltc/image/image.h"

#include <array>
#include <cstdint>
#include <vector>

namespace openltc::draw {

/// Up to 256 colours and which of them each pixel has.
struct PaletteImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> indices;                ///< row 0 at the top
  std::vector<std::array<std::uint8_t, 4>> palette; ///< R G B A, straight alpha, display-encoded
};

/// 4 channels, display-encoded, to at most `colors` colours (2..256), chosen for the picture. What
/// is wholly transparent is one of them; no dithering.
PaletteImage reduce_colors(const image::Image& display, int colors = 256);

/// The bytes of a PNG file with that palette: one byte a pixel before compression.
Result<std::vector<std::uint8_t>> encode_png(const PaletteImage& picture);

} // namespace openltc::draw
