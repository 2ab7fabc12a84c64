// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Coefficients of the second lobe.

/// A B C D of a term.
FN Vec4 lobe_polynomial_second(LobePolynomial polynomial, int term) {
  return k_polynomial_second[term];
}

/// t of a term, from which the second lobe's share follows.
FN Real lobe_polynomial_tangent(LobePolynomial polynomial, int term) {
  return k_polynomial_tangent[term];
}
