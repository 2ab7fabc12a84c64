// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The tables and the polynomials that the product ships, from the constants that its public headers
// hold.

#include "openltc/api/ggx_polynomial.inc"
#include "openltc/api/ggx_table.inc"
#include "openltc/api/ggx_two_lobe_polynomial.inc"
#include "openltc/api/ggx_two_lobes.inc"
#include "openltc/table/lobe_polynomial.h"
#include "openltc/table/lobe_table.h"

#include <iterator>

namespace openltc::table {

namespace {

TableMetadata metadata_of(const LobeMetadata& m) {
  return {m.brdf,    m.variant,      m.objective, m.horizon,
          m.command, m.tool_version, m.mean_tv,   m.max_tv};
}

LobeTable make_table() {
  LobeTable table;
  table.columns = k_ggx_table_columns;
  table.rows = k_ggx_table_rows;
  table.texels.assign(std::begin(k_ggx_table), std::end(k_ggx_table));
  table.metadata = metadata_of(k_ggx_table_metadata);
  return table;
}

LobeTable make_two_lobe_table() {
  LobeTable table;
  table.columns = k_ggx_two_lobes_columns;
  table.rows = k_ggx_two_lobes_rows;
  table.texels.assign(std::begin(k_ggx_two_lobes), std::end(k_ggx_two_lobes));
  table.second.assign(std::begin(k_ggx_two_lobes_second), std::end(k_ggx_two_lobes_second));
  table.metadata = metadata_of(k_ggx_two_lobes_metadata);
  return table;
}

LobePolynomial make_polynomial() {
  LobePolynomial polynomial;
  polynomial.degree = k_ggx_polynomial_degree;
  polynomial.coefficients.assign(std::begin(k_ggx_polynomial), std::end(k_ggx_polynomial));
  polynomial.metadata = metadata_of(k_ggx_polynomial_metadata);
  return polynomial;
}

LobePolynomial make_two_lobe_polynomial() {
  LobePolynomial polynomial;
  polynomial.degree = k_ggx_two_lobe_polynomial_degree;
  polynomial.coefficients.assign(std::begin(k_ggx_two_lobe_polynomial),
                                 std::end(k_ggx_two_lobe_polynomial));
  polynomial.second.assign(std::begin(k_ggx_two_lobe_polynomial_second),
                           std::end(k_ggx_two_lobe_polynomial_second));
  polynomial.metadata = metadata_of(k_ggx_two_lobe_polynomial_metadata);
  return polynomial;
}

} // namespace

const LobeTable& builtin_ggx_table() {
  static const LobeTable table = make_table();
  return table;
}

const LobeTable& builtin_ggx_two_lobe_table() {
  static const LobeTable table = make_two_lobe_table();
  return table;
}

const LobePolynomial& builtin_ggx_polynomial() {
  static const LobePolynomial polynomial = make_polynomial();
  return polynomial;
}

const LobePolynomial& builtin_ggx_two_lobe_polynomial() {
  static const LobePolynomial polynomial = make_two_lobe_polynomial();
  return polynomial;
}

} // namespace openltc::table
