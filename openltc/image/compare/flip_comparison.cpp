// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/image/compare/flip_comparison.h"

#include "openltc/image/tonemap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace openltc::image {

namespace {

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();

bool is_finite(Vec3f v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// Infinite values would become white; FLIP leaves pixels out that are NaN.
Image displayed(const Image& image, float exposure, Tonemap tonemap) {
  Image out = to_display(image, exposure, tonemap);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (!is_finite(image.rgb(x, y))) std::fill_n(out.pixel(x, y), 3, k_nan);
  return out;
}

// Mean and maximum of the pixels that count; the others become NaN, and are drawn as such, but for
// those that the mask leaves out.
void sum_up(FlipComparison& flip, const Image& a, const Image& b,
            std::span<const std::uint8_t> mask) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < flip.map.data.size(); ++i) {
    if (!mask.empty() && mask[i] == 0) continue;
    const int x = int(i % std::size_t(a.width)), y = int(i / std::size_t(a.width));
    if (!is_finite(a.rgb(x, y)) || !is_finite(b.rgb(x, y))) {
      flip.map.data[i] = k_nan;
      continue;
    }
    const double value = double(flip.map.data[i]);
    ++count;
    flip.mean += value;
    if (value > flip.max || flip.max_at.x < 0) {
      flip.max = value;
      flip.max_at = {x, y};
    }
  }
  if (count > 0) flip.mean /= double(count);
}

} // namespace

FlipComparison compare_flip(const Image& test, const Image& reference,
                            const FlipComparisonOptions& options) {
  FlipComparison flip;
  const bool is_exposed = options.ev100 || options.auto_exposure;
  if (options.scene_linear && !is_exposed) {
    HdrFlip result = flip_hdr(test, reference, options.flip);
    flip.map = std::move(result.map);
    flip.is_hdr = true;
    flip.exposure_count = result.exposure_count;
    flip.start_exposure = result.start_exposure;
    flip.stop_exposure = result.stop_exposure;
  } else {
    // Pictures that were displayed already are only encoded again.
    float exposure = 1.0f;
    if (options.scene_linear) {
      exposure = options.ev100 ? exposure_from_ev100(*options.ev100) : auto_exposure(reference);
      flip.ev100 = ev100_from_exposure(exposure);
    }
    const Tonemap tonemap = options.scene_linear ? Tonemap::neutral : Tonemap::none;
    flip.map = flip_ldr(displayed(test, exposure, tonemap), displayed(reference, exposure, tonemap),
                        options.flip);
  }
  sum_up(flip, test, reference, options.mask);
  return flip;
}

} // namespace openltc::image
