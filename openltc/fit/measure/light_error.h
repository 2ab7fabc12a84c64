// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What errors of lobes mean for light: the integral over a fixed family of random rectangles,
// rho/E by quadrature against the lobe's closed form, and the bound that total variation and the
// error of the amplitude set.

#pragma once

#include "openltc/fit/measure/error.h"
#include "openltc/fit/measure/polygon_integral.h"

#include <array>
#include <cstdint>

namespace openltc::fit {

/// A family of random rectangles, each with a view angle and a roughness. For each rectangle, all
/// uniform: roughness and view angle (along angle_axis) in the bounds below; the centre's direction
/// over the upper hemisphere, its distance in [distance_from, distance_to]; the orientation over
/// all rotations; width and height in [side_from, side_to]. Lengths are relative to one another
/// only. The light need not lie above the horizon as a whole.
struct LightFamily {
  int count = 2000;
  std::uint32_t seed = 2016;
  double roughness_from = 0.06, roughness_to = 1;
  double theta_to_degrees = 89.7;
  table::AngleAxis angle_axis = table::AngleAxis::theta;
  double distance_from = 1, distance_to = 4;
  double side_from = 0.2, side_to = 4;
};

/// One member of the family.
struct LightCase {
  double roughness = 1, cos_theta = 1;
  std::array<Vec3d, 4> corners; ///< shading space, the shaded point at the origin
};

/// Member `index` >= 0; depends on nothing but the family's seed, its bounds and the index.
LightCase light_case(const LightFamily& family, int index);

/// What the quadratures of BRDF, albedo and TV may err by between them, for radiance 1 and albedo
/// 1, before a light counts as a violation of a bound.
inline constexpr double k_light_tolerance = 5e-4;

/// Errors of the integrals over a family, for radiance 1 and albedo 1: the integral of rho/E over
/// the light, 0..1, against that of the lobe. The bounds are checked on the light itself too, as
/// shading makes it where F = 1: n1 D against rho.
struct LightError {
  int count = 0;
  double rmse = 0;
  double mean = 0;       ///< of |error|
  double p95 = 0;        ///< of |error|
  double max = 0;        ///< of |error|
  double bias = 0;       ///< mean of lobe minus BRDF, signed
  double mean_light = 0; ///< mean of the BRDF's integral: how much light there is to err about
  /// Lights with |n1 D - rho| > LobeError::bound or |D - rho/E| > TV, by more than
  /// k_light_tolerance.
  int violations = 0;
  /// Largest |n1 D - rho| / LobeError::bound where that is > 1e-3: how much of it is used.
  double of_bound = 0;
};

/// Measures several sets of lobes on the same lights. Does not depend on the number of threads.
/// Fails as measure_maps does.
Result<std::vector<LightError>> measure_lights(const brdf::Brdf& brdf,
                                               std::span<const MeasuredLobes> candidates,
                                               const LightFamily& family);

} // namespace openltc::fit
