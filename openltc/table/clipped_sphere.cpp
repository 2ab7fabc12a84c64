// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

//
// Sources: Snyder 1996, "Area Light Sources for Real-Time Graphics" (the problem); Heitz & Hill
// 2017, "Real-Time Line- and Disk-Light Shading with Linearly Transformed Cosines" and Hill & Heitz
// 2016, "Real-Time Area Lighting: a Journey from Research to Production" (the table's axes).
//
// The integral of the cosine over a region of the hemisphere is the area of the region's projection
// onto the ground plane, by Green's theorem 1/2 closed integral of x dy - y dx. With s = sigma and
// w the angle from the normal to the cap's centre, the cap's rim is
//   x = cos s sin w + sin s cos w cos p,   y = sin s sin p,
//   z = cos s cos w - sin s sin w cos p,
// so x y' - y x' = sin s cos s sin w cos p + sin^2 s cos w. The rim crosses the horizon at
// cos p0 = cot s cot w, above it for p in (p0, 2 pi - p0), in x at cos s / sin w. Along the horizon
// back to the start the integral is the angle b of the arc, cos b = cos s / sin w. Altogether
//   area = b + sin^2 s cos w (pi - p0) - sin s cos s sin w sin p0,
// and pi sin^2 s cos w where the rim does not reach the horizon.

#include "openltc/table/clipped_sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace openltc::table {

double clipped_sphere_form_factor(double z, double form_factor) {
  constexpr double pi = std::numbers::pi;
  const double sin2_s = std::clamp(form_factor, 0.0, 1.0);
  const double sin2_w = 1 - z * z;
  // The rim stays above the horizon for s + w <= pi/2 and below it for w - s >= pi/2.
  if (sin2_s + sin2_w <= 1 || sin2_s < 1e-12) return std::max(z, 0.0) + 0.0;
  const double sin_s = std::sqrt(sin2_s), cos_s = std::sqrt(1 - sin2_s);
  const double sin_w = std::sqrt(sin2_w);
  const double cos_p0 = std::clamp(cos_s * z / (sin_s * sin_w), -1.0, 1.0);
  const double p0 = std::acos(cos_p0), sin_p0 = std::sqrt(1 - cos_p0 * cos_p0);
  const double b = std::acos(std::clamp(cos_s / sin_w, -1.0, 1.0));
  const double area = b + sin2_s * z * (pi - p0) - sin_s * cos_s * sin_w * sin_p0;
  return std::max(area / (pi * sin2_s), 0.0);
}

} // namespace openltc::table
