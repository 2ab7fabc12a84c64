// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Luminance and chroma of OpenEXR files, to RGB.

#pragma once

#include "openltc/image/image.h"
#include "openltc/image/primaries.h"

namespace openltc::image {

/// Brings chroma of every second column and line to all of them. `plane` has one channel; its
/// values at even columns and lines (those that `step_x`, `step_y` divide) are samples, the others
/// are overwritten. Steps are 1 or 2.
void reconstruct_chroma(Image& plane, int step_x, int step_y);

/// RGB from Y, RY = (R - Y) / Y and BY = (B - Y) / Y, in place: channels 0, 1 and 2 are Y, RY, BY
/// before and R, G, B after, of the primaries whose luminances make up Y.
void rgb_from_luminance_chroma(Image& image, const ColorMatrix& xyz_from_rgb);

} // namespace openltc::image
