// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A fixed, deterministic quadrature rule for one view direction and roughness.

#pragma once

#include "openltc/brdf/brdf.h"

#include <vector>

namespace openltc::fit {

/// Directions of the upper hemisphere with their weights, one array per quantity.
///
/// The BRDF is symmetric about the plane of incidence: all directions have y > 0 and weights count
/// both halves, so the sum of weight[i] f(i) approximates the integral of f over the hemisphere.
struct Quadrature {
  double cos_theta = 1;         ///< of the view direction
  double alpha = 1;             ///< microfacet width, >= k_min_alpha
  double n1 = 0;                ///< integral of D V cos_i, by this rule
  double n5 = 0;                ///< integral of D V cos_i (1 - wo.h)^5
  std::vector<double> x_mirror; ///< the direction in the mirror frame (shade/lobe.glsl)
  std::vector<double> y;
  std::vector<double> z_mirror;
  std::vector<double> weight;  ///< steradians, > 0
  std::vector<double> density; ///< D V cos_i / n1: the lobe to fit, integral 1, 1/steradian
  std::vector<double> scale;   ///< of the mixture that drew the points, 1/steradian, integral <= 1

  std::size_t size() const { return weight.size(); }
};

/// Rule of two techniques, each grid x grid points: the BRDF's own sampling at `roughness` and at a
/// widened one, combined with the balance heuristic. 0 < cos_theta <= 1, grid even.
///
/// Error of n1 and n5 against a rule of 512 x 512 for roughness 0..1 and theta to 89.9 degrees: see
/// tests/fit/test_quadrature.cpp, which states and checks it.
Quadrature make_quadrature(const brdf::Brdf& brdf, double roughness, double cos_theta, int grid);

} // namespace openltc::fit
