// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// fuzz_polynomial_seeds FOLDER: writes valid polynomials of every degree and width,
// one of them of two lobes.

#include "openltc/table/polynomial_file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

using namespace openltc;
using namespace openltc::table;

namespace {

// The built-in with the terms that the degree has, the others cut or 0; its order is j slow.
LobePolynomial of_degree(int degree) {
  const LobePolynomial& from = builtin_ggx_polynomial();
  LobePolynomial to = from;
  to.degree = degree;
  to.coefficients.assign(std::size_t(polynomial_terms(degree)) * LobePolynomial::k_channels, 0.0f);
  int begin_from = 0, begin_to = 0;
  for (int j = 0; j <= std::min(degree, from.degree); ++j) {
    for (int i = 0; i <= std::min(degree, from.degree) - j; ++i)
      std::copy_n(from.term(begin_from + i), LobePolynomial::k_channels, to.term(begin_to + i));
    begin_from += from.degree - j + 1;
    begin_to += degree - j + 1;
  }
  return to;
}

// The cosine itself everywhere.
LobePolynomial diffuse() {
  LobePolynomial to = of_degree(LobePolynomial::k_min_degree);
  to.width = brdf::LobeWidth::one;
  std::fill(to.coefficients.begin(), to.coefficients.end(), 0.0f);
  for (const int channel : {0, 3, 4})
    to.term(0)[channel] = 1.0f;
  return to;
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: fuzz_polynomial_seeds FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::error_code ec;
  std::filesystem::create_directories(folder, ec);
  bool good = write_polynomial(diffuse(), (folder / "diffuse.json").string()).ok();
  for (int degree = LobePolynomial::k_min_degree; degree <= LobePolynomial::k_max_degree; ++degree)
    good = good && write_polynomial(of_degree(degree),
                                    (folder / (std::to_string(degree) + ".json")).string())
                       .ok();
  good = good &&
         write_polynomial(builtin_ggx_two_lobe_polynomial(), (folder / "two_lobes.json").string())
             .ok();
  if (!good) std::fprintf(stderr, "%s: cannot write\n", folder.string().c_str());
  return good ? 0 : 1;
}
