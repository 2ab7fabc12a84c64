// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Any bytes as a MERL file: reading ends in a BRDF that is finite and not negative in every
// direction above the horizon, or in one line that begins with the file's name.

#include "openltc/brdf/merl.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace {

void require(bool promise) {
  if (!promise) std::abort();
}

openltc::Vec3d direction(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto material = openltc::brdf::parse_merl({data, size}, "fuzz");
  if (!material.ok()) {
    require(material.error().message.rfind("fuzz: ", 0) == 0);
    require(material.error().message.find('\n') == std::string::npos);
    return 0;
  }
  for (const double theta_o : {0.0, 0.4, 1.2, 1.5707}) {
    for (const double theta_i : {0.0, 0.4, 1.0, 1.5707}) {
      for (const double phi : {0.0, 1.0, 2.5, 3.14159}) {
        const auto wo = direction(theta_o, 0), wi = direction(theta_i, phi);
        const auto value = material->eval(wo, wi, 0);
        require(std::isfinite(value.scale) && value.scale >= 0 && value.bias == 0);
        const auto turned = material->eval(wo, {wi.x, -wi.y, wi.z}, 0);
        require(std::abs(turned.scale - value.scale) <= 1e-6 * value.scale);
      }
    }
  }
  return 0;
}
