// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/shaders/lobe_constants.h"

#include "openltc/api/ggx_polynomial.inc"
#include "openltc/api/ggx_two_lobe_polynomial.inc"
#include "openltc/shaders/parser.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace openltc::shaders {

namespace {

std::string number(float value) {
  std::string text = fmt::format("{}", value < 0 ? -value : value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return fmt::format("{}Real({})", value < 0 ? "-" : "", text);
}

std::string vector(const float* row, int count) {
  if (count == 1) return number(row[0]);
  std::string text = fmt::format("Vec{}(", count);
  for (int i = 0; i < count; ++i)
    text += (i > 0 ? ", " : "") + number(row[i]);
  return text + ")";
}

// T_i(u) T_j(v); empty for 1.
std::string product(int i, int j) {
  const auto factor = [](const char* name, int n) {
    return n == 0 ? std::string() : n == 1 ? std::string(name) : fmt::format("{}{}", name, n);
  };
  const std::string a = factor("u", i), b = factor("v", j);
  if (a.empty() || b.empty()) return a + b;
  return "(" + a + " * " + b + ")";
}

// Chebyshev's polynomials of a variable from the second on.
std::string chebyshev(char x, int degree) {
  std::string text;
  for (int n = 2; n <= degree; ++n)
    text += n == 2 ? fmt::format("  Real {0}2 = Real(2.0) * {0} * {0} - Real(1.0);\n", x)
                   : fmt::format("  Real {0}{1} = Real(2.0) * {0} * {0}{2} - {3};\n", x, n, n - 1,
                                 n == 3 ? std::string(1, x) : fmt::format("{}{}", x, n - 2));
  return text;
}

// A field of the sum, from `count` numbers of each row, `stride` apart.
struct Field {
  const char* name;
  const float* first;
  int count, stride;
};

std::string sum_function(const char* type, const char* name, int degree,
                         const std::vector<Field>& fields) {
  std::string text =
      fmt::format("FN {0} {1}(LobePolynomial polynomial, Real u, Real v) {{\n"
                  "  // Chebyshev's polynomials: un is T_n(u), vn is T_n(v).\n{2}{3}  {0} sum;\n",
                  type, name, chebyshev('u', degree), chebyshev('v', degree));
  for (const Field& field : fields) {
    const float* row = field.first;
    for (int j = 0; j <= degree; ++j)
      for (int i = 0; i <= degree - j; ++i, row += field.stride) {
        const std::string times = product(i, j), value = vector(row, field.count);
        text += times.empty()
                    ? fmt::format("  sum.{} = {};\n", field.name, value)
                    : fmt::format("  sum.{0} = sum.{0} + {1} * {2};\n", field.name, value, times);
      }
  }
  return text + "  return sum;\n}\n";
}

// Puts the body of the function that `text` defines in the place of its own.
Status set_body(std::vector<SourceFile>& files, const std::string& text) {
  Result<SourceFile> made = parse_file(text, "polynomial coefficients");
  if (!made) return made.error();
  for (SourceFile& file : files)
    for (Item& item : file.items)
      if (item.name == made->items[0].name) item.body = std::move(made->items[0].body);
  return Success{};
}

} // namespace

Status set_lobe_constants(std::vector<SourceFile>& files, bool two) {
  const float* rows = two ? k_ggx_two_lobe_polynomial : k_ggx_polynomial;
  const int degree = two ? k_ggx_two_lobe_polynomial_degree : k_ggx_polynomial_degree;
  if (Status status =
          set_body(files, sum_function("LobePolynomialSum", "sum_lobe_polynomial", degree,
                                       {{"mirror", rows, 4, 8}, {"amplitudes", rows + 4, 2, 8}}));
      !status || !two)
    return status;
  return set_body(files, sum_function("SecondPolynomialSum", "sum_second_polynomial", degree,
                                      {{"mirror", k_ggx_two_lobe_polynomial_second, 4, 4},
                                       {"tangent", rows + 6, 1, 8}}));
}

} // namespace openltc::shaders
