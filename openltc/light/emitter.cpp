// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/emitter.h"

#include "openltc/base/quote.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace openltc::light {

bool is_finite(Vec3f v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool is_place(Vec3f p) { // false for NaN
  constexpr float k_limit = float(4 * k_max_metres);
  return std::abs(p.x) <= k_limit && std::abs(p.y) <= k_limit && std::abs(p.z) <= k_limit;
}

bool is_extent(double metres) { return metres > 1e-12 && metres <= k_max_metres; }

bool is_non_negative(Vec3f v) { return v.x >= 0 && v.y >= 0 && v.z >= 0; }

bool is_unit(Vec3f v) { return std::abs(length(to_double(v)) - 1) < 1e-3; }

Error wrong_light(const std::string& name, const char* what) {
  return Error{fmt::format("light \"{}\": {}", quote(name), what)};
}

double exitance_per_radiance(const Emitter& light) {
  const double sides = light.two_sided ? 2 : 1;
  return sides * 2 * std::numbers::pi / (double(light.cosine_power) + 2);
}

Status validate_emitter(const Emitter& light) {
  if (!is_finite(light.radiance) || !is_non_negative(light.radiance))
    return wrong_light(light.name, "the radiance is negative or not finite");
  if (!std::isfinite(light.cosine_power) || light.cosine_power < 0)
    return wrong_light(light.name, "the cosine power is negative or not finite");
  return Success{};
}

} // namespace openltc::light
