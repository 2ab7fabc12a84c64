// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// GGX with the energy that single scattering loses given back by the amplitude.
//
// Source: Turquin 2019, "Practical Multiple Scattering Compensation for Microfacet Models": the
// lobe keeps its shape and is multiplied by 1 + F0 (1 - E)/E, E the albedo for F = 1.
//
// For F = 1 this is f/E, albedo 1. BrdfValue holds what is linear in F0 only, and the factor is
// not: here scale = f/E and bias = the plain lobe's Schlick part, unscaled. That agrees with
// Turquin's at F0 = 0 (nothing comes back from a second reflection) and at F0 = 1; in between the
// light given back is F0 (1 - E) instead of some F0^2 (1 - E), brighter by at most (1 - E)/4. Who
// wants Turquin's exactly keeps the plain ggx lobe and multiplies by 1 + F0 (1/n1 - 1).
// Dividing by the albedo of wo alone is not reciprocal.

#include "openltc/brdf/entries.h"
#include "openltc/brdf/ggx_albedo.h"
#include "openltc/target/shade_f64.h"

namespace openltc::brdf {

Brdf make_ggx_ms() {
  return {
      "ggx-ms",
      "Trowbridge-Reitz, height-correlated Smith, divided by its albedo for F = 1; Schlick part "
      "as in ggx",
      "Turquin 2019, Practical Multiple Scattering Compensation for Microfacet Models",
      "alpha = roughness^2, the width of the distribution of normals",
      LobeWidth::alpha,
      [](Vec3d wo, Vec3d wi, double roughness) {
        const f64::GgxTerms terms =
            f64::eval_ggx_terms(wo, wi, f64::alpha_from_roughness(roughness));
        return BrdfValue{terms.scale / ggx_albedo(wo.z, roughness), terms.bias};
      }};
}

} // namespace openltc::brdf
