// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc plot: figures of lobes, fits, polygons and errors.

#include "cli/plot/plot.h"

#include "cli/commands.h"
#include "cli/options/choice.h"
#include "cli/output_place.h"
#include "cli/process/message.h"
#include "openltc/base/atomic_file.h"
#include "openltc/brdf/choose.h"
#include "openltc/draw/figure_file.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

namespace openltc::cli {

CLI::App* add_figure(CLI::App& plot, const std::string& what, const std::string& description,
                     PlotOutput& output) {
  output.what = what;
  CLI::App* command = plot.add_subcommand(what, description);
  command
      ->add_option("-o,--output", output.paths,
                   fmt::format("File to write, .svg or .png. May be repeated [{}.svg]", what))
      ->allow_extra_args(false);
  const Choices<draw::Theme> themes = {
      {"auto", draw::Theme::automatic}, {"light", draw::Theme::light}, {"dark", draw::Theme::dark}};
  add_choice(*command, "--background", output.theme,
             "Colours of the page: auto, in .svg those that the reader's browser prefers, in "
             ".png light [auto]",
             themes);
  command->add_option("--scale", output.scale, "Pixels of a .png to a unit of the figure")
      ->check(CLI::Range(0.25, 8.0))
      ->capture_default_str();
  command->add_flag("--quiet", output.quiet, "No progress and messages on stderr");
  return command;
}

int fail_plot(const PlotOutput& output, const Error& error) {
  return fail("plot " + output.what, error);
}

int run_figure(const PlotOutput& output, const std::function<Result<draw::Figure>()>& make) {
  std::vector<std::string> paths = output.paths;
  if (paths.empty()) paths.push_back(output.what + ".svg");
  for (const std::string& path : paths) {
    if (Status ok = draw::check_extension(path); !ok) {
      fail_plot(output, ok.error());
      return k_exit_usage;
    }
  }
  if (Status ok = check_places(paths); !ok) return fail_plot(output, ok.error());
  const Result<draw::Figure> figure = make();
  if (!figure) {
    const int failed = fail_plot(output, figure.error());
    // What names an option first is wrong usage.
    return figure.error().message.rfind("--", 0) == 0 ? k_exit_usage : failed;
  }
  if (Status ok = check_not_read(paths); !ok) return fail_plot(output, ok.error());
  FileGroup together;
  for (const std::string& path : paths)
    if (Status ok = draw::write_figure(path, *figure, output.theme, output.scale); !ok)
      return fail_plot(output, ok.error());
  if (Status ok = together.commit(); !ok) return fail_plot(output, ok.error());
  if (!output.quiet)
    for (const std::string& path : paths)
      say("wrote {}\n", path);
  return k_exit_ok;
}

Result<brdf::Brdf> brdf_of_option(const std::string& name_or_path) {
  Result<brdf::Brdf> brdf = brdf::choose_brdf(name_or_path);
  if (brdf || std::filesystem::path(name_or_path).extension() == ".binary") return brdf;
  return Error{"--brdf: " + brdf.error().message};
}

void add_plot(CLI::App& app, int& exit_code) {
  CLI::App* plot = app.add_subcommand(
      "plot",
      "Draw figures: lobes, fits, polygons, errors, point lights, luminaires, error over time");
  plot->footer("Every figure is written as .svg or .png; openltc plot WHAT --help says what it "
               "shows.\n"
               "\n"
               "Examples:\n"
               "  openltc plot lobes                       lobes.svg, here\n"
               "  openltc plot error --against ltc_1.dds -o error.png --background dark");
  plot->require_subcommand(1);
  add_plot_error(*plot, exit_code);
  add_plot_lobes(*plot, exit_code);
  add_plot_polygon(*plot, exit_code);
  add_plot_literal(*plot, exit_code);
  add_plot_fit(*plot, exit_code);
  add_plot_point(*plot, exit_code);
  add_plot_photometry(*plot, exit_code);
  add_plot_trade(*plot, exit_code);
}

} // namespace openltc::cli
