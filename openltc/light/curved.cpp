// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/curved.h"

#include "openltc/light/emitter.h"

#include <cmath>
#include <numbers>

namespace openltc::light {

namespace {

double length_of(Vec3f v) { return length(to_double(v)); }

template <class Light> Vec3f flux_of(const Light& light) {
  return light.radiance * float(exitance_per_radiance(light) * area(light));
}

} // namespace

double area(const SphereLight& light) {
  return 4 * std::numbers::pi * double(light.radius) * double(light.radius);
}

double area(const TubeLight& light) {
  const double r = double(light.radius);
  const double side = 2 * std::numbers::pi * r * length_of(light.to - light.from);
  const double caps = light.caps == TubeCaps::none   ? 0
                      : light.caps == TubeCaps::flat ? 2 * std::numbers::pi * r * r
                                                     : 4 * std::numbers::pi * r * r;
  return side + caps;
}

Vec3f flux_lumens(const SphereLight& light) { return flux_of(light); }
Vec3f flux_lumens(const TubeLight& light) { return flux_of(light); }

float mean_emission(const SphereLight& light) {
  return float(2 / (double(light.cosine_power) + 2));
}

float mean_emission(const TubeLight& light) {
  const double p = double(light.cosine_power);
  const double log_ratio = std::lgamma(p / 2 + 1) - std::lgamma(p / 2 + 1.5);
  return p > 0 ? float(0.5 * std::sqrt(std::numbers::pi) * std::exp(log_ratio)) : 1.0f;
}

Status validate(const SphereLight& light) {
  const auto wrong = [&](const char* what) { return wrong_light(light.name, what); };
  if (!is_place(light.center)) return wrong("the centre is not within 4e8 m of the scene");
  if (!is_extent(double(light.radius))) return wrong("the radius is not between 1e-12 and 1e8 m");
  return validate_emitter(light);
}

Status validate(const TubeLight& light) {
  const auto wrong = [&](const char* what) { return wrong_light(light.name, what); };
  if (!is_place(light.from) || !is_place(light.to))
    return wrong("an end is not within 4e8 m of the scene");
  if (!is_extent(double(light.radius))) return wrong("the radius is not between 1e-12 and 1e8 m");
  if (!is_extent(length_of(light.to - light.from)))
    return wrong("the length is not between 1e-12 and 1e8 m");
  return validate_emitter(light);
}

} // namespace openltc::light
