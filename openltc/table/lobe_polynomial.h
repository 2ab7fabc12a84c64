// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Fitted lobes without a table: a polynomial for each channel, and what is known about it.

#pragma once

#include "openltc/table/lobe_table.h"
#include "openltc/target/resources.h"

#include <cstddef>
#include <vector>

namespace openltc::table {

/// Number of products T_i T_j with i + j <= degree.
constexpr int polynomial_terms(int degree) { return (degree + 1) * (degree + 2) / 2; }

/// Coefficients of the lobe M^-1 and its amplitudes as polynomials of roughness and view angle.
///
/// Each of A B C D n1 s is the sum over i + j <= degree of
/// c_ij T_i(u) T_j(v), T being Chebyshev's polynomials, u = 2 sqrt(alpha) - 1 = 2 roughness - 1,
/// v = 2 sqrt(1 - cos theta) - 1 (shade/polynomial.glsl). The lobe's width is alpha or 1.
/// Storage: 32-bit float; terms of 8 floats, A B C D n1 s t 0, with j from 0 to degree slow and i
/// from 0 to degree - j fast. A second lobe has terms of 4 floats more, its A B C D, and the share
/// (1 + t / sqrt(1 + t^2)) / 2 of n1; without it t is 0.
struct LobePolynomial {
  static constexpr int k_channels = 8;
  static constexpr int k_second_channels = 4;
  static constexpr int k_min_degree = 3;
  static constexpr int k_max_degree = 6;

  int degree = 0; ///< k_min_degree to k_max_degree
  brdf::LobeWidth width = brdf::LobeWidth::alpha;
  std::vector<float> coefficients; ///< polynomial_terms(degree) * k_channels
  std::vector<float> second;       ///< polynomial_terms(degree) * k_second_channels, or empty
  TableMetadata metadata;

  bool two_lobes() const { return !second.empty(); }
  LobePolynomialView view() const {
    return {coefficients.data(), degree, second.empty() ? nullptr : second.data()};
  }
  const float* term(int index) const {
    return coefficients.data() + std::size_t(index) * k_channels;
  }
  float* term(int index) { return coefficients.data() + std::size_t(index) * k_channels; }
  const float* second_term(int index) const {
    return second.data() + std::size_t(index) * k_second_channels;
  }
};

/// The polynomial that the product ships: GGX, height-correlated Smith; its metadata names the
/// command that made it.
const LobePolynomial& builtin_ggx_polynomial();

/// The polynomial of two lobes that the product ships: the same BRDF.
const LobePolynomial& builtin_ggx_two_lobe_polynomial();

} // namespace openltc::table
