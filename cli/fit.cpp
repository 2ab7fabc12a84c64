// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc fit: from a BRDF to a lobe table and the report of its error.

#include "cli/commands.h"
#include "cli/output_place.h"
#include "openltc/base/atomic_file.h"
#include "openltc/brdf/brdf.h"
#include "openltc/fit/error.h"
#include "openltc/fit/table_fit.h"
#include "openltc/table/table_file.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

namespace openltc::cli {

namespace {

struct FitArguments {
  std::string brdf = "ggx";
  int size = 64;
  std::vector<std::string> outputs;
  std::string report;
  bool quiet = false;
};

// The regions of docs and MATHS.md: what scenes use, and the nearly specular end.
struct Region {
  const char* name;
  fit::MeasureOptions options;
};
std::vector<Region> regions() {
  fit::MeasureOptions rough, sharp;
  sharp.roughness_from = 0.01;
  sharp.roughness_to = 0.06;
  return {{"roughness .06-1", rough}, {"roughness .01-.06", sharp}};
}

std::string error_row(const char* label, const fit::LobeError& e) {
  return fmt::format("  {:<5} {:.4f} {:.4f} {:.4f} {:.4f} {:.4f} {:.4f} {:.1e} {:.1e}\n", label,
                     e.tv, e.l1, e.l2, e.l3, e.peak, e.leak, e.n1, e.n5);
}

std::string error_text(const Region& region, const fit::TableError& e) {
  std::string text = fmt::format("{}, theta to {} degrees, {} x {} points between the nodes\n"
                                 "        TV     L1     L2     L3     peak   leak   n1      n5\n",
                                 region.name, e.theta_to_degrees, e.points, e.points);
  return text + error_row("mean", e.mean) + error_row("p95", e.p95) + error_row("max", e.max);
}

std::string json_row(const fit::LobeError& e) {
  return fmt::format("{{\"tv\": {}, \"l1\": {}, \"l2\": {}, \"l3\": {}, \"peak\": {}, \"leak\": "
                     "{}, \"n1\": {}, \"n5\": {}}}",
                     e.tv, e.l1, e.l2, e.l3, e.peak, e.leak, e.n1, e.n5);
}

std::string report_json(const std::string& command, const std::vector<fit::TableError>& errors,
                        double second_difference, double seconds) {
  std::string text = fmt::format("{{\n\"command\": \"{}\",\n\"seconds\": {:.3f},\n\"regions\": [\n",
                                 command, seconds);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const fit::TableError& e = errors[i];
    text += fmt::format("{{\"roughness\": [{}, {}], \"theta_to_degrees\": {}, \"points\": {},\n"
                        " \"mean\": {},\n \"p95\": {},\n \"max\": {}}}{}\n",
                        e.roughness_from, e.roughness_to, e.theta_to_degrees, e.points,
                        json_row(e.mean), json_row(e.p95), json_row(e.max),
                        i + 1 < errors.size() ? "," : "");
  }
  return text + fmt::format("],\n\"second_difference\": {}\n}}\n", second_difference);
}

int fail(const Error& error) {
  fmt::print(stderr, "openltc fit: {}\n", error.message);
  return k_exit_failed;
}

int run_fit(const FitArguments& arguments) {
  const brdf::Brdf* brdf = brdf::find_brdf(arguments.brdf);
  fit::TableFitOptions options;
  options.size = arguments.size;

  for (const std::string& path : arguments.outputs) {
    if (Status status = table::check_writable_extension(path); !status) return fail(status.error());
    if (Status status = check_place(path); !status) return fail(status.error());
  }
  if (!arguments.report.empty())
    if (Status status = check_place(arguments.report); !status) return fail(status.error());

  const bool terminal = isatty(STDERR_FILENO) != 0;
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  const auto progress = [&](double share) {
    if (arguments.quiet || !terminal) return;
    fmt::print(stderr, "\rfitting {} {}x{}: {:3.0f} %, {:.0f} s left ", brdf->name, options.size,
               options.size, share * 100, elapsed() * (1 - share) / share);
    std::fflush(stderr);
  };
  Result<table::LobeTable> fitted = fit::fit_table(*brdf, options, progress);
  if (!arguments.quiet && terminal) fmt::print(stderr, "\r{:60}\r", "");
  if (!fitted) return fail(fitted.error());
  const double seconds = elapsed();
  table::LobeTable& table = *fitted;

  std::vector<fit::TableError> errors;
  std::string text;
  for (const Region& region : regions()) {
    Result<fit::TableError> error = fit::measure_lobes(*brdf, fit::lobes_of(table), region.options);
    if (!error) return fail(error.error());
    errors.push_back(*error);
    text += error_text(region, errors.back());
  }
  fit::describe_table(table, errors[0], OPENLTC_VERSION,
                      fmt::format("openltc fit --brdf {} --size {}", brdf->name, options.size));
  if (!arguments.quiet)
    fmt::print(stderr, "fitted {} {}x{} in {:.1f} s\n", brdf->name, options.size, options.size,
               seconds);
  fmt::print("{}mean second difference of A B C D: {:.2e}\n", text,
             fit::mean_second_difference(table));

  for (const std::string& path : arguments.outputs) {
    const Status status = table::write_table(table, path);
    if (!status.ok()) return fail(status.error());
    if (!arguments.quiet) fmt::print(stderr, "wrote {}\n", path);
  }
  if (!arguments.report.empty()) {
    const std::string json =
        report_json(table.metadata.command, errors, fit::mean_second_difference(table), seconds);
    const Status status =
        write_atomically(arguments.report, [&](const std::string& temporary) -> Status {
          std::ofstream file(temporary, std::ios::binary);
          file << json;
          file.close();
          if (!file) return Error{arguments.report + ": cannot write"};
          return Success{};
        });
    if (!status.ok()) return fail(status.error());
    if (!arguments.quiet) fmt::print(stderr, "wrote {}\n", arguments.report);
  }
  return k_exit_ok;
}

} // namespace

void add_fit(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<FitArguments>();
  CLI::App* command =
      app.add_subcommand("fit", "Fit a table of lobes to a BRDF and report how far it is from it");
  command->footer(
      "For every roughness and view angle the linearly transformed cosine is found that\n"
      "comes closest to the BRDF. The error is measured between the nodes, through the\n"
      "look-up that shading uses: total variation (TV) bounds the shading error of any\n"
      "light, L1 L2 L3 are relative norms, peak is the error of the highlight's brightest\n"
      "point, leak the share of the lobe below the surface.\n"
      "\n"
      "Examples:\n"
      "  openltc fit                              errors only\n"
      "  openltc fit --size 32 -o ggx32.json      a smaller table\n"
      "  openltc fit -o ggx.json --report ggx-errors.json");
  std::vector<std::string> known;
  for (const brdf::Brdf& b : brdf::all_brdfs())
    known.push_back(b.name);
  command->add_option("--brdf", arguments->brdf, "BRDF to fit")
      ->check(CLI::IsMember(known))
      ->capture_default_str();
  command->add_option("--size", arguments->size, "Nodes per axis")
      ->check(CLI::Range(2, 512))
      ->capture_default_str();
  command
      ->add_option("-o,--output", arguments->outputs,
                   "File to write: .json (lossless, with metadata), or .cpp/.inc (the C++ source "
                   "of the built-in table). May be repeated")
      ->allow_extra_args(false);
  command->add_option("--report", arguments->report, "Write the errors as JSON to this file");
  command->add_flag("--quiet", arguments->quiet, "No progress and messages on stderr");
  command->callback([arguments, &exit_code] { exit_code = run_fit(*arguments); });
}

} // namespace openltc::cli
