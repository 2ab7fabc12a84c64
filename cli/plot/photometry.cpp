// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc plot photometry: the polar diagram of a luminaire.

#include "openltc/light/photometry/photometry.h"

#include "cli/fit_command.h"
#include "cli/plot/plot.h"
#include "cli/process/message.h"
#include "openltc/plot/figures/photometry_figure.h"

#include <fmt/format.h>

#include <memory>
#include <string>

namespace openltc::cli {

namespace {

struct PhotometryArguments {
  PlotOutput output;
  std::string path;
  bool per_kilolumen = false;
};

Result<draw::Figure> make_figure(const PhotometryArguments& a) {
  Result<light::IesProfile> profile = light::read_photometry(a.path);
  if (!profile) return profile.error();
  if (!a.output.quiet)
    for (const std::string& warning : profile->warnings)
      say("warning: {}\n", warning);
  plot::PhotometryOptions options;
  options.profile = std::move(*profile);
  options.per_kilolumen = a.per_kilolumen;
  options.command = "openltc plot photometry " + shell_word(a.path);
  if (a.per_kilolumen) options.command += " --per-klm";
  return plot::make_photometry_figure(options);
}

} // namespace

void add_plot_photometry(CLI::App& plot, int& exit_code) {
  auto arguments = std::make_shared<PhotometryArguments>();
  PhotometryArguments& a = *arguments;
  CLI::App* command =
      add_figure(plot, "photometry", "The polar diagram of a photometric file", a.output);
  command->add_option("file", a.path, "Photometric file: .ies (LM-63) or .ldt (EULUMDAT)")
      ->required();
  command->add_flag("--per-klm", a.per_kilolumen,
                    "Candela per 1000 lm of the luminaire instead of candela");
  command->footer("Intensity in the planes C0-C180 and C90-C270, with flux, peak, beam and field "
                  "angles.\n"
                  "\n"
                  "Examples:\n"
                  "  openltc plot photometry lamp.ies                 photometry.svg, here\n"
                  "  openltc plot photometry lamp.ldt -o lamp.png --background dark");
  command->callback([arguments, &exit_code] {
    exit_code = run_figure(arguments->output, [&] { return make_figure(*arguments); });
  });
}

} // namespace openltc::cli
