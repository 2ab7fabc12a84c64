// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Source: OpenUSD, schema UsdLux, LightAPI, CylinderLight and DistantLight.

#include "openltc/light/units/usdlux.h"

#include "openltc/light/units/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace openltc::light {

namespace {

// intensity * 2^exposure * color * factor.
Result<Vec3f> emitted(const UsdLuxEmission& emission, double factor) {
  if (!std::isfinite(emission.intensity) || emission.intensity < 0)
    return Error{fmt::format("inputs:intensity {} is negative or not finite", emission.intensity)};
  if (!std::isfinite(emission.exposure))
    return Error{fmt::format("inputs:exposure {} is not finite", emission.exposure)};
  const double scale = emission.intensity * std::exp2(emission.exposure) * factor;
  if (!std::isfinite(scale))
    return Error{fmt::format("inputs:exposure {} is too large", emission.exposure)};
  // Black, or too dark for a number: no error, so its factor is not asked for.
  if (scale == 0) return scale_quantity("inputs:color", emission.color * 0.0f, 1);
  return scale_quantity("inputs:color", emission.color, scale);
}

// The emission of a value that is intensity * 2^exposure * color * factor.
Result<UsdLuxEmission> emission_of(const char* quantity, Vec3f value, double exposure,
                                   bool normalize, double factor) {
  if (!std::isfinite(exposure))
    return Error{fmt::format("the exposure {} is not finite", exposure)};
  const Result<Vec3f> checked = scale_quantity(quantity, value, 1);
  if (!checked.ok()) return checked.error();
  UsdLuxEmission emission;
  emission.exposure = exposure;
  emission.normalize = normalize;
  const float largest = std::max({value.x, value.y, value.z});
  const Result<double> intensity =
      divide_quantity(quantity, double(largest), std::exp2(exposure) * factor);
  if (!intensity.ok()) return intensity.error();
  emission.intensity = *intensity;
  if (largest > 0) emission.color = value / largest;
  return emission;
}

Status check_area(double area) {
  if (std::isfinite(area) && area > 0) return Success{};
  return Error{fmt::format("inputs:normalize: the light's area {} is not greater than zero", area)};
}

// Illuminance over intensity * 2^exposure.
Result<double> distant_factor(bool normalize, double angle_degrees) {
  const Result<double> size = usdlux_distant_size_factor(angle_degrees);
  if (!size.ok() || !normalize) return size;
  return 1.0;
}

} // namespace

Result<Vec3f> luminance_from_usdlux(const UsdLuxEmission& emission, double area) {
  if (!emission.normalize) return emitted(emission, 1);
  if (const Status status = check_area(area); !status.ok()) return status.error();
  return emitted(emission, 1 / area);
}

Result<UsdLuxEmission> usdlux_from_luminance(Vec3f luminance_nits, double exposure, bool normalize,
                                             double area) {
  if (!normalize) return emission_of("the luminance", luminance_nits, exposure, false, 1);
  if (const Status status = check_area(area); !status.ok()) return status.error();
  return emission_of("the luminance", luminance_nits, exposure, true, 1 / area);
}

Result<double> usdlux_distant_size_factor(double angle_degrees) {
  if (!std::isfinite(angle_degrees))
    return Error{fmt::format("inputs:angle {} is not finite", angle_degrees)};
  const double t = std::clamp(angle_degrees * std::numbers::pi / 360, 0.0, std::numbers::pi);
  const double sine = std::sin(t);
  // Below this the square underflows: as small as a point.
  if (t < 1e-100) return 1.0;
  return t <= std::numbers::pi / 2 ? std::numbers::pi * sine * sine
                                   : std::numbers::pi * (2 - sine * sine);
}

Result<Vec3f> illuminance_from_usdlux_distant(const UsdLuxEmission& emission,
                                              double angle_degrees) {
  const Result<double> factor = distant_factor(emission.normalize, angle_degrees);
  if (!factor.ok()) return factor.error();
  return emitted(emission, *factor);
}

Result<UsdLuxEmission> usdlux_distant_from_illuminance(Vec3f illuminance_lux, double exposure,
                                                       bool normalize, double angle_degrees) {
  const Result<double> factor = distant_factor(normalize, angle_degrees);
  if (!factor.ok()) return factor.error();
  return emission_of("the illuminance", illuminance_lux, exposure, normalize, *factor);
}

} // namespace openltc::light
