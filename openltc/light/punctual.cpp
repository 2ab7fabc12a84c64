// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/punctual.h"

#include "openltc/light/emitter.h"

#include <cmath>

namespace openltc::light {

Status validate(const PunctualLight& light) {
  const auto wrong = [&](const char* what) { return wrong_light(light.name, what); };
  if (!is_place(light.position)) return wrong("the position is not within 4e8 m of the scene");
  if (!is_finite(light.intensity) || !is_non_negative(light.intensity))
    return wrong("the intensity is negative or not finite");
  if (!std::isfinite(light.range) || light.range < 0) return wrong("the range is negative");
  if ((light.type != PunctualType::point || light.profile) &&
      (!is_finite(light.direction) || !is_unit(light.direction)))
    return wrong("the direction is not unit");
  if (light.type == PunctualType::spot && !(light.cos_outer <= light.cos_inner))
    return wrong("the inner cone is wider than the outer one");
  if (light.profile && (!is_finite(light.right) || !is_unit(light.right) ||
                        !(std::abs(dot(light.right, light.direction)) <= 1e-3f)))
    return wrong("the profile's axis right is not unit and perpendicular to the direction");
  return Success{};
}

} // namespace openltc::light
