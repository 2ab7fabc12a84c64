// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc plot error: heat maps of a table's error, or of two and their difference.

#include "cli/fit_command.h"
#include "cli/plot/plot.h"
#include "cli/process/message.h"
#include "openltc/fit/measure/limit.h"
#include "openltc/fit/polynomial_fit.h"
#include "openltc/fit/report/candidate_file.h"
#include "openltc/plot/figures/error_figure.h"
#include "openltc/table/lobe_polynomial.h"

#include <fmt/format.h>

#include <cstdlib>
#include <memory>

namespace openltc::cli {

namespace {

// What --table and --against call the lobes that need no file, as openltc render --lobes does; and
// what --against calls the best single lobe of every point.
constexpr const char *k_builtin_table = "table", *k_builtin_polynomial = "polynomial";
constexpr const char* k_limit = "limit";

struct ErrorArguments {
  PlotOutput output;
  std::string brdf = "ggx";
  std::string table = k_builtin_table;
  std::string against;
  std::vector<std::string> norms;
  std::string roughness;
  int points = fit::MeasureOptions{}.points;
};

// "0.06:1", both from 0 to 1 and the lower first.
bool read_range(const std::string& text, double& from, double& to) {
  const std::size_t colon = text.find(':');
  if (colon == 0 || colon == std::string::npos || colon + 1 == text.size()) return false;
  char *from_end = nullptr, *to_end = nullptr;
  const std::string from_text = text.substr(0, colon), to_text = text.substr(colon + 1);
  from = std::strtod(from_text.c_str(), &from_end);
  to = std::strtod(to_text.c_str(), &to_end);
  return *from_end == 0 && *to_end == 0 && from >= 0 && from < to && to <= 1;
}

Result<fit::MeasuredLobes> choose_lobes(const std::string& what, const ErrorArguments& arguments) {
  const bool table = what == k_builtin_table;
  if (table || what == k_builtin_polynomial) {
    if (arguments.brdf != "ggx")
      return Error{fmt::format("the built-in {0} is of ggx, not of {1}; openltc fit --brdf {2} -o "
                               "FILE makes one of {1}; openltc plot error --table FILE draws it",
                               what, arguments.brdf, shell_word(arguments.brdf))};
    if (table) {
      const table::LobeTable& own = table::builtin_ggx_table();
      return fit::MeasuredLobes{fmt::format("built-in table, {} × {}", own.columns, own.rows),
                                fit::lobes_of(own), fit::Horizon::clipped};
    }
    const table::LobePolynomial& own = table::builtin_ggx_polynomial();
    return fit::MeasuredLobes{fmt::format("built-in polynomial, degree {}", own.degree),
                              fit::lobes_of(own), fit::Horizon::clipped};
  }
  std::string note;
  const Result<fit::Candidate> read = fit::read_candidate(what, note);
  if (!read) return read.error();
  if (!note.empty() && !arguments.output.quiet) say("{}\n", note);
  return fit::MeasuredLobes{read->label, read->lobes, read->horizon};
}

Result<fit::MeasuredLobes> limit_of(const brdf::Brdf& brdf, const fit::MeasuredLobes& start) {
  const Result<fit::Objective> balanced = fit::find_objective("balanced");
  if (!balanced) return balanced.error();
  return fit::MeasuredLobes{"limit of single lobes",
                            fit::best_single_lobes(brdf, start.lobes, *balanced),
                            balanced->horizon};
}

std::string command_of(const ErrorArguments& arguments, const std::vector<std::string>& norms) {
  const ErrorArguments standard;
  std::string command = "openltc plot error";
  if (arguments.brdf != standard.brdf)
    command += fmt::format(" --brdf {}", shell_word(arguments.brdf));
  if (arguments.table != standard.table)
    command += fmt::format(" --table {}", shell_word(arguments.table));
  if (!arguments.against.empty())
    command += fmt::format(" --against {}", shell_word(arguments.against));
  if (norms != plot::ErrorFigureOptions{}.norms)
    for (const std::string& norm : norms)
      command += fmt::format(" --norm {}", norm);
  if (!arguments.roughness.empty())
    command += fmt::format(" --roughness {}", shell_word(arguments.roughness));
  if (arguments.points != standard.points) command += fmt::format(" --points {}", arguments.points);
  return command;
}

Result<draw::Figure> make_figure(const ErrorArguments& arguments) {
  const Result<brdf::Brdf> brdf = brdf_of_option(arguments.brdf);
  if (!brdf) return brdf.error();
  plot::ErrorFigureOptions options;
  options.brdf = *brdf;
  options.region.points = arguments.points;
  if (!arguments.norms.empty()) options.norms = arguments.norms;
  if (!arguments.roughness.empty())
    read_range(arguments.roughness, options.region.roughness_from, options.region.roughness_to);
  for (const std::string& what : {arguments.table, arguments.against}) {
    if (what.empty()) continue;
    const bool limit = !options.lobes.empty() && what == k_limit;
    Result<fit::MeasuredLobes> lobes =
        limit ? limit_of(*brdf, options.lobes.front()) : choose_lobes(what, arguments);
    if (!lobes) return lobes.error();
    options.lobes.push_back(std::move(*lobes));
  }
  options.command = command_of(arguments, options.norms);
  return plot::make_error_figure(options);
}

} // namespace

void add_plot_error(CLI::App& plot, int& exit_code) {
  auto arguments = std::make_shared<ErrorArguments>();
  CLI::App* command = add_figure(
      plot, "error", "Heat maps of a table's error over roughness and view angle, for each norm",
      arguments->output);
  ErrorArguments& a = *arguments;
  command->add_option("--brdf", a.brdf, "The truth: a name of openltc fit --list, or a MERL file")
      ->capture_default_str();
  const std::string files = "the built-in table or polynomial, or any file that openltc fit writes "
                            "or engines publish";
  command->add_option("--table", a.table, "Whose error: " + files)
      ->type_name("table|polynomial|FILE")
      ->capture_default_str();
  command
      ->add_option("--against", a.against,
                   "A second one, and the difference: limit, the best single lobe at every "
                   "point by itself, " +
                       files)
      ->type_name("limit|table|polynomial|FILE");
  std::string names;
  for (const fit::LobeErrorField& field : fit::lobe_error_fields())
    names += fmt::format("{}{}", names.empty() ? "" : "|", field.name);
  command->add_option("--norm", a.norms, "A row of maps. May be repeated [tv, l2, peak]")
      ->allow_extra_args(false)
      ->check(CLI::Validator(
          [](const std::string& name) {
            const auto norm = plot::find_norm(name);
            return norm ? std::string() : norm.error().message;
          },
          ""))
      ->type_name(names);
  command->add_option("--roughness", a.roughness, "The range of roughness [0.06:1]")
      ->check(CLI::Validator(
          [](const std::string& text) {
            double from = 0, to = 0;
            return read_range(text, from, to)
                       ? std::string()
                       : fmt::format("must be FROM:TO within 0 to 1, such as 0.01:0.06, not '{}'",
                                     text);
          },
          ""))
      ->type_name("FROM:TO");
  command->add_option("--points", a.points, "Cells along each axis")
      ->check(CLI::Range(4, 256))
      ->capture_default_str();
  command->footer(
      "tv is the share of the energy in the wrong place, l1 l2 l3 are distances relative to the\n"
      "BRDF's, peak compares the maxima, leak is the share of the lobe below the surface, bound "
      "the\n"
      "most that any light of radiance 1 can err by, n1 and n5 are errors of the amplitudes. The\n"
      "numbers are those of openltc fit --report.\n"
      "\n"
      "Examples:\n"
      "  openltc plot error                                       error.svg, here\n"
      "  openltc plot error --against limit --norm tv             how near it is to the best\n"
      "  openltc plot error --table mine.json --against ltc_1.dds --norm bound -o error.png");
  command->callback([arguments, &exit_code] {
    exit_code = run_figure(arguments->output, [&] { return make_figure(*arguments); });
  });
}

} // namespace openltc::cli
