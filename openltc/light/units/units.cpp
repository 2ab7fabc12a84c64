// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Sources: ISO 80000-7 (quantities of light); ISO 2720:1974 (exposure meters); KHR_lights_punctual
// (the spot's cone). The integrals stand with the functions.

#include "openltc/light/units/units.h"

#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/emitter.h"
#include "openltc/light/line.h"
#include "openltc/light/photometry/ies.h"
#include "openltc/light/polygon.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace openltc::light {

namespace {

double length_of(Vec3f v) { return length(to_double(v)); }

Error wrong(const char* quantity, double value, const char* what) {
  return Error{fmt::format("{} {} {}", quantity, value, what)};
}

bool is_quantity(double value) { return std::isfinite(value) && value >= 0; }
bool is_factor(double value) { return std::isfinite(value) && value > 0; }

Result<double> in_range(const char* quantity, double value) {
  if (std::isfinite(value)) return value;
  return wrong(quantity, value, "is too large to convert");
}

// A size or power that is no good gives no area and so no light.
double usable(double per_radiance) { return is_factor(per_radiance) ? per_radiance : 0; }

// Integral over the half circle of cos^(p+1): sqrt(pi) G(p/2 + 1) / G(p/2 + 3/2).
double half_circle(double p) {
  return std::sqrt(std::numbers::pi) *
         std::exp(std::lgamma(0.5 * p + 1) - std::lgamma(0.5 * p + 1.5));
}

// Integral over the visible hemisphere of a unit sphere of cos^p times its projected area.
double visible_sphere(double p) { return 2 * std::numbers::pi / (p + 2); }

Result<double> from_exposure(double ev100, double constant) {
  if (!std::isfinite(ev100)) return wrong("the exposure value", ev100, "is not finite");
  return in_range("the exposure value", std::exp2(ev100) * (constant / 100));
}

Result<double> to_exposure(const char* quantity, double value, double constant) {
  if (!is_factor(value)) return wrong(quantity, value, "is not greater than zero");
  return std::log2(value) - std::log2(constant / 100);
}

Status check_incidence(double distance, double cos_incidence) {
  if (!is_factor(distance)) return wrong("the distance", distance, "is not greater than zero");
  if (!(cos_incidence > 0) || cos_incidence > 1)
    return wrong("the cosine of incidence", cos_incidence, "is not in (0, 1]");
  return Success{};
}

} // namespace

Result<double> scale_quantity(const char* quantity, double value, double factor) {
  if (!is_quantity(value)) return wrong(quantity, value, "is negative or not finite");
  if (!is_factor(factor))
    return Error{fmt::format("{} has no counterpart: the light has no extent to emit", quantity)};
  return in_range(quantity, value * factor);
}

Result<double> divide_quantity(const char* quantity, double value, double factor) {
  if (!is_quantity(value)) return wrong(quantity, value, "is negative or not finite");
  if (!is_factor(factor))
    return Error{fmt::format("{} has no counterpart: the light has no extent to emit", quantity)};
  return in_range(quantity, value / factor);
}

namespace {

using Convert = Result<double> (*)(const char*, double, double);

Result<Vec3f> each_channel(const char* quantity, Vec3f value, double factor, Convert convert) {
  Vec3f result;
  for (float Vec3f::*channel : {&Vec3f::x, &Vec3f::y, &Vec3f::z}) {
    const Result<double> converted = convert(quantity, double(value.*channel), factor);
    if (!converted.ok()) return converted.error();
    if (*converted > double(std::numeric_limits<float>::max()))
      return wrong(quantity, double(value.*channel), "is too large to convert");
    result.*channel = float(*converted);
  }
  return result;
}

} // namespace

Result<Vec3f> scale_quantity(const char* quantity, Vec3f value, double factor) {
  return each_channel(quantity, value, factor, scale_quantity);
}

Result<Vec3f> divide_quantity(const char* quantity, Vec3f value, double factor) {
  return each_channel(quantity, value, factor, divide_quantity);
}

Result<double> lumens_from_watts(double power_watts, double efficacy) {
  if (!is_factor(efficacy)) return wrong("the efficacy", efficacy, "is not greater than zero");
  return scale_quantity("the power", power_watts, efficacy);
}

