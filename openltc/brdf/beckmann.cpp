// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Beckmann's distribution of normals with height-correlated Smith masking-shadowing.
//
// Sources: Walter, Marschner, Li, Torrance 2007, "Microfacet Models for Refraction through Rough
// Surfaces", equation 25 (D); Heitz 2014, "Understanding the Masking-Shadowing Function in
// Microfacet-Based BRDFs", section 5.3 (Lambda) and equation 99 (height-correlated G2).
//
//   D = exp(-tan^2/alpha^2) / (pi alpha^2 cos^4)
//   Lambda = exp(-a^2)/(2 a sqrt(pi)) - erfc(a)/2,  a = cos/(alpha sin)
//   G2 = 1/(1 + Lambda_o + Lambda_i)
//
// No rational approximation of Lambda. So that nothing is divided by a small cosine,
//   V = G2/(4 cos_o cos_i) = 1/(4 (cos_o cos_i + cos_i L(cos_o) + cos_o L(cos_i))),
//   L(cos) = cos Lambda = alpha sin exp(-a^2)/(2 sqrt(pi)) - cos erfc(a)/2.

#include "openltc/brdf/beckmann.h"

#include "openltc/brdf/entries.h"
#include "openltc/target/shade_f64.h"

#include <algorithm>
#include <cmath>

namespace openltc::brdf {

namespace {

double cosine_times_lambda(double cosine, double alpha) {
  const double spread = alpha * std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const double a = cosine / std::max(spread, f64::k_tiny);
  if (a > 6) return 0; // erfc(6) = 2e-17
  return 0.5 * (spread * std::sqrt(f64::k_inv_pi) * std::exp(-a * a) - cosine * std::erfc(a));
}

BrdfValue eval_beckmann(Vec3d wo, Vec3d wi, double roughness) {
  const double alpha = f64::alpha_from_roughness(roughness);
  const Vec3d h = normalize(wo + wi);
  const double value =
      beckmann_distribution(h, alpha) * beckmann_visibility(wo.z, wi.z, alpha) * wi.z;
  return {value, value * f64::schlick_weight(dot(wo, h))};
}

} // namespace

double beckmann_distribution(Vec3d h, double alpha) {
  const double cos2 = h.z * h.z;
  const double tan2 = (h.x * h.x + h.y * h.y) / std::max(cos2, f64::k_tiny);
  const double alpha2 = alpha * alpha;
  return std::exp(-tan2 / alpha2) * f64::k_inv_pi / (alpha2 * std::max(cos2 * cos2, f64::k_tiny));
}

double beckmann_visibility(double cos_o, double cos_i, double alpha) {
  return 0.25 / std::max(cos_o * cos_i + cos_i * cosine_times_lambda(cos_o, alpha) +
                             cos_o * cosine_times_lambda(cos_i, alpha),
                         f64::k_tiny);
}

Brdf make_beckmann() {
  return {"beckmann",
          "Beckmann, height-correlated Smith with the exact Lambda, F = 1",
          "Walter, Marschner, Li, Torrance 2007, Microfacet Models for Refraction through Rough "
          "Surfaces; Heitz 2014",
          "alpha = roughness^2, the root mean square slope times sqrt(2)",
          LobeWidth::alpha,
          eval_beckmann};
}

} // namespace openltc::brdf
