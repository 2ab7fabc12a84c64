// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Where the fitted lobes of a specular BRDF come from: a table or a polynomial.
//
// Source: Heitz, Dupuy, Hill, Neubelt 2016, "Real-Time Polygonal-Light Shading with Linearly
// Transformed Cosines"; both forms are fitted by `openltc fit` to GGX with height-correlated Smith
// masking, and say in their metadata how well.
//
// Define OPENLTC_NO_TABLE to leave the tables out, 140 KiB of constants.

#pragma once

#include "openltc/api/ggx_polynomial.inc"
#include "openltc/api/ggx_two_lobe_polynomial.inc"
#ifndef OPENLTC_NO_TABLE
#include "openltc/api/ggx_table.inc"
#include "openltc/api/ggx_two_lobes.inc"
#endif
#include "openltc/target/shade_f32.h"

namespace openltc {

/// \addtogroup surface
/// @{

/// Lobes over roughness and view angle. A view: the arrays behind it outlive every surface that is
/// made with it. Without any, surfaces are black.
struct Lobes {
  /// 8 floats a texel, A B C D n1 n5 w 0; columns are roughness = sqrt(alpha) from 0 to 1, rows
  /// sqrt(1 - cos theta) from 0 to 1, nodes at both ends. A table of `openltc fit` or of your own.
  /// One of two lobes has in `second` 4 floats a texel, A B C D of the second lobe, whose share w
  /// of n1 is 0 to 1.
  LobeTableView table;
  /// Used instead of the table where it has coefficients: (degree + 1)(degree + 2)/2 terms of 8
  /// floats, A B C D n1 s t 0 (openltc/shade/polynomial.glsl). One of two lobes has in `second` 4
  /// floats a term, A B C D of the second lobe, whose share of n1 is (1 + t / sqrt(1 + t^2)) / 2.
  LobePolynomialView polynomial;
};

#ifndef OPENLTC_NO_TABLE
/// The table that comes with the library, 64 x 64, GGX: k_ggx_table_metadata says how it was made.
inline Lobes built_in_table() {
  Lobes lobes;
  lobes.table = {k_ggx_table, k_ggx_table_columns, k_ggx_table_rows, nullptr};
  return lobes;
}

/// Two lobes at every node, 32 x 32, GGX: half the error of one lobe, for half as much time again
/// for each light (k_ggx_two_lobes_metadata says how it was made).
inline Lobes built_in_two_lobe_table() {
  Lobes lobes;
  lobes.table = {k_ggx_two_lobes, k_ggx_two_lobes_columns, k_ggx_two_lobes_rows,
                 k_ggx_two_lobes_second};
  return lobes;
}
#endif

/// The same BRDF as polynomials of degree 4: 15 terms, no memory to fetch from, about as exact
/// (k_ggx_polynomial_metadata).
inline Lobes built_in_polynomial() {
  Lobes lobes;
  lobes.polynomial = {k_ggx_polynomial, k_ggx_polynomial_degree, nullptr};
  return lobes;
}

/// Two lobes as polynomials of degree 4, GGX: half the error of one lobe without a table
/// (k_ggx_two_lobe_polynomial_metadata).
inline Lobes built_in_two_lobe_polynomial() {
  Lobes lobes;
  lobes.polynomial = {k_ggx_two_lobe_polynomial, k_ggx_two_lobe_polynomial_degree,
                      k_ggx_two_lobe_polynomial_second};
  return lobes;
}

namespace detail {

inline bool has_lobes(const Lobes& lobes) {
  return lobes.polynomial.coefficients ||
         (lobes.table.texels && lobes.table.columns > 0 && lobes.table.rows > 0);
}

inline bool has_second_lobe(const Lobes& lobes) {
  return lobes.polynomial.coefficients ? f32::lobe_polynomial_has_second(lobes.polynomial)
                                       : f32::lobe_table_has_second(lobes.table);
}

inline f32::FittedLobe find_lobe(const Lobes& lobes, float roughness, float cos_theta) {
  if (lobes.polynomial.coefficients)
    return f32::eval_lobe_polynomial(lobes.polynomial, f32::alpha_from_roughness(roughness),
                                     cos_theta);
  return f32::fetch_lobe_of_roughness(lobes.table, roughness, cos_theta);
}

inline f32::SecondLobe find_second_lobe(const Lobes& lobes, float roughness, float cos_theta) {
  if (lobes.polynomial.coefficients)
    return f32::eval_second_lobe_polynomial(lobes.polynomial, f32::alpha_from_roughness(roughness),
                                            cos_theta);
  return f32::fetch_second_lobe_of_roughness(lobes.table, roughness, cos_theta);
}

} // namespace detail

/// @}

} // namespace openltc
