// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Numbers for how far a picture is from its reference.
//
// In all of them `a` is the picture under test and `b` the reference; every sum runs over the n
// values (pixels times the first three channels; one if both are grey) that count. A pixel counts
// unless one of its values is NaN or infinite in `a` or in `b`, or the mask leaves it out; the
// numbers of those are given beside. Sums are in double precision and in a fixed order.

#pragma once

#include "openltc/image/image.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace openltc::image {

/// A mask made of a picture: a pixel counts, 1, where any of its channels is above 0.
std::vector<std::uint8_t> mask_of(const Image& picture);

struct MetricOptions {
  /// Added to b^2 in the relative MSE and to |b| in the mean relative error, in units of the
  /// reference's mean absolute value m: b^2 + (relative_epsilon m)^2, |b| + relative_epsilon m.
  /// So neither depends on the unit of radiance, and black pixels do not divide by zero.
  double relative_epsilon = 0.01;
  /// One value per pixel; pixels with 0 are left out. Empty: none is.
  std::span<const std::uint8_t> mask;
};

/// One pixel where something is largest; x from the left, y from the top. -1 if no pixel counts.
struct PixelPlace {
  int x = -1, y = -1;
};

struct Metrics {
  double mean_a = 0.0;        ///< mean of a
  double mean_b = 0.0;        ///< mean of b
  double bias = 0.0;          ///< mean of a - b: the signed part of the error
  double mae = 0.0;           ///< mean of |a - b|
  double mse = 0.0;           ///< mean of (a - b)^2
  double rmse = 0.0;          ///< sqrt(mse)
  double relative_mse = 0.0;  ///< mean of (a - b)^2 / (b^2 + eps_square)
  double mean_relative = 0.0; ///< mean of |a - b| / (|b| + eps)
  double psnr = 0.0;          ///< 10 log10(peak^2 / mse) dB; infinite for equal pictures
  double psnr_peak = 0.0;     ///< largest |b| that counts: pictures in [0, 1] do not all reach 1
  double max_abs = 0.0;       ///< largest |a - b|
  PixelPlace max_abs_at;      ///< the first pixel that has it, row by row
  double max_relative = 0.0;  ///< largest |a - b| / (|b| + eps)
  PixelPlace max_relative_at;
  double eps = 0.0; ///< relative_epsilon times the mean of |b|; 1e-12 if that is 0

  std::size_t pixel_count = 0;      ///< pixels that count
  std::size_t non_finite_count = 0; ///< pixels left out because a value is NaN or infinite
  std::size_t non_finite_a = 0;     ///< of these, the ones that are so in a
  std::size_t non_finite_b = 0;     ///< of these, the ones that are so in b
  std::size_t masked_count = 0;     ///< pixels left out by the mask
};

/// Both pictures have the same, non-zero size, the mask one value per pixel or none.
/// All numbers are 0 where no pixel counts, and then psnr is infinite.
Metrics compare(const Image& a, const Image& b, const MetricOptions& options = {});

} // namespace openltc::image
