// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc plot literal: the source document's formulas beside the corrected ones.

#include "cli/plot/plot.h"
#include "openltc/plot/figures/literal_figure.h"

#include <memory>

namespace openltc::cli {

void add_plot_literal(CLI::App& plot, int& exit_code) {
  auto output = std::make_shared<PlotOutput>();
  CLI::App* command = add_figure(
      plot, "literal", "The source document's formulas, taken literally, beside the corrected ones",
      *output);
  command->footer(
      "The document that OpenLTC began with is wrong in places. Six panels show by how much: the\n"
      "denominator counted twice, Schlick's exponent inside the bracket, Fresnel applied twice, "
      "the\n"
      "lobe without its amplitude, the determinant read as a norm, and the point light of 0.1.3.\n"
      "docs/source_document.md explains each.\n"
      "\n"
      "Examples:\n"
      "  openltc plot literal                                  literal.svg, here\n"
      "  openltc plot literal -o literal.png --background dark");
  command->callback([output, &exit_code] {
    exit_code = run_figure(*output, [] { return plot::make_literal_figure(); });
  });
}

} // namespace openltc::cli