Result<double> watts_from_lumens(double flux_lumens, double efficacy) {
  if (!is_factor(efficacy)) return wrong("the efficacy", efficacy, "is not greater than zero");
  return divide_quantity("the flux", flux_lumens, efficacy);
}

Result<double> exitance_from_luminance(double luminance_nits, double cosine_power) {
  if (!is_quantity(cosine_power))
    return wrong("the cosine power", cosine_power, "is negative or not finite");
  return scale_quantity("the luminance", luminance_nits, 2 * std::numbers::pi / (cosine_power + 2));
}

Result<double> luminance_from_exitance(double exitance, double cosine_power) {
  if (!is_quantity(cosine_power))
    return wrong("the cosine power", cosine_power, "is negative or not finite");
  return divide_quantity("the exitance", exitance, 2 * std::numbers::pi / (cosine_power + 2));
}

Result<double> illuminance_from_intensity(double intensity_candela, double distance,
                                          double cos_incidence) {
  if (const Status status = check_incidence(distance, cos_incidence); !status.ok())
    return status.error();
  return scale_quantity("the intensity", intensity_candela, cos_incidence / distance / distance);
}

Result<double> intensity_from_illuminance(double illuminance_lux, double distance,
                                          double cos_incidence) {
  if (const Status status = check_incidence(distance, cos_incidence); !status.ok())
    return status.error();
  return divide_quantity("the illuminance", illuminance_lux, cos_incidence / distance / distance);
}

Result<double> luminance_from_ev100(double ev100) {
  return from_exposure(ev100, k_meter_reflected);
}
Result<double> ev100_from_luminance(double luminance_nits) {
  return to_exposure("the luminance", luminance_nits, k_meter_reflected);
}
Result<double> illuminance_from_ev100(double ev100) {
  return from_exposure(ev100, k_meter_incident);
}
Result<double> ev100_from_illuminance(double illuminance_lux) {
  return to_exposure("the illuminance", illuminance_lux, k_meter_incident);
}

double flux_per_radiance(const PolygonLight& light) {
  return usable(exitance_per_radiance(light) * area(light));
}
double flux_per_radiance(const EllipseLight& light) {
  return usable(exitance_per_radiance(light) * area(light));
}
double flux_per_radiance(const SphereLight& light) {
  return usable(exitance_per_radiance(light) * area(light));
}
double flux_per_radiance(const TubeLight& light) {
  return usable(exitance_per_radiance(light) * area(light));
}

double intensity_per_radiance(const PolygonLight& light) { return usable(area(light)); }
double intensity_per_radiance(const EllipseLight& light) { return usable(area(light)); }

double intensity_per_radiance(const SphereLight& light) {
  const double r = double(light.radius);
  return usable(r * r * visible_sphere(double(light.cosine_power)));
}

double intensity_per_radiance(const TubeLight& light) {
  const double r = double(light.radius), p = double(light.cosine_power);
  const double side = r * length_of(light.to - light.from) * half_circle(p);
  return usable(side + (light.caps == TubeCaps::round ? r * r * visible_sphere(p) : 0));
}

double flux_per_intensity(const LineLight& light) {
  return usable(std::numbers::pi * std::numbers::pi * length_of(light.to - light.from));
}

double flux_per_intensity(const PunctualLight& light) {
  if (light.type == PunctualType::directional) return 0;
  // A cone's rim has a least width, as in shading.
  const double outer = double(light.cos_outer);
  const double inner = std::max(double(light.cos_inner), outer + 1e-4);
  const bool spot = light.type == PunctualType::spot;
  if (!light.profile)
    return usable(spot ? 2 * std::numbers::pi * (1 - inner + (inner - outer) / 3)
                       : 4 * std::numbers::pi);
  const IesProfile& profile = *light.profile;
  if (!spot) return usable(profile.flux_lumens / profile.max_candela);

  // Rings of equal solid angle of the profile's mean over the azimuth, times the cone.
  constexpr int rings = 8192;
  double sum = 0;
  for (int i = 0; i < rings; ++i) {
    const double c = 1 - 2 * (i + 0.5) / rings;
    const double ramp = std::clamp((c - outer) / (inner - outer), 0.0, 1.0);
    if (ramp > 0) sum += ramp * ramp * mean_candela(profile, std::acos(c));
  }
  return usable(sum / rings * 4 * std::numbers::pi / profile.max_candela);
}

} // namespace openltc::light
