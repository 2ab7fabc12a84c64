// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Any bytes as the JSON of a lobe polynomial: they end in a polynomial whose lobes are proper and
// which is written and read like any other, or in one line that begins with the file's name.

#include "openltc/table/container/polynomial_source.h"
#include "openltc/table/polynomial_file.h"
#include "openltc/target/shade_f64.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace {

using namespace openltc;
using namespace openltc::table;

void require(bool promise) {
  if (!promise) std::abort();
}

// At some of the points that the reader promises to have looked at, 96 an axis.
void check_lobes(const LobePolynomial& polynomial) {
  for (const double roughness : {0.0, 0.25, 0.5, 1.0})
    for (const double y : {0.0, 0.25, 0.75, 1.0}) {
      const double alpha = f64::alpha_from_roughness(roughness);
      const double width = polynomial.width == brdf::LobeWidth::alpha ? alpha : 1.0;
      const f64::FittedLobe fitted =
          f64::eval_lobe_polynomial_of_width(polynomial.view(), alpha, width, 1 - y * y);
      require(std::isfinite(fitted.lobe.det) && fitted.lobe.det > 0);
      require(std::isfinite(fitted.n1) && std::isfinite(fitted.n5));
      if (!polynomial.two_lobes()) continue;
      const f64::SecondLobe second =
          f64::eval_second_lobe_polynomial_of_width(polynomial.view(), alpha, width, 1 - y * y);
      require(std::isfinite(second.lobe.det) && second.lobe.det > 0);
      require(second.weight >= 0 && second.weight <= 1);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const Result<LobePolynomial> read = polynomial_from_json(text, "fuzz");
  if (!read) {
    require(read.error().message.rfind("fuzz: ", 0) == 0);
    require(read.error().message.find('\n') == std::string::npos);
    return 0;
  }
  require(read->degree >= LobePolynomial::k_min_degree);
  require(read->degree <= LobePolynomial::k_max_degree);
  check_lobes(*read);
  const Result<LobePolynomial> again = polynomial_from_json(to_json(*read), "fuzz");
  require(again.ok());
  require(again->degree == read->degree && again->width == read->width);
  require(again->coefficients == read->coefficients && again->second == read->second);
  for (const SourceLanguage language :
       {SourceLanguage::c, SourceLanguage::glsl, SourceLanguage::hlsl, SourceLanguage::wgsl,
        SourceLanguage::javascript})
    require(!to_source(*read, language).empty());
  return 0;
}
