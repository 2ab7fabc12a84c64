// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A fixed, deterministic quadrature rule for one view direction and roughness of any BRDF.

#pragma once

#include "openltc/base/result.h"
#include "openltc/brdf/brdf.h"

#include <vector>

namespace openltc::fit {

/// Number of points of a rule: radial Gauss nodes times azimuths.
struct QuadratureSize {
  int radial = 20;
  int azimuths = 20;
};

/// Directions of the upper hemisphere with their weights, one array per quantity.
///
/// The BRDF is symmetric about the plane of incidence: all directions have y > 0 and weights count
/// both halves, so the sum of weight[i] f(i) approximates the integral of f over the hemisphere.
/// Arrays are padded to a multiple of k_block with points of weight 0.
struct Quadrature {
  static constexpr int k_block = 8;

  double cos_theta = 1; ///< of the view direction
  double roughness = 1;
  double width = 1;             ///< factored out of M^-1: alpha >= k_min_alpha, or 1 (LobeWidth)
  double n1 = 0;                ///< integral of f cos_i for F = 1, by this rule
  double n5 = 0;                ///< integral of f cos_i (1 - wo.h)^5
  double norm2 = 0;             ///< integral of density^2
  double norm3 = 0;             ///< integral of density^3
  std::vector<double> x_mirror; ///< the direction in the mirror frame (shade/lobe.glsl)
  std::vector<double> y;
  std::vector<double> z_mirror;
  std::vector<double> weight;  ///< steradians
  std::vector<double> density; ///< f cos_i / n1: the lobe to fit, integral 1, 1/steradian

  std::size_t size() const { return weight.size(); } ///< a multiple of k_block
};

/// Where a BRDF's half vectors lie at normal incidence, as slopes tan(theta_h).
struct HalfVectors {
  double scale = 1; ///< the median of what is reflected: alpha/sqrt(3)..alpha for GGX
  double reach = 1; ///< beyond it the tail holds nothing that counts; 1 is the horizon
};
/// Never throws: where the BRDF fails it is the default, and make_quadrature then reports why.
HalfVectors find_half_vectors(const brdf::Brdf& brdf, double roughness);

/// Rule for 0 < cos_theta <= 1, whose points crowd around the scale of `half_vectors`.
///
/// Fails, with one line that names the directions, when the BRDF is NaN, infinite or negative
/// somewhere, reflects nothing, has no eval or throws. Error of n1 and n5:
/// tests/fit/test_quadrature.cpp states it.
Result<Quadrature> make_quadrature(const brdf::Brdf& brdf, double roughness, double cos_theta,
                                   HalfVectors half_vectors, QuadratureSize size);

/// The same with the half vectors found first.
Result<Quadrature> make_quadrature(const brdf::Brdf& brdf, double roughness, double cos_theta,
                                   QuadratureSize size);

/// The number of points that a BRDF needs: the first of {20, 32}, {40, 64} and {80, 128} whose
/// albedo agrees with that of twice as many points along both axes to 1 %, at probes over roughness
/// and view angle. A few milliseconds. Fails, with one line, when none does, for lobes that are not
/// near a mirror direction and too narrow to be found, and as make_quadrature does.
Result<QuadratureSize> choose_quadrature(const brdf::Brdf& brdf);

} // namespace openltc::fit
