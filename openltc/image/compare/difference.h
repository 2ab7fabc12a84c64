// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A picture of where two pictures differ, with a title, a scale and numbers on it.

#pragma once

#include "openltc/image/colormap.h"
#include "openltc/image/image.h"

#include <cstdint>
#include <span>
#include <string>

namespace openltc::image {

enum class DifferenceKind {
  relative,        ///< mean over the channels of |a - b| / (|b| + eps)
  absolute,        ///< mean over the channels of |a - b|
  signed_relative, ///< mean over the channels of (a - b) / (|b| + eps): the scale has two sides
};

/// One number per pixel, one channel; NaN where a value of `a` or of the reference `b` is not
/// finite. `eps` as in metrics.h. Both pictures have the same size.
Image difference_map(const Image& a, const Image& b, DifferenceKind kind, double eps);

struct DifferencePictureOptions {
  /// Lines above the picture and below it; shortened at their beginning where they do not fit.
  std::string title, caption;
  Colormap colormap = Colormap::magma;
  /// Value of the scale's upper end; 0 picks a round number (1, 2 or 5 times a power of ten) that
  /// at most 1 % of the pixels exceed. Values beyond the ends get the colour of the end.
  float scale_max = 0.0f;
  /// The scale runs from -scale_max to scale_max instead of from 0.
  bool is_signed = false;
  /// Write the numbers of the scale as percentages.
  bool percent = false;
  /// One value per pixel; pixels with 0 are left out and drawn grey. Empty: none is.
  std::span<const std::uint8_t> mask;
};

/// Colours `map` (one channel), enlarges small maps by a whole number, and adds title, caption and
/// a labelled colour scale. Display-encoded (sRGB) RGB, ready for write_png. Pixels that are NaN
/// are drawn bright green, which no scale contains.
Image difference_picture(const Image& map, const DifferencePictureOptions& options = {});

/// The scale's upper end that difference_picture picks for scale_max = 0; positive.
float automatic_scale_max(const Image& map, std::span<const std::uint8_t> mask = {});

} // namespace openltc::image
