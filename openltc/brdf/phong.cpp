// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Normalised modified Phong: a power of the cosine about the mirror direction.
//
// Sources: Phong 1975, "Illumination for Computer Generated Pictures"; Lafortune, Willems 1994,
// "Using the Modified Phong Reflectance Model for Physically Based Rendering" (reciprocal form and
// normalisation).
//
//   f = (n + 2)/(2 pi) max(0, cos gamma)^n,  gamma from wi to the mirror direction of wo
//
// The factor makes the albedo at normal incidence exactly 1; at other angles part of the lobe lies
// below the horizon and is lost. n = (1/alpha^2 + 1)/2: gamma is twice the angle of the half
// vector, so that n -> 1/(2 alpha^2) is the width of Beckmann's lobe for small alpha, and n = 1 at
// roughness 1 keeps f continuous, which n = 0 would not. There is no half vector in the model and
// Schlick's part is taken at that of wo and wi, as a microfacet has it.

#include "openltc/brdf/entries.h"
#include "openltc/target/shade_f64.h"

#include <cmath>

namespace openltc::brdf {

Brdf make_phong() {
  return {
      "phong",
      "normalised modified Phong about the mirror direction, F = 1",
      "Phong 1975, Illumination for Computer Generated Pictures; Lafortune, Willems 1994, Using "
      "the Modified Phong Reflectance Model for Physically Based Rendering",
      "exponent = (1/alpha^2 + 1)/2 of the cosine to the mirror direction, alpha = roughness^2",
      LobeWidth::alpha,
      [](Vec3d wo, Vec3d wi, double roughness) {
        const double alpha = f64::alpha_from_roughness(roughness);
        const double exponent = 0.5 * (1 / (alpha * alpha) + 1);
        // 1 - cos gamma by the distance: exact where the power is most sensitive.
        const Vec3d apart = wi - Vec3d(-wo.x, -wo.y, wo.z);
        const double one_minus = 0.5 * dot(apart, apart);
        if (one_minus >= 1) return BrdfValue{};
        const double value = (exponent + 2) * f64::k_half_inv_pi *
                             std::exp(exponent * std::log1p(-one_minus)) * wi.z;
        return BrdfValue{value, value * f64::schlick_weight_between(dot(wo, wi))};
      }};
}

} // namespace openltc::brdf
