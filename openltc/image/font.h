// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Text for pictures: the printable characters of ASCII as a bitmap font of 5x9 dots.

#pragma once

#include "openltc/image/image.h"

#include <string>
#include <string_view>

namespace openltc::image {

/// Dots of a character cell at scale 1: 5 columns and one of space; 7 rows down to the base line
/// and 2 below it.
inline constexpr int k_glyph_advance = 6;
inline constexpr int k_glyph_height = 9;
inline constexpr int k_glyph_ascent = 7;

/// Width of a line of text in pixels, without the space behind its last character.
int text_width(std::string_view text, int scale);

/// Draws a line of text with its upper left corner at (x, y); a dot becomes scale x scale pixels.
/// What lies outside of the picture is left out; a character outside of ASCII becomes '?'.
void draw_text(Image& image, int x, int y, std::string_view text, Vec3f color, int scale = 1);

/// The text if it fits into `width` pixels, else its end behind "..." (the end of a path says more
/// than its beginning).
std::string fit_text(std::string_view text, int width, int scale);

} // namespace openltc::image
