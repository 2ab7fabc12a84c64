// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Near its peak a lobe is seen at x = alpha s, so in cosine space at alpha (A s + B, t, alpha C s +
// D) for s and t of about 1: errors of A, B and D count by the size of D, those of C by alpha as
// well.

#include "tests/shade/polynomial_fixture.h"

#include "openltc/target/shade_f64.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace openltc::testing {

namespace {

// Whether the determinant stays above what the guard of eval_lobe_polynomial leaves.
bool determinant_positive(const table::LobePolynomial& polynomial) {
  constexpr int n = 192;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double y = double(j) / n, alpha = f64::alpha_from_roughness(double(i) / n);
      const double det = f64::eval_lobe_polynomial(polynomial.view(), alpha, 1 - y * y).lobe.det;
      if (!(det > 1e-6 * alpha)) return false;
    }
  return true;
}

} // namespace

table::LobePolynomial polynomial_of_table(const table::LobeTable& table, int degree) {
  const int terms = table::polynomial_terms(degree);
  const int nodes = table.columns * table.rows;
  Eigen::MatrixXd basis(nodes, terms), weight(nodes, 6), values(nodes, 6);
  for (int row = 0; row < table.rows; ++row)
    for (int column = 0; column < table.columns; ++column) {
      const int node = row * table.columns + column;
      const double x = double(column) / (table.columns - 1), y = double(row) / (table.rows - 1);
      // T_n(cos a) = cos(n a)
      const double a = std::acos(std::clamp(2 * x - 1, -1.0, 1.0));
      const double b = std::acos(std::clamp(2 * y - 1, -1.0, 1.0));
      for (int j = 0, term = 0; j <= degree; ++j)
        for (int i = 0; i <= degree - j; ++i, ++term)
          basis(node, term) = std::cos(i * a) * std::cos(j * b);
      const float* texel = table.texel(column, row);
      for (int k = 0; k < 6; ++k)
        values(node, k) = double(texel[k]);
      const double size = 1 / std::max(0.1, double(texel[3]));
      const double alpha = std::max(x * x, 0.02);
      for (const int k : {0, 1, 3})
        weight(node, k) = size;
      weight(node, 2) = size * alpha;
      weight(node, 4) = weight(node, 5) = 1;
    }

  table::LobePolynomial polynomial;
  polynomial.degree = degree;
  polynomial.coefficients.assign(std::size_t(terms) * table::LobePolynomial::k_channels, 0.0f);
  for (int k = 0; k < 6; ++k) {
    const Eigen::MatrixXd weighted = weight.col(k).asDiagonal() * basis;
    const Eigen::VectorXd c =
        weighted.colPivHouseholderQr().solve(weight.col(k).cwiseProduct(values.col(k)));
    for (int term = 0; term < terms; ++term)
      polynomial.term(term)[k] = float(c[term]);
  }
  // Towards a mirror seen at a grazing angle A and D vanish, and so does the determinant: lift both
  // out of the error of the fit.
  for (int step = 0; step < 100 && !determinant_positive(polynomial); ++step) {
    polynomial.term(0)[0] += 1e-3f;
    polynomial.term(0)[3] += 1e-3f;
  }
  polynomial.metadata = table.metadata;
  return polynomial;
}

} // namespace openltc::testing
