// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/ellipse.h"

#include "openltc/light/emitter.h"

#include <cmath>
#include <numbers>

namespace openltc::light {

double area(const EllipseLight& light) {
  return std::numbers::pi * length(to_double(light.half_u)) * length(to_double(light.half_v));
}

Vec3f flux_lumens(const EllipseLight& light) {
  return light.radiance * float(exitance_per_radiance(light) * area(light));
}

Status validate(const EllipseLight& light) {
  const auto wrong = [&](const char* what) { return wrong_light(light.name, what); };
  if (!is_place(light.center)) return wrong("the centre is not within 4e8 m of the scene");
  const double u = length(to_double(light.half_u)), v = length(to_double(light.half_v));
  if (!is_extent(u) || !is_extent(v)) return wrong("a semi-axis is not between 1e-12 and 1e8 m");
  const double across = double(dot(light.half_u, light.half_v));
  if (!(std::abs(across) <= 1e-3 * u * v)) return wrong("the semi-axes are not perpendicular");
  return validate_emitter(light);
}

} // namespace openltc::light
