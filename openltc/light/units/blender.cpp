// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Sources: Blender's Cycles, intern/cycles/kernel/light (the factors of spheres, 1/(4 pi) over
// pi r^2, and of area lights, 1/4 over A) and Eevee (light shape power); glTF-Blender-IO,
// exp/lights.py.

#include "openltc/light/units/blender.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace openltc::light {

namespace {

Status check_positive(const char* what, double value) {
  if (std::isfinite(value) && value > 0) return Success{};
  return Error{fmt::format("{} {} is not greater than zero", what, value)};
}

// Lumens per steradian and m2 over watts.
Result<double> per_watt(const char* what, double size, double watts_share, double efficacy) {
  if (const Status status = check_positive(what, size); !status.ok()) return status.error();
  if (const Status status = check_positive("the efficacy", efficacy); !status.ok())
    return status.error();
  return watts_share * efficacy;
}

Result<double> sphere_factor(double radius, double efficacy) {
  return per_watt("the radius", radius,
                  1 / (4 * std::numbers::pi * std::numbers::pi * radius * radius), efficacy);
}

Result<double> area_factor(double area, double efficacy) {
  return per_watt("the area", area, 1 / (4 * area), efficacy);
}

Result<double> gltf_factor(PunctualType type, GltfLightMode mode) {
  if (mode == GltfLightMode::raw) return 1.0;
  const double share = type == PunctualType::directional ? 1 : 1 / (4 * std::numbers::pi);
  return mode == GltfLightMode::standard ? share * k_efficacy_555nm : share;
}

Result<double> forth(double strength, const Result<double>& factor) {
  return factor.ok() ? scale_quantity("the strength", strength, *factor) : factor;
}

Result<double> back(const char* quantity, double value, const Result<double>& factor) {
  return factor.ok() ? divide_quantity(quantity, value, *factor) : factor;
}

} // namespace

Result<double> luminance_from_blender_sphere(double strength_watts, double radius,
                                             double efficacy) {
  return forth(strength_watts, sphere_factor(radius, efficacy));
}

Result<double> blender_sphere_from_luminance(double luminance_nits, double radius,
                                             double efficacy) {
  return back("the luminance", luminance_nits, sphere_factor(radius, efficacy));
}

Result<double> luminance_from_blender_area(double strength_watts, double area, double efficacy) {
  return forth(strength_watts, area_factor(area, efficacy));
}

Result<double> blender_area_from_luminance(double luminance_nits, double area, double efficacy) {
  return back("the luminance", luminance_nits, area_factor(area, efficacy));
}

Result<double> gltf_intensity_from_blender(double strength, PunctualType type, GltfLightMode mode) {
  return forth(strength, gltf_factor(type, mode));
}

Result<double> blender_from_gltf_intensity(double intensity, PunctualType type,
                                           GltfLightMode mode) {
  return back("the intensity", intensity, gltf_factor(type, mode));
}

} // namespace openltc::light
