// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/table/lobe_check.h"

#include "openltc/table/layout.h"
#include "openltc/target/shade_f64.h"

#include <fmt/format.h>

#include <algorithm>

namespace openltc::table {

namespace {

constexpr int k_check_steps = 96; // of the grid on which a polynomial is checked

} // namespace

Status check_determinants(const LobeTable& table, const std::string& name) {
  for (int row = 0; row < table.rows; ++row)
    for (int column = 0; column < table.columns; ++column) {
      const float* texel = table.texel(column, row);
      const double width = node_width(table.width, table.columns, column);
      if (!(double(texel[0]) * double(texel[3]) > width * double(texel[1]) * double(texel[2])))
        return Error{fmt::format("{}: the lobe of node ({}, {}) has no positive determinant", name,
                                 column, row)};
      if (!table.two_lobes()) continue;
      const float* second = table.second_texel(column, row);
      if (!(double(second[0]) * double(second[3]) > width * double(second[1]) * double(second[2])))
        return Error{fmt::format("{}: the second lobe of node ({}, {}) has no positive determinant",
                                 name, column, row)};
    }
  return Success{};
}

Status check_determinants(const LobePolynomial& polynomial, const std::string& name) {
  for (int i = 0; i <= k_check_steps; ++i)
    for (int j = 0; j <= k_check_steps; ++j) {
      const double roughness = double(i) / k_check_steps, y = double(j) / k_check_steps;
      const double alpha = f64::alpha_from_roughness(roughness);
      const double width_there = polynomial.width == brdf::LobeWidth::alpha ? alpha : 1.0;
      const double cos_theta = 1 - y * y;
      const LobePolynomialView view = polynomial.view();
      double det = f64::eval_lobe_polynomial_of_width(view, alpha, width_there, cos_theta).lobe.det;
      if (polynomial.two_lobes())
        det = std::min(
            det, f64::eval_second_lobe_polynomial_of_width(view, alpha, width_there, cos_theta)
                     .lobe.det);
      // What is not positive comes back as the guard's k_tiny.
      if (!(det > 1e-12 * alpha))
        return Error{fmt::format("{}: the lobe at roughness {:.3f}, view angle cosine {:.3f} has "
                                 "no positive determinant",
                                 name, roughness, cos_theta)};
    }
  return Success{};
}

} // namespace openltc::table
