// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Any text as an LM-63 file: reading ends in a profile whose intensities are finite and not
// negative, measured and shaded, or in one line that begins with the file's name.

#include "openltc/light/ies.h"
#include "openltc/target/shade_f32.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace {

void require(bool promise) {
  if (!promise) std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto profile = openltc::light::parse_ies(text, "fuzz");
  if (!profile.ok()) {
    require(profile.error().message.rfind("fuzz:", 0) == 0);
    require(profile.error().message.find('\n') == std::string::npos);
    return 0;
  }
  require(std::isfinite(profile->max_candela) && profile->max_candela > 0);
  require(std::isfinite(profile->flux_lumens) && profile->flux_lumens >= 0);
  require(profile->name.find('\n') == std::string::npos);
  for (const double candela : profile->candela)
    require(candela >= 0 && candela <= profile->max_candela);
  for (int j = 0; j <= 16; ++j) {
    for (int i = 0; i <= 16; ++i) {
      const double vertical = j * 0.19635, horizontal = i * 0.3927;
      const double candela = openltc::light::eval_candela(*profile, vertical, horizontal);
      require(candela >= 0 && candela <= profile->max_candela * (1 + 1e-12));
      const double sine = std::sin(vertical);
      const openltc::Vec3f direction(float(sine * std::cos(horizontal)),
                                     float(sine * std::sin(horizontal)), float(std::cos(vertical)));
      const float share = openltc::f32::eval_profile(profile->view(), direction);
      require(share >= 0 && share <= 1.000001f);
    }
  }
  return 0;
}
