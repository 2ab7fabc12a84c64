// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc plot fit: lobes beside their BRDF over view angles and roughnesses.

#include "cli/commands.h"
#include "cli/fit_command.h"
#include "cli/plot/plot.h"
#include "cli/process/message.h"
#include "openltc/fit/report/candidate_file.h"
#include "openltc/plot/figures/fit_figure.h"

#include <fmt/format.h>

#include <memory>

namespace openltc::cli {

namespace {

struct FitPlotArguments {
  PlotOutput output;
  std::string brdf = "ggx", table;
  std::vector<double> theta, roughness;
  bool linear = false;
};

std::string list_of(const std::vector<double>& values) {
  return fmt::format("{:g}", fmt::join(values, ","));
}

Result<draw::Figure> make_figure(const FitPlotArguments& a) {
  const Result<brdf::Brdf> brdf = brdf_of_option(a.brdf);
  if (!brdf) return brdf.error();
  plot::FitFigureOptions options;
  options.brdf = *brdf;
  options.linear = a.linear;
  options.command = "openltc plot fit";
  if (a.brdf != "ggx") options.command += " --brdf " + shell_word(a.brdf);
  if (!a.table.empty()) options.command += " --table " + shell_word(a.table);
  if (!a.theta.empty()) {
    options.theta_degrees = a.theta;
    options.command += " --theta " + list_of(a.theta);
  }
  if (!brdf->has_parameter()) {
    if (!a.roughness.empty())
      return Error{fmt::format("--roughness: {} has no parameter", brdf->name)};
    options.roughness = {1};
  } else if (!a.roughness.empty()) {
    options.roughness = a.roughness;
    options.command += " --roughness " + list_of(a.roughness);
  }
  if (a.linear) options.command += " --linear";
  fit::FittedLobes fitted; // the figure's lobes may refer to it
  if (!a.table.empty()) {
    std::string note;
    const Result<fit::Candidate> read = fit::read_candidate(a.table, note);
    if (!read) return read.error();
    if (!note.empty() && !a.output.quiet) say("{}\n", note);
    options.lobes = {read->label, read->lobes, read->horizon};
    return plot::make_fit_figure(options);
  }
  if (a.brdf == "ggx") {
    options.lobes = {"built-in table", fit::lobes_of(table::builtin_ggx_table()),
                     fit::Horizon::clipped};
    return plot::make_fit_figure(options);
  }
  fit::FitRequest request;
  request.tool_version = OPENLTC_VERSION;
  request.command = fit_command_of(a.brdf, request);
  Result<fit::FittedLobes> made = fit::fit_lobes(*brdf, request);
  if (!made) return made.error();
  fitted = std::move(*made);
  options.lobes = {fmt::format("fitted now, {0} × {0}", request.size), fitted.lobes(),
                   fitted.horizon};
  return plot::make_fit_figure(options);
}

} // namespace

void add_plot_fit(CLI::App& plot, int& exit_code) {
  auto arguments = std::make_shared<FitPlotArguments>();
  FitPlotArguments& a = *arguments;
  CLI::App* command = add_figure(
      plot, "fit", "A BRDF's lobes, the fitted ones and their difference, with their errors",
      a.output);
  command->add_option("--brdf", a.brdf, "The truth: a name of openltc fit --list, or a MERL file")
      ->capture_default_str();
  command
      ->add_option("--table", a.table,
                   "Whose lobes: any file that openltc fit writes or engines publish [the built-in "
                   "table; for other BRDFs than ggx one that is fitted now]")
      ->type_name("FILE");
  command
      ->add_option("--theta", a.theta,
                   "View angles in degrees, from 0 to below 90, a row each [0,30,60,80]")
      ->delimiter(',')
      ->type_name("A,B,...");
  command
      ->add_option("--roughness", a.roughness, "Roughnesses, 0 to 1, a column each [0.1,0.3,0.6,1]")
      ->delimiter(',')
      ->type_name("A,B,...");
  command->add_flag("--linear", a.linear, "Linear colours, not logarithmic over three decades");
  command->footer("TV, L2 and peak are those of openltc fit --report.\n"
                  "\n"
                  "Examples:\n"
                  "  openltc plot fit                                  fit.svg, here\n"
                  "  openltc plot fit --brdf charlie --theta 0,60 -o sheen.png\n"
                  "  openltc plot fit --table ltc_1.dds --theta 75 --roughness 0.2,0.4");
  command->callback([arguments, &exit_code] {
    exit_code = run_figure(arguments->output, [&] { return make_figure(*arguments); });
  });
}

} // namespace openltc::cli
