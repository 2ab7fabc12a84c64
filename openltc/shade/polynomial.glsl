// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Fitted lobes without a table: a polynomial for each channel.
//
// With u = 2 sqrt(alpha) - 1 and v = 2 sqrt(1 - cos theta) - 1, both in [-1, 1] and the axes of the
// native table (table.glsl), each of A, B, C, D (the mirror packing, lobe.glsl), n1 and s is
//   sum over i + j <= degree of c_ij T_i(u) T_j(v),
// T_n being Chebyshev's polynomials, T_0 = 1, T_1 = x, T_n+1 = 2 x T_n - T_n-1. They stay within
// 1, so the coefficients show what each term is worth, and single precision loses nothing.
//
// Terms are numbered with j slow, from 0, and i fast, from 0 to degree - j. The prelude of each
// target gives
//   int  lobe_polynomial_degree(LobePolynomial)
//   Vec4 lobe_polynomial_mirror(LobePolynomial, term)      c_ij of A B C D
//   Vec2 lobe_polynomial_amplitudes(LobePolynomial, term)  c_ij of n1 s
//   bool lobe_polynomial_has_second(LobePolynomial)
//   Vec4 lobe_polynomial_second(LobePolynomial, term)      c_ij of A B C D of the second lobe
//   Real lobe_polynomial_tangent(LobePolynomial, term)     c_ij of t, below
//
// s = (n5 / n1)^(1/5) stands in for n5: Schlick's (1 - cos)^5 is of degree ten in v, its root of
// degree two. A dielectric's reflection, .04 n1 + .96 n5, hangs on n5 where that is small.
//
// The second lobe's share of n1 is w = (1 + t / sqrt(1 + t^2)) / 2, whatever t is: within 0..1 and
// smooth, t being the tangent of an angle and (1 + its sine) / 2 the share.

/// What the terms of the first lobe and of the amplitudes add up to.
struct LobePolynomialSum {
  Vec4 mirror;     ///< A B C D
  Vec2 amplitudes; ///< n1 s
};

/// At u and v, see above.
FN LobePolynomialSum sum_lobe_polynomial(LobePolynomial polynomial, Real u, Real v) {
  ASSERT_THAT(lobe_polynomial_degree(polynomial) >= 0);
  Real u_twice = u + u;
  Real v_twice = v + v;

  // One recurrence over i makes the products T_i(u) T_j(v) themselves: it is linear, so it starts
  // at T_j(v) instead of 1. All channels share it.
  int degree = lobe_polynomial_degree(polynomial);
  LobePolynomialSum sum;
  sum.mirror = Vec4(Real(0.0), Real(0.0), Real(0.0), Real(0.0));
  sum.amplitudes = Vec2(Real(0.0), Real(0.0));
  Real t_v = Real(1.0);
  Real t_v_before = v;
  int term = 0;
  for (int j = 0; j <= degree; ++j) {
    Real product = t_v;
    Real product_before = u * t_v;
    for (int i = 0; i <= degree - j; ++i) {
      sum.mirror = sum.mirror + lobe_polynomial_mirror(polynomial, term) * product;
      sum.amplitudes = sum.amplitudes + lobe_polynomial_amplitudes(polynomial, term) * product;
      Real next = u_twice * product - product_before;
      product_before = product;
      product = next;
      ++term;
    }
    Real t_v_next = v_twice * t_v - t_v_before;
    t_v_before = t_v;
    t_v = t_v_next;
  }
  return sum;
}

