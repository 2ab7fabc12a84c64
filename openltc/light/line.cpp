// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/line.h"

#include "openltc/light/emitter.h"

#include <cmath>
#include <numbers>

namespace openltc::light {

Vec3f flux_lumens(const LineLight& light) {
  return light.intensity_per_metre *
         float(std::numbers::pi * std::numbers::pi * length(to_double(light.to - light.from)));
}

Status validate(const LineLight& light) {
  const auto wrong = [&](const char* what) { return wrong_light(light.name, what); };
  if (!is_place(light.from) || !is_place(light.to))
    return wrong("an end is not within 4e8 m of the scene");
  if (!is_extent(length(to_double(light.to - light.from))))
    return wrong("the length is not between 1e-12 and 1e8 m");
  if (!is_finite(light.intensity_per_metre) || !is_non_negative(light.intensity_per_metre))
    return wrong("the intensity per metre is negative or not finite");
  return Success{};
}

} // namespace openltc::light
