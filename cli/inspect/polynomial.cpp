// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/inspect/inspect.h"
#include "openltc/base/quote.h"
#include "openltc/fit/measure/certificate.h"
#include "openltc/fit/polynomial_fit.h"
#include "openltc/table/polynomial_file.h"

#include <fmt/format.h>

namespace openltc::cli {

Result<Description> inspect_polynomial(const std::string& path) {
  const Result<table::LobePolynomial> read = table::read_polynomial(path);
  if (!read) return read.error();
  const table::TableMetadata& m = read->metadata;
  const int terms = table::polynomial_terms(read->degree);
  const char* width = read->width == brdf::LobeWidth::alpha ? "alpha" : "one";
  // Anew, from the coefficients: a file may say anything about itself.
  const fit::Certificate certificate = fit::certify_determinant(*read);
  const bool proper = certificate.lower_bound > 0;
  Description out;
  out.text =
      fmt::format("lobe polynomial{} of degree {}, {} terms of A B C D n1 (n5/n1)^(1/5){}, width "
                  "{}\n",
                  read->two_lobes() ? " of two lobes" : "", read->degree, terms,
                  read->two_lobes() ? " t A2 B2 C2 D2" : "", width);
  out.text += fmt::format("brdf       {} ({})\n", quote(m.brdf), quote(m.variant));
  out.text += fmt::format("objective  {}\n", quote(m.objective));
  out.text +=
      fmt::format("made by    {} (OpenLTC {})\n", quote(m.command, 400), quote(m.tool_version));
  out.text += stated_errors(m);
  out.text += proper
                  ? fmt::format("certified  A D - w B C >= {:.2e} over the whole domain; no lobe "
                                "turns inside out\n",
                                certificate.lower_bound)
                  : std::string("not certified: A D - w B C could not be bounded above 0\n");
  out.json = {{"file", path},
              {"kind", "polynomial"},
              {"degree", read->degree},
              {"terms", terms},
              {"lobes", read->two_lobes() ? 2 : 1},
              {"width", width},
              {"brdf", m.brdf},
              {"variant", m.variant},
              {"objective", m.objective},
              {"command", m.command},
              {"tool_version", m.tool_version},
              {"mean_tv", known_or_null(m.mean_tv)},
              {"max_tv", known_or_null(m.max_tv)},
              {"certified", proper},
              {"determinant_at_least", certificate.lower_bound}};
  add_measured_errors(m.brdf, fit::lobes_of(*read), fit::Horizon::clipped, out);
  return out;
}

} // namespace openltc::cli