/// The lobe and amplitudes for a microfacet width and the cosine of the view angle, whatever their
/// values: n1 >= 0, n5 in [0, n1], a determinant above 0. `width` is what was factored out of
/// M^-1: alpha, or 1 for a BRDF whose lobe stays wide.
FN FittedLobe eval_lobe_polynomial_of_width(LobePolynomial polynomial, Real alpha, Real width,
                                            Real cos_theta) {
  Real a = min(max(alpha, Real(k_min_alpha)), Real(1.0));
  Real c = min(max(cos_theta, Real(0.0)), Real(1.0));
  Real u = Real(2.0) * sqrt(a) - Real(1.0);
  Real v = Real(2.0) * sqrt(Real(1.0) - c) - Real(1.0);
  LobePolynomialSum sum = sum_lobe_polynomial(polynomial, u, v);
  FittedLobe fitted;
  fitted.lobe = lobe_from_mirror(sum.mirror, min(max(width, Real(k_min_alpha)), Real(1.0)), c);
  fitted.lobe.det = max(fitted.lobe.det, Real(k_tiny));
  fitted.n1 = max(sum.amplitudes.x, Real(0.0));
  Real s = min(max(sum.amplitudes.y, Real(0.0)), Real(1.0));
  Real s2 = s * s;
  fitted.n5 = fitted.n1 * (s2 * s2 * s);
  return fitted;
}

/// The same of a microfacet BRDF, which reflects no more than it receives: n1 in [0, 1].
FN FittedLobe eval_lobe_polynomial(LobePolynomial polynomial, Real alpha, Real cos_theta) {
  FittedLobe fitted = eval_lobe_polynomial_of_width(polynomial, alpha, alpha, cos_theta);
  Real excess = max(fitted.n1, Real(1.0));
  fitted.n1 = fitted.n1 / excess;
  fitted.n5 = fitted.n5 / excess;
  return fitted;
}

/// What the terms of the second lobe add up to.
struct SecondPolynomialSum {
  Vec4 mirror;  ///< A B C D
  Real tangent; ///< t
};

/// At u and v: the recurrence of the first lobe over other coefficients, of which shaders of one lobe have
/// none.
FN SecondPolynomialSum sum_second_polynomial(LobePolynomial polynomial, Real u, Real v) {
  ASSERT_THAT(lobe_polynomial_degree(polynomial) >= 0);
  Real u_twice = u + u;
  Real v_twice = v + v;
  int degree = lobe_polynomial_degree(polynomial);
  SecondPolynomialSum sum;
  sum.mirror = Vec4(Real(0.0), Real(0.0), Real(0.0), Real(0.0));
  sum.tangent = Real(0.0);
  Real t_v = Real(1.0);
  Real t_v_before = v;
  int term = 0;
  for (int j = 0; j <= degree; ++j) {
    Real product = t_v;
    Real product_before = u * t_v;
    for (int i = 0; i <= degree - j; ++i) {
      sum.mirror = sum.mirror + lobe_polynomial_second(polynomial, term) * product;
      sum.tangent = sum.tangent + lobe_polynomial_tangent(polynomial, term) * product;
      Real next = u_twice * product - product_before;
      product_before = product;
      product = next;
      ++term;
    }
    Real t_v_next = v_twice * t_v - t_v_before;
    t_v_before = t_v;
    t_v = t_v_next;
  }
  return sum;
}

/// The second lobe of a polynomial that has one (lobe_polynomial_has_second), whatever the values: a
/// determinant above 0, a weight in [0, 1]. `width` as above.
FN SecondLobe eval_second_lobe_polynomial_of_width(LobePolynomial polynomial, Real alpha,
                                                   Real width, Real cos_theta) {
  Real a = min(max(alpha, Real(k_min_alpha)), Real(1.0));
  Real c = min(max(cos_theta, Real(0.0)), Real(1.0));
  Real u = Real(2.0) * sqrt(a) - Real(1.0);
  Real v = Real(2.0) * sqrt(Real(1.0) - c) - Real(1.0);
  SecondPolynomialSum sum = sum_second_polynomial(polynomial, u, v);

  SecondLobe second;
  second.lobe = lobe_from_mirror(sum.mirror, min(max(width, Real(k_min_alpha)), Real(1.0)), c);
  second.lobe.det = max(second.lobe.det, Real(k_tiny));
  second.weight =
      Real(0.5) + Real(0.5) * sum.tangent * inversesqrt(Real(1.0) + sum.tangent * sum.tangent);
  return second;
}

/// The same of a microfacet BRDF.
FN SecondLobe eval_second_lobe_polynomial(LobePolynomial polynomial, Real alpha, Real cos_theta) {
  return eval_second_lobe_polynomial_of_width(polynomial, alpha, alpha, cos_theta);
}
