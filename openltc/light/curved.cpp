// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/curved.h"

#include "openltc/light/emitter.h"

#include <cmath>
#include <numbers>

namespace openltc::light {

namespace {

constexpr double k_pi = std::numbers::pi;

double length_of(Vec3f v) { return length(to_double(v)); }

// Whether an axis has a length that shading can square.
bool is_extent(double metres) { return metres > 1e-12 && metres <= k_max_metres; }

template <class Light> Vec3f flux_of(const Light& light) {
  return light.radiance * float(exitance_per_radiance(light) * area(light));
}

} // namespace

double area(const EllipseLight& light) {
  return k_pi * length_of(light.half_u) * length_of(light.half_v);
}

double area(const SphereLight& light) {
  return 4 * k_pi * double(light.radius) * double(light.radius);
}

double area(const TubeLight& light) {
  const double r = double(light.radius);
  const double side = 2 * k_pi * r * length_of(light.to - light.from);
  const double caps = light.caps == TubeCaps::none   ? 0
                      : light.caps == TubeCaps::flat ? 2 * k_pi * r * r
                                                     : 4 * k_pi * r * r;
  return side + caps;
}

Vec3f flux_lumens(const EllipseLight& light) { return flux_of(light); }
Vec3f flux_lumens(const SphereLight& light) { return flux_of(light); }
Vec3f flux_lumens(const TubeLight& light) { return flux_of(light); }

Vec3f flux_lumens(const LineLight& light) {
  return light.intensity_per_metre * float(k_pi * k_pi * length_of(light.to - light.from));
}

float mean_emission(const SphereLight& light) {
  return float(2 / (double(light.cosine_power) + 2));
}

float mean_emission(const TubeLight& light) {
  const double p = double(light.cosine_power);
  const double log_ratio = std::lgamma(p / 2 + 1) - std::lgamma(p / 2 + 1.5);
  return p > 0 ? float(0.5 * std::sqrt(k_pi) * std::exp(log_ratio)) : 1.0f;
}

Status validate(const EllipseLight& light) {
  const auto wrong = [&](const char* what) { return wrong_light(light.name, what); };
  if (!is_place(light.center)) return wrong("the centre is not within 4e8 m of the scene");
  const double u = length_of(light.half_u), v = length_of(light.half_v);
  if (!is_extent(u) || !is_extent(v)) return wrong("a semi-axis is not between 1e-12 and 1e8 m");
  const double across = double(dot(light.half_u, light.half_v));
  if (!(std::abs(across) <= 1e-3 * u * v)) return wrong("the semi-axes are not perpendicular");
  return validate_emitter(light);
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

Status validate(const LineLight& light) {
  const auto wrong = [&](const char* what) { return wrong_light(light.name, what); };
  if (!is_place(light.from) || !is_place(light.to))
    return wrong("an end is not within 4e8 m of the scene");
  if (!is_extent(length_of(light.to - light.from)))
    return wrong("the length is not between 1e-12 and 1e8 m");
  if (!is_finite(light.intensity_per_metre) || !is_non_negative(light.intensity_per_metre))
    return wrong("the intensity per metre is negative or not finite");
  return Success{};
}

} // namespace openltc::light
