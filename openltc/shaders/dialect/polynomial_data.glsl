// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Coefficients of the fitted lobe as constants: no texture.

/// Total degree in both variables.
FN int lobe_polynomial_degree(LobePolynomial polynomial) { return k_polynomial_degree; }

/// A B C D of a term.
FN Vec4 lobe_polynomial_mirror(LobePolynomial polynomial, int term) {
  return k_polynomial_mirror[term];
}

/// n1 and s of a term.
FN Vec2 lobe_polynomial_amplitudes(LobePolynomial polynomial, int term) {
  return k_polynomial_amplitudes[term];
}
