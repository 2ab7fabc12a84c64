// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Blinn-Phong as a microfacet BRDF: a power of the cosine as the distribution of normals.
//
// Sources: Blinn 1977, "Models of Light Reflection for Computer Synthesized Pictures" (the power of
// n.h); Walter, Marschner, Li, Torrance 2007, "Microfacet Models for Refraction through Rough
// Surfaces", equation 30 (the normalisation) and the exponent that follows it.
//
//   D = (n + 2)/(2 pi) cos^n,   n = 2/alpha^2 - 2
//
// This n makes the lobe as wide as Beckmann's of the same alpha. The distribution's own Smith
// integral has no closed form. The visibility here is GGX's height-correlated one: at alpha = 1
// both distributions are the same, 1/pi, so it is exact there, and for narrower lobes, whose tails
// are shorter than those of GGX, it errs on the dark side. Beckmann's, which Walter et al. advise,
// lets the albedo of rough surfaces grow to 1.77 at grazing angles.

#include "openltc/brdf/blinn.h"

#include "openltc/brdf/entries.h"
#include "openltc/target/shade_f64.h"

#include <algorithm>
#include <cmath>

namespace openltc::brdf {

double blinn_exponent(double alpha) { return 2 / (alpha * alpha) - 2; }

double blinn_distribution(Vec3d h, double exponent) {
  // cos^n by the sine: an exponent of 2e8 would amplify the rounding of a cosine near 1.
  const double sin2 = std::min(h.x * h.x + h.y * h.y, 1 - 1e-15);
  return (exponent + 2) * f64::k_half_inv_pi * std::exp(0.5 * exponent * std::log1p(-sin2));
}

Brdf make_blinn() {
  return {"blinn",
          "normalised Blinn-Phong distribution, GGX's height-correlated Smith visibility, F = 1",
          "Blinn 1977, Models of Light Reflection for Computer Synthesized Pictures; Walter, "
          "Marschner, Li, Torrance 2007",
          "exponent = 2/alpha^2 - 2 of the cosine of the half vector, alpha = roughness^2",
          LobeWidth::alpha,
          [](Vec3d wo, Vec3d wi, double roughness) {
            const double alpha = f64::alpha_from_roughness(roughness);
            const Vec3d h = normalize(wo + wi);
            const double value = blinn_distribution(h, blinn_exponent(alpha)) *
                                 f64::smith_visibility(wo.z, wi.z, alpha) * wi.z;
            return BrdfValue{value, value * f64::schlick_weight(dot(wo, h))};
          }};
}

} // namespace openltc::brdf
