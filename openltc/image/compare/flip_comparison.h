// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// FLIP of two pictures as one number and a map, of whatever kind they are.

#pragma once

#include "openltc/image/compare/flip.h"
#include "openltc/image/compare/metrics.h"
#include "openltc/image/image.h"

#include <cstdint>
#include <optional>
#include <span>

namespace openltc::image {

struct FlipComparisonOptions {
  FlipOptions flip;
  /// Both hold scene-linear radiance: HDR-FLIP over all exposures, or, where `ev100` or
  /// `auto_exposure` says so, LDR-FLIP of both as they are displayed. Otherwise LDR-FLIP.
  bool scene_linear = false;
  std::optional<float> ev100; ///< has a factor that is a number
  bool auto_exposure = false; ///< that of the reference
  /// Pixels that count are not 0; empty: all do.
  std::span<const std::uint8_t> mask;
};

struct FlipComparison {
  Image map; ///< one channel; NaN where either picture is not finite, which does not count
  double mean = 0.0, max = 0.0;
  PixelPlace max_at;
  bool is_hdr = false; ///< HDR-FLIP over these exposures, in stops
  int exposure_count = 0;
  float start_exposure = 0.0f, stop_exposure = 0.0f;
  /// LDR-FLIP of scene-linear pictures: how they were displayed, by Tonemap::neutral.
  std::optional<float> ev100;
};

/// Both pictures have the same, non-zero size; a mask has as many values as they have pixels.
FlipComparison compare_flip(const Image& test, const Image& reference,
                            const FlipComparisonOptions& options);

} // namespace openltc::image
