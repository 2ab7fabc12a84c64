// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// PNG files in memory, for documents that hold pictures.

#pragma once

#include "openltc/base/result.h"
#include "openltc/image/palette.h"

#include <cstdint>
#include <vector>

namespace openltc::image {

/// 8 bits a channel, display-encoded values in [0, 1]; 4 channels. Values outside are clamped, NaN
/// becomes 0.
Result<std::vector<std::uint8_t>> png_bytes(const Image& display);

/// With a palette, one byte a pixel before compression.
Result<std::vector<std::uint8_t>> png_bytes(const PaletteImage& picture);

} // namespace openltc::image
