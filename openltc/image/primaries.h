// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// From the colours of a file to linear Rec.709, the colours of an Image.

#pragma once

#include "openltc/image/image.h"

#include <array>
#include <optional>

namespace openltc::image {

/// CIE 1931 chromaticities, x and y, of the three primaries and of R = G = B = 1.
struct Primaries {
  std::array<double, 2> red{0.64, 0.33}, green{0.30, 0.60}, blue{0.15, 0.06}, white{0.3127, 0.3290};
};

/// Rows that are multiplied with a column of three colour values.
using ColorMatrix = std::array<std::array<double, 3>, 3>;

/// Whether these are Rec.709's, to what files round them to (a thousandth).
bool is_rec709(const Primaries& primaries);

/// RGB of these primaries to CIE XYZ with Y = 1 for white. Nothing when they span no colours: on a
/// line, not finite, a white without light or outside the triangle.
std::optional<ColorMatrix> xyz_from_rgb(const Primaries& primaries);

/// CIE XYZ to linear Rec.709; no adaptation, so that XYZ of D65 becomes grey.
ColorMatrix rec709_from_xyz();

/// RGB of these primaries to linear Rec.709. R = G = B stays so: another white point is adapted by
/// the Bradford transform, but for the primaries that are CIE XYZ themselves, (1, 0), (0, 1),
/// (0, 0). Nothing when xyz_from_rgb has nothing.
std::optional<ColorMatrix> rec709_from_rgb(const Primaries& primaries);

/// Multiplies the first three channels of every pixel, of 3 or 4 channels.
void multiply_colors(const ColorMatrix& matrix, Image& image);

} // namespace openltc::image
