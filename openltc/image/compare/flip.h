// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// FLIP: how different two pictures look to somebody who flips between them.
//
// Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference Evaluator
// for Alternating Images", HPG 2020; for scene-linear pictures Andersson, Nilsson, Shirley,
// Akenine-Moller, "Visualizing Errors in Rendered High Dynamic Range Images", Eurographics 2021.
//
// 0 is no visible difference, 1 the largest there is. The mean over the picture is the number that
// the authors recommend where a single one is wanted.
//
// Of both pictures only the first three channels are used (a grey picture counts as RGB). Pixels
// that are NaN or infinite in either are black in both and so count as equal; metrics.h counts
// them.

#pragma once

#include "openltc/image/image.h"

namespace openltc::image {

struct FlipOptions {
  /// Pixels per degree of the viewer's sight, pi / 180 * distance * pixels / width. The default is
  /// the authors': a screen of 3840 pixels, 0.7 m wide, at a distance of 0.7 m.
  float pixels_per_degree = 67.0206f;
};

/// FLIP per pixel, one channel, of display-encoded (sRGB) pictures; values are clamped to [0, 1].
/// Symmetric in `a` and `b`. Both have the same, non-zero size.
Image flip_ldr(const Image& a, const Image& b, const FlipOptions& options = {});

/// Exposures are in stops: a picture is multiplied by 2^exposure.
struct HdrFlip {
  Image map; ///< one channel: the largest FLIP of the pixel over all exposures
  float start_exposure = 0.0f, stop_exposure = 0.0f;
  int exposure_count = 0;
};

/// HDR-FLIP of scene-linear pictures; negative values count as 0. Exposures and their number follow
/// from the maximum and the median luminance of `reference` as in the paper, so it is not
/// symmetric. Both pictures have the same, non-zero size.
HdrFlip flip_hdr(const Image& test, const Image& reference, const FlipOptions& options = {});

/// The mean of all values of a picture, summed in double precision.
double mean_value(const Image& image);

} // namespace openltc::image
