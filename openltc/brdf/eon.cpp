// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// EON, the energy-preserving Oren-Nayar model, in its exact form with white albedo.
//
// Source: Portsmouth, Kutz, Hill 2025, "EON: A Practical Energy-Preserving Rough Diffuse BRDF": the
// single scattering of Fujii's Oren-Nayar (FON), its analytic directional albedo E, and a lobe that
// returns what is missing. With r = roughness, s = wi.wo - cos_i cos_o and rho = 1:
//
//   A = 1/(1 + c1 r),  c1 = 1/2 - 2/(3 pi)
//   f_single = A/pi (1 + r t),  t = s > 0 ? s/max(cos_i, cos_o) : s
//   E(mu) = A (1 + r G(mu)/pi),
//   G(mu) = sin (acos mu - sin mu) + 2/3 (sin/mu (1 - sin^3) - sin),  sin = sqrt(1 - mu^2)
//   average of E = A (1 + c2 r),  c2 = 2/3 - 28/(15 pi)
//   f_multiple = (1 - E(cos_o))(1 - E(cos_i)) / (pi (1 - average))
//
// Because 1 - A = c1 r A, the differences from 1 are A r (c1 - G/pi) and A r (c1 - c2), so that
//   f_multiple = A r (c1 - G_o/pi)(c1 - G_i/pi) / (pi (c1 - c2)):
// nothing cancels, no epsilon is needed, and roughness 0 is Lambert exactly.
// Likewise (1 - sin^3)/mu = mu (1 + sin + sin^2)/(1 + sin).

#include "openltc/brdf/entries.h"
#include "openltc/target/shade_f64.h"

#include <algorithm>
#include <cmath>

namespace openltc::brdf {

namespace {

constexpr double k_c1 = 0.5 - 2.0 / 3.0 * f64::k_inv_pi;
constexpr double k_c2 = 2.0 / 3.0 - 28.0 / 15.0 * f64::k_inv_pi;

// c1 - G/pi, which is (1 - E)/(A r): 0 at grazing angles, positive elsewhere.
double missing(Vec3d w) {
  const double mu = w.z, s = std::hypot(w.x, w.y);
  const double g =
      s * (std::atan2(s, mu) - s * mu) + 2.0 / 3.0 * s * (mu * (1 + s + s * s) / (1 + s) - 1);
  return std::max(0.0, k_c1 - g * f64::k_inv_pi);
}

BrdfValue eval_eon(Vec3d wo, Vec3d wi, double roughness) {
  const double a = 1 / (1 + k_c1 * roughness);
  const double s = wo.x * wi.x + wo.y * wi.y;
  const double t = s > 0 ? s / std::max(wo.z, wi.z) : s;
  const double single = a * (1 + roughness * t);
  const double multiple = a * roughness * missing(wo) * missing(wi) / (k_c1 - k_c2);
  return {(single + multiple) * f64::k_inv_pi * wi.z, 0};
}

} // namespace

Brdf make_eon() {
  return {"eon",
          "energy-preserving Oren-Nayar, exact form, white albedo (rho = 1)",
          "Portsmouth, Kutz, Hill 2025, EON: A Practical Energy-Preserving Rough Diffuse BRDF",
          "roughness as it is, the slope parameter r of Fujii's Oren-Nayar",
          LobeWidth::one,
          eval_eon};
}

} // namespace openltc::brdf
