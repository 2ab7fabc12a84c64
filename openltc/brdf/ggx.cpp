// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Trowbridge-Reitz (GGX) with its two Smith masking-shadowing functions.
//
// Sources: shade/ggx.glsl, where the formulas stand with their equations, for D and the
// height-correlated G2 = 1/(1 + Lambda_o + Lambda_i); Walter, Marschner, Li, Torrance 2007,
// "Microfacet Models for Refraction through Rough Surfaces", equations 23 and 34, for the separable
// G = G1(wo) G1(wi). The separable form treats masking and shadowing as independent and is the
// darker of the two.
//
// G1(w) = 2 cos/(cos + root), root = sqrt(cos^2 (1 - alpha^2) + alpha^2); with the BRDF's
// denominator, G1 G1/(4 cos_o cos_i) = 1/((cos_o + root_o)(cos_i + root_i)).

#include "openltc/brdf/entries.h"
#include "openltc/target/shade_f64.h"

#include <cmath>

namespace openltc::brdf {

namespace {

BrdfValue eval_ggx(Vec3d wo, Vec3d wi, double roughness) {
  const f64::GgxTerms terms = f64::eval_ggx_terms(wo, wi, f64::alpha_from_roughness(roughness));
  return BrdfValue{terms.scale, terms.bias};
}

double separable_factor(double cosine, double alpha) {
  const double alpha2 = alpha * alpha;
  return 1 / (cosine + std::sqrt(cosine * cosine * (1 - alpha2) + alpha2));
}

BrdfValue eval_ggx_separable(Vec3d wo, Vec3d wi, double roughness) {
  const double alpha = f64::alpha_from_roughness(roughness);
  const Vec3d h = normalize(wo + wi);
  const double visibility = separable_factor(wo.z, alpha) * separable_factor(wi.z, alpha);
  const double value = f64::ggx_distribution(h, alpha) * visibility * wi.z;
  return {value, value * f64::schlick_weight(dot(wo, h))};
}

} // namespace

Brdf make_ggx() {
  return {"ggx",
          "Trowbridge-Reitz, height-correlated Smith, F = 1",
          "Walter, Marschner, Li, Torrance 2007; Heitz 2014 (shade/ggx.glsl)",
          "alpha = roughness^2, the width of the distribution of normals",
          LobeWidth::alpha,
          eval_ggx};
}

Brdf make_ggx_separable() {
  return {"ggx-separable",
          "Trowbridge-Reitz, separable Smith G1(wo) G1(wi), F = 1",
          "Walter, Marschner, Li, Torrance 2007, Microfacet Models for Refraction through Rough "
          "Surfaces",
          "alpha = roughness^2, the width of the distribution of normals",
          LobeWidth::alpha,
          eval_ggx_separable};
}

} // namespace openltc::brdf
