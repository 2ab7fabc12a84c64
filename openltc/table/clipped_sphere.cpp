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
// cos p0 = cot s cot w, above it for p in (p0, 2 pi - p0), at x = cos s / sin w and y = +- sin s
// sin p0. Along the horizon back to the start the integral is half of the arc's angle, b =
// atan(y / x). With z = cos w and q = sin s sin w sin p0 = sqrt(sin^2 s - z^2) all of this becomes
//   p0 = atan(q / (cos s z)),   b = atan(q / cos s),
//   area = b + sin^2 s z (pi - p0) - cos s q,
// in which nothing cancels badly, and pi sin^2 s z where the rim does not reach the horizon.

#include "openltc/table/clipped_sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace openltc::table {

double clipped_sphere_form_factor(double z, double form_factor) {
  constexpr double pi = std::numbers::pi;
  const double sin2_s = std::clamp(form_factor, 0.0, 1.0);
  if (sin2_s <= z * z) return std::max(z, 0.0); // the rim does not reach the horizon
  const double cos_s = std::sqrt(1 - sin2_s), q = std::sqrt(sin2_s - z * z);
  const double p0 = std::atan2(q, cos_s * z);
  const double area = std::atan2(q, cos_s) + sin2_s * z * (pi - p0) - cos_s * q;
  return std::max(area / (pi * sin2_s), 0.0);
}

} // namespace openltc::table
