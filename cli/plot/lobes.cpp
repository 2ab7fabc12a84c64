// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc plot lobes: what a matrix makes of a clamped cosine.

#include "cli/fit_command.h"
#include "cli/options/choice.h"
#include "cli/plot/plot.h"
#include "openltc/plot/figures/lobes_figure.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace openltc::cli {

namespace {

struct LobesArguments {
  PlotOutput output;
  std::vector<plot::StandardRow> rows;
  std::vector<std::string> matrices, sweeps;
  std::optional<std::string> brdf;
  std::vector<double> theta = {0, 30, 60, 80};
  std::vector<double> roughness = {0.5};
};

const Choices<plot::StandardRow>& row_choices() {
  static const Choices<plot::StandardRow> choices = {{"cosine", plot::StandardRow::cosine},
                                                     {"roughness", plot::StandardRow::roughness},
                                                     {"anisotropy", plot::StandardRow::anisotropy},
                                                     {"skew", plot::StandardRow::skew}};
  return choices;
}

std::string command_of(const LobesArguments& arguments) {
  std::string command = "openltc plot lobes";
  for (const plot::StandardRow row : arguments.rows)
    for (const auto& [word, value] : row_choices())
      if (value == row) command += " --row " + word;
  for (const std::string& matrix : arguments.matrices)
    command += " --matrix " + matrix;
  for (const std::string& sweep : arguments.sweeps)
    command += " --sweep " + sweep;
  if (!arguments.brdf) return command;
  command += " --brdf " + shell_word(*arguments.brdf);
  const LobesArguments defaults;
  if (arguments.theta != defaults.theta)
    command += fmt::format(" --theta {}", fmt::join(arguments.theta, ","));
  if (arguments.roughness != defaults.roughness)
    command += fmt::format(" --roughness {}", fmt::join(arguments.roughness, ","));
  return command;
}

// The rows in the order of the help: standard ones, matrices or sweeps from them, fitted lobes.
Result<std::vector<plot::LobeRow>> rows_of(const LobesArguments& arguments) {
  std::vector<plot::LobeRow> rows;
  for (const plot::StandardRow row : arguments.rows)
    rows.push_back(plot::standard_row(row));
  std::vector<plot::LobeMatrix> matrices;
  for (const std::string& text : arguments.matrices) {
    const Result<plot::LobeMatrix> matrix = plot::parse_matrix(text);
    if (!matrix) return matrix.error();
    matrices.push_back(*matrix);
  }
  if (arguments.sweeps.empty() && !matrices.empty()) {
    Result<plot::LobeRow> row = plot::matrix_row(matrices);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  if (!arguments.sweeps.empty() && matrices.empty()) matrices.push_back({});
  for (const plot::LobeMatrix& base : matrices)
    for (const std::string& text : arguments.sweeps) {
      const Result<plot::LobeSweep> sweep = plot::parse_sweep(text);
      if (!sweep) return sweep.error();
      Result<plot::LobeRow> row = plot::sweep_row(base, *sweep);
      if (!row) return row.error();
      rows.push_back(std::move(*row));
    }
  return rows;
}

Result<draw::Figure> make_figure(const LobesArguments& arguments) {
  Result<std::vector<plot::LobeRow>> rows = rows_of(arguments);
  if (!rows) return rows.error();
  if (arguments.brdf) {
    const Result<brdf::Brdf> brdf = brdf_of_option(*arguments.brdf);
    if (!brdf) return brdf.error();
    const Result<std::vector<plot::LobeRow>> fitted =
        plot::fitted_rows(*brdf, arguments.theta, arguments.roughness);
    if (!fitted) return fitted.error();
    rows->insert(rows->end(), fitted->begin(), fitted->end());
  }
  return plot::make_lobes_figure({std::move(*rows), command_of(arguments)});
}

} // namespace

void add_plot_lobes(CLI::App& plot, int& exit_code) {
  auto arguments = std::make_shared<LobesArguments>();
  LobesArguments& a = *arguments;
  CLI::App* command = add_figure(
      plot, "lobes", "What a matrix makes of a clamped cosine: spheres and solids", a.output);
  command->footer(
      "A lobe is the density D of the directions M o, o being distributed as the cosine; M =\n"
      "[[a,0,b],[0,c,0],[d,0,1]], with c > 0 and a > b d. Each is drawn twice: the sphere of\n"
      "directions, coloured by D, and a solid at the distance D from the origin, with the columns\n"
      "of M. Below stand det M, the peak and the integral of D by quadrature, which is 1.\n"
      "\n"
      "Examples:\n"
      "  openltc plot lobes                                  cosine, roughness, anisotropy, skew\n"
      "  openltc plot lobes --row skew                       one of them\n"
      "  openltc plot lobes --matrix 0.5,-0.6,0.3,0          a lobe of your own\n"
      "  openltc plot lobes --matrix 0.6,0,0.6,0 --sweep c=0.6:0.1:6\n"
      "  openltc plot lobes --brdf ggx --theta 0,45,75 --roughness 0.3,0.6");
  Choices<plot::StandardRow> rows = row_choices();
  add_choice(*command, "--row", a.rows, "A row of the usual four; repeatable", rows);
  command
      ->add_option("--matrix", a.matrices,
                   "A matrix a,b,c,d; repeatable. With --sweep: where it starts from [1,0,1,0]")
      ->type_name("A,B,C,D")
      ->delimiter(';');
  command
      ->add_option("--sweep", a.sweeps,
                   "One number of the matrix in equal steps, e.g. c=0.6:0.1:4; repeatable")
      ->type_name("NAME=FROM:TO:COUNT");
  auto* brdf = command->add_option("--brdf", a.brdf,
                                   "Lobes fitted to a BRDF by name (openltc fit --list), or a MERL "
                                   "file FILE.binary");
  command->add_option("--theta", a.theta, "View angles of --brdf, degrees [0,30,60,80]")
      ->delimiter(',')
      ->type_name("A,B,...")
      ->check(CLI::Range(0.0, 89.9))
      ->needs(brdf);
  command->add_option("--roughness", a.roughness, "Roughnesses of --brdf [0.5]")
      ->delimiter(',')
      ->type_name("A,B,...")
      ->check(CLI::Range(0.0, 1.0))
      ->needs(brdf);
  command->callback([arguments, &exit_code] {
    exit_code = run_figure(arguments->output, [&] { return make_figure(*arguments); });
  });
}

} // namespace openltc::cli
