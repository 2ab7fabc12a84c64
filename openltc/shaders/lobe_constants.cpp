// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/shaders/lobe_constants.h"

#include "openltc/api/ggx_polynomial.inc"
#include "openltc/api/ggx_two_lobe_polynomial.inc"

#include <fmt/format.h>

#include <utility>

namespace openltc::shaders {

namespace {

Node number(float value) {
  std::string text = fmt::format("{}", value < 0 ? -value : value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  Node node{Kind::number, text};
  return value < 0 ? Node{Kind::unary, "-", {std::move(node)}} : node;
}

// `count` numbers of each row, `stride` apart, as elements of a constant.
Item array(const char* name, const char* comment, const float* first, int count, int stride,
           int terms) {
  constexpr const char* k_types[] = {"", "Real", "Vec2", "Vec3", "Vec4"};
  Item item{ItemKind::constant, k_types[count], name};
  item.comments = {comment};
  for (int term = 0; term < terms; ++term) {
    const float* row = first + stride * term;
    Node element{Kind::call, k_types[count]};
    for (int i = 0; i < count; ++i)
      element.parts.push_back(number(row[i]));
    item.elements.push_back(count == 1 ? Node(element.parts[0]) : std::move(element));
  }
  return item;
}

} // namespace

SourceFile lobe_constants(bool two) {
  const int n = two ? k_ggx_two_lobe_polynomial_degree : k_ggx_polynomial_degree;
  const int terms = (n + 1) * (n + 2) / 2;
  const float* rows = two ? k_ggx_two_lobe_polynomial : k_ggx_polynomial;
  SourceFile file{"polynomial_coefficients"};
  Item degree{ItemKind::constant, "int", "k_polynomial_degree"};
  degree.body = {Kind::number, std::to_string(n)};
  degree.comments = {"Total degree of the polynomials in both variables."};
  file.items = {std::move(degree),
                array("k_polynomial_mirror", "Coefficients of A, B, C and D, a term a row.", rows,
                      4, 8, terms),
                array("k_polynomial_amplitudes", "And of n1 and s.", rows + 4, 2, 8, terms)};
  if (two) {
    file.items.push_back(array("k_polynomial_second", "Of A, B, C and D of the second lobe.",
                               k_ggx_two_lobe_polynomial_second, 4, 4, terms));
    file.items.push_back(array("k_polynomial_tangent", "Of t, its share.", rows + 6, 1, 8, terms));
  }
  return file;
}

} // namespace openltc::shaders
