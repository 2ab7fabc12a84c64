// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Oren and Nayar's rough diffuse reflection, the full model with one interreflection.
//
// Source: Oren, Nayar 1994, "Generalization of Lambert's Reflectance Model", the
// functional approximation of the direct term (C1, C2, C3) and of one interreflection, not the
// shorter "qualitative" form. Facets are Lambertian and white (rho = 1).
//
// With a = max(theta_i, theta_o), b = min(theta_i, theta_o), phi the azimuth between the two and
// s2 = sigma^2:
//   pi f = C1 + cos phi C2 tan b + (1 - |cos phi|) C3 tan((a + b)/2)
//          + 0.17 s2/(s2 + 0.13) (1 - cos phi (2b/pi)^2)
//   C1 = 1 - 0.5 s2/(s2 + 0.33)
//   C2 = 0.45 s2/(s2 + 0.09) (sin a - (cos phi < 0 ? (2b/pi)^3 : 0))
//   C3 = 0.125 s2/(s2 + 0.09) (4ab/pi^2)^2
//
// The terms are a fit to a simulation: at grazing angles they pass what a surface can reflect (the
// test states the figure), and f has a crease where theta_i = theta_o.

#include "openltc/brdf/entries.h"
#include "openltc/target/shade_f64.h"

#include <algorithm>
#include <cmath>

namespace openltc::brdf {

namespace {

BrdfValue eval_oren_nayar(Vec3d wo, Vec3d wi, double roughness) {
  const double sigma2 = roughness * roughness;
  const double sin_o = std::hypot(wo.x, wo.y), sin_i = std::hypot(wi.x, wi.y);
  const double both = sin_o * sin_i;
  // Where a direction is the normal, its azimuth has no meaning and b = 0 removes it.
  const double cos_phi = both > 0 ? std::clamp((wo.x * wi.x + wo.y * wi.y) / both, -1.0, 1.0) : 0.0;
  const double theta_o = std::atan2(sin_o, wo.z), theta_i = std::atan2(sin_i, wi.z);
  const double a = std::max(theta_o, theta_i), b = std::min(theta_o, theta_i);
  const double b_share = 2 * b * f64::k_inv_pi, a_share = 2 * a * f64::k_inv_pi;

  const double c1 = 1 - 0.5 * sigma2 / (sigma2 + 0.33);
  const double slope = sigma2 / (sigma2 + 0.09);
  const double c2 =
      0.45 * slope * (std::max(sin_o, sin_i) - (cos_phi < 0 ? b_share * b_share * b_share : 0.0));
  const double c3 = 0.125 * slope * (a_share * b_share) * (a_share * b_share);
  const double direct =
      c1 + cos_phi * c2 * std::tan(b) + (1 - std::abs(cos_phi)) * c3 * std::tan(0.5 * (a + b));
  const double second = 0.17 * sigma2 / (sigma2 + 0.13) * (1 - cos_phi * b_share * b_share);
  return {std::max(0.0, direct + second) * f64::k_inv_pi * wi.z, 0};
}

} // namespace

Brdf make_oren_nayar() {
  return {"oren-nayar",
          "the full model of 1994 with interreflection, white facets",
          "Oren, Nayar 1994, Generalization of Lambert's Reflectance Model",
          "sigma = roughness in radians, the standard deviation of the facets' angles (1: 57.3 "
          "degrees)",
          LobeWidth::one,
          eval_oren_nayar};
}

} // namespace openltc::brdf
