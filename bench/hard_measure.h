// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// How far a picture of a hard scene is from its reference, in numbers that no part of the picture
// can hide from.

#pragma once

#include "bench/hard_reference.h"

#include <optional>

namespace openltc::bench {

/// With a the picture, b the reference and m the mean of b; sums run over pixels and channels.
/// A pixel is lit where the mean of its channels is above k_lit m in a or in b: what glows where it
/// should be black counts too. Its relative error is |a - b| / (b + k_lit m) of those means.
/// Where the reference is black only `flip` and `mean_nits` are there.
struct HardErrors {
  std::optional<double> of_light;         ///< sum |a - b| / sum b
  std::optional<double> median_relative;  ///< over lit pixels
  std::optional<double> p95_relative;     ///< over lit pixels
  std::optional<double> energy;           ///< sum a / sum b - 1
  std::optional<double> noise_over_error; ///< see below
  double flip = 0;                        ///< mean HDR-FLIP
  double mean_nits = 0;                   ///< of a
};

inline constexpr double k_lit = 0.01;

HardErrors hard_errors(const image::Image& picture, const HardReference& reference);

/// How much of the error may be noise of the reference: the larger of two ratios, that of the sums
/// of |noise| and |a - b|, and that of the medians of the relative noise and error of lit pixels.
/// The noise of the mean of two halves is half of what they differ by. Nothing where the reference
/// is black.
std::optional<double> noise_over_error(const image::Image& picture, const HardReference& reference);

} // namespace openltc::bench
