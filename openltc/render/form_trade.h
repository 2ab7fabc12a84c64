// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What each form of the closed form costs, and by how much it errs on a scene: error over time.

#pragma once

#include "openltc/base/progress.h"
#include "openltc/base/result.h"
#include "openltc/render/renderer.h"

#include <array>
#include <optional>
#include <string>

namespace openltc::render {

/// A way to shade by lights with an extent, with the lobes that are built in.
struct TradeForm {
  const char* name; ///< "two lobes, ratio"
  bool two_lobes;
  SpecularForm specular;
};

inline constexpr std::array<TradeForm, 6> k_trade_forms = {{
    {"one lobe", false, SpecularForm::lobe},
    {"one lobe, ratio", false, SpecularForm::ratio},
    {"two lobes", true, SpecularForm::lobe},
    {"two lobes, ratio", true, SpecularForm::ratio},
    {"two lobes or GGX", true, SpecularForm::adaptive},
    {"GGX itself", true, SpecularForm::exact},
}};

/// A number for each of k_trade_forms.
using TradeValues = std::array<double, k_trade_forms.size()>;

/// Nanoseconds for one more quad at a point, of one core, with the kernel of that name: the time of
/// nine quads over a floor less that of one, divided by eight. All forms in turn, the fastest of
/// many rounds. Fails for a kernel that this machine does not have.
Result<TradeValues> time_of_quad(const std::string& kernel = "auto");

struct TradeOptions {
  int width = 192, height = 108; ///< pixels
  int samples = 1024;            ///< of the reference per pixel, even
  int threads = 0;               ///< 0 = all cores
  Progress progress;
};

struct TradeErrors {
  /// Sum over pixels of |picture - reference|, over the reference's sum. Without shadows, through
  /// the middle of each pixel.
  TradeValues of_light{};
  /// The reference's own share in that: half of what its two halves differ by.
  double noise = 0;
};

/// Renders the scene by every form and by the reference; nothing where that is black. Fails as
/// render() does, and for fewer samples than 2.
Result<std::optional<TradeErrors>>
trade_errors(const scene::Scene& scene, const scene::Camera& camera, const TradeOptions& options);

} // namespace openltc::render
