// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Pearson's chi-square test of samples against what is expected of them.

#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace openltc::testing {

/// Probability that a chi-square variable of k degrees exceeds x: Wilson and Hilferty 1931, the
/// cube root is nearly normal.
inline double chi_square_p(double x, int k) {
  const double c = 2.0 / (9.0 * k);
  const double z = (std::cbrt(x / k) - (1 - c)) / std::sqrt(c);
  return 0.5 * std::erfc(z / std::sqrt(2.0));
}

/// The same for counts in bins; those that expect fewer than 10 say nothing.
inline double p_of_counts(const std::vector<double>& expected,
                          const std::vector<double>& observed) {
  double x = 0;
  int degrees = -1;
  for (std::size_t bin = 0; bin < expected.size(); ++bin) {
    if (expected[bin] < 10) continue;
    const double d = observed[bin] - expected[bin];
    x += d * d / expected[bin];
    ++degrees;
  }
  return chi_square_p(x, degrees);
}

} // namespace openltc::testing
