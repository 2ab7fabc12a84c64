// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Any text as an LM-63 and as an EULUMDAT file: reading ends in a profile whose intensities are
// finite and not negative, measured and shaded, or in one line that begins with the file's name.

#include "openltc/light/photometry/photometry.h"
#include "openltc/light/photometry/photometry_summary.h"
#include "openltc/target/shade_f32.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

void require(bool promise) {
  if (!promise) std::abort();
}

void try_as(std::string_view text, const std::string& name) {
  const auto profile = openltc::light::parse_photometry(text, name);
  if (!profile.ok()) {
    require(profile.error().message.rfind(name + ":", 0) == 0);
    require(profile.error().message.find('\n') == std::string::npos);
    return;
  }
  require(std::isfinite(profile->max_candela) && profile->max_candela > 0);
  require(std::isfinite(profile->flux_lumens) && profile->flux_lumens >= 0);
  require(profile->name.find('\n') == std::string::npos);
  for (const std::string& warning : profile->warnings)
    require(warning.rfind(name + ":", 0) == 0 && warning.find('\n') == std::string::npos);
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
  // The rest costs time by the number of directions; small files tell as much.
  if (profile->candela.size() > 400) return;
  for (const double azimuth : {0.0, 90.0}) {
    const auto curve = openltc::light::plane_curve(*profile, azimuth, 1);
    const double beam = openltc::light::angle_within(curve, 0.5);
    const double field = openltc::light::angle_within(curve, 0.1);
    require(beam >= 0 && beam <= field && field <= 360);
  }
  const auto again = openltc::light::parse_ies(openltc::light::to_lm63(*profile), "written.ies");
  // Angles that are closer than ten digits are one when they are written.
  if (again.ok()) require(std::abs(again->max_candela / profile->max_candela - 1) < 1e-6);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try_as(text, "fuzz.ies");
  try_as(text, "fuzz.ldt");
  return 0;
}
