// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Charlie sheen: the retroreflective rim of cloth.
//
// Source: Estevez, Kulla 2017, "Production Friendly Microfacet Sheen BRDF": equation 2 (D), the
// fitted Lambda with its table of constants, and the height-correlated Smith form
// G2 = 1/(1 + Lambda_o + Lambda_i). The paper's fit differs from Smith's integral of D by up to
// 0.043 in G1, and narrow distributions return more than they receive at grazing angles (tests
// state it). Not the simpler visibility 1/(4 (cos_o + cos_i - cos_o cos_i)) that real-time engines
// use, and without the paper's softening of the terminator (a power of Lambda_i), which would break
// reciprocity.
//
//   D = (2 + 1/alpha)/(2 pi) sin^(1/alpha)
//   Lambda(x) = exp(l(x)) for x < 1/2, exp(2 l(1/2) - l(1 - x)) above
//   l(x) = a/(1 + b x^c) + d x + e, its constants between two rows by (1 - alpha)^2
//
// alpha = roughness^2, as in glTF's KHR_materials_sheen; the paper's own slider is alpha. Below
// alpha 0.02 (roughness 0.14), where D is 3e-8 of its height even for the steepest half vector that
// normal incidence allows, alpha stays 0.02: nobody sees a difference, and the fitter finds a lobe.

#include "openltc/brdf/charlie.h"

#include "openltc/brdf/entries.h"
#include "openltc/target/shade_f64.h"

#include <algorithm>
#include <cmath>

namespace openltc::brdf {

namespace {

constexpr double k_min_sheen_alpha = 0.02;

BrdfValue eval_charlie(Vec3d wo, Vec3d wi, double roughness) {
  const double alpha = std::max(roughness * roughness, k_min_sheen_alpha);
  const Vec3d h = normalize(wo + wi);
  const double g2 = 1 / (1 + charlie_lambda(wo.z, alpha) + charlie_lambda(wi.z, alpha));
  // cos_i cancels.
  return {charlie_distribution(h, alpha) * g2 / (4 * std::max(wo.z, f64::k_tiny)), 0};
}

} // namespace

double charlie_distribution(Vec3d h, double alpha) {
  const double sine = std::hypot(h.x, h.y);
  return (2 + 1 / alpha) * f64::k_half_inv_pi * std::pow(sine, 1 / alpha);
}

double charlie_lambda(double cosine, double alpha) {
  const double p = (1 - alpha) * (1 - alpha);
  const double a = 21.5473 + p * (25.3245 - 21.5473);
  const double b = 3.82987 + p * (3.32435 - 3.82987);
  const double c = 0.19823 + p * (0.16801 - 0.19823);
  const double d = -1.97760 + p * (-1.27393 + 1.97760);
  const double e = -4.32054 + p * (-4.85967 + 4.32054);
  const auto l = [&](double x) { return a / (1 + b * std::pow(x, c)) + d * x + e; };
  return std::exp(cosine < 0.5 ? l(cosine) : 2 * l(0.5) - l(1 - std::min(cosine, 1.0)));
}

Brdf make_charlie() {
  return {"charlie",
          "Charlie sheen, height-correlated Smith with the paper's Lambda, no terminator softening",
          "Estevez, Kulla 2017, Production Friendly Microfacet Sheen BRDF",
          "alpha = roughness^2 (at least 0.02); the distribution is sin^(1/alpha)",
          LobeWidth::one,
          eval_charlie};
}

} // namespace openltc::brdf
