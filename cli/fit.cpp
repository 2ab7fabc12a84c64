// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc fit: from a BRDF to a lobe table or polynomial, and the report of its error.

#include "cli/commands.h"
#include "cli/fit_command.h"
#include "cli/options/choice.h"
#include "cli/options/number.h"
#include "cli/output_place.h"
#include "cli/process/message.h"
#include "cli/process/standard_streams.h"
#include "openltc/base/atomic_file.h"
#include "openltc/brdf/choose.h"
#include "openltc/fit/fit_job.h"
#include "openltc/fit/report/candidate_file.h"
#include "openltc/table/engine.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

namespace openltc::cli {

namespace {

struct FitArguments {
  std::string brdf = "ggx"; ///< name, or path of a MERL file
  fit::FitRequest request;
  int engine = -1;                  ///< of table::all_engines(), if any
  std::vector<std::string> outputs; ///< folders where there is an engine
  std::vector<std::string> reports;
  std::vector<std::string> against;
  bool list = false;
  bool quiet = false;

  const table::Engine* engine_asked() const {
    return engine < 0 ? nullptr : &table::all_engines()[std::size_t(engine)];
  }
};

int list_brdfs() {
  for (const brdf::Brdf& b : brdf::all_brdfs()) {
    put("{:<14} {}\n{:14} {}\n", b.name, b.variant, "", b.source);
    put("{:14} {}\n", "", b.has_parameter() ? "roughness: " + b.parameter : "no parameter");
  }
  put("{:<14} a measured material of the MERL database, isotropic; no parameter\n{:14} "
      "Matusik, Pfister, Brand, McMillan 2003, A Data-Driven Reflectance Model\n",
      "FILE.binary", "");
  return k_exit_ok;
}

// As against a name, which is then wrong usage.
bool is_file(const std::string& brdf) {
  return std::filesystem::path(brdf).extension() == ".binary";
}

bool is_page(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension == ".html" || extension == ".htm";
}

Status check_report(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension != ".json" && !is_page(path))
    return Error{path + ": a report is written as .json or .html"};
  return Success{};
}

Status write_text(const std::string& path, const std::string& text) {
  return write_atomically(path, [&](const std::string& temporary) -> Status {
    std::ofstream file(temporary, std::ios::binary);
    file << text;
    file.close();
    if (!file) return Error{path + ": cannot write; is the disk full?"};
    return Success{};
  });
}

// The files to compare with, and what had to be guessed about them.
Result<std::vector<fit::Candidate>> read_candidates(const FitArguments& arguments) {
  std::vector<fit::Candidate> candidates;
  std::vector<std::string> notes;
  for (const std::string& path : arguments.against) {
    std::string note;
    Result<fit::Candidate> other = fit::read_candidate(path, note);
    if (!other) return other.error();
    if (!note.empty()) notes.push_back(note);
    candidates.push_back(std::move(*other));
  }
  if (!arguments.quiet)
    for (const std::string& note : notes)
      say("{}\n", note);
  return candidates;
}

// The report's candidates: what was fitted, the files to compare with, and the best that any single
// lobe could do.
Result<fit::Report> make_fit_report(const brdf::Brdf& brdf, const fit::FittedLobes& fitted,
                                    const std::vector<fit::Candidate>& others,
                                    const FitArguments& arguments) {
  std::vector<fit::Candidate> candidates = {fit::candidate_of(fitted, arguments.request)};
  candidates.insert(candidates.end(), others.begin(), others.end());
  if (!arguments.reports.empty()) candidates.push_back(fit::limit_of(brdf, fitted));
  fit::ReportOptions options;
  if (arguments.reports.empty()) { // the text shows neither
    options.worst_cells = 0;
    candidates.front().nodes = {};
    // Half of the time of a fit to a file goes to the rectangles: only where errors are asked for.
    if (!arguments.outputs.empty() && others.empty()) options.lights.count = 0;
  }
  options.title = fmt::format("{}: error of fitted lobes", brdf.name);
  options.command = arguments.request.command;
  for (const std::string& path : arguments.against)
    options.command += fmt::format(" --against {}", shell_word(path));
  options.tool_version = OPENLTC_VERSION;
  return fit::make_report(brdf, candidates, options);
}

// The files that will be written, or why they cannot.
Result<std::vector<std::string>> planned_files(const brdf::Brdf& brdf,
                                               const FitArguments& arguments) {
  const table::Engine* engine = arguments.engine_asked();
  if (!engine) return fit::check_outputs(brdf, arguments.request, arguments.outputs);
  if (arguments.outputs.empty()) return std::vector<std::string>{};
  return table::engine_paths(*engine, arguments.outputs[0]);
}

Result<std::vector<std::string>> write_output(const fit::FittedLobes& fitted,
                                              const FitArguments& arguments,
                                              const std::string& path) {
  const table::Engine* engine = arguments.engine_asked();
  if (!engine) return fit::write_lobes(fitted, path);
  return table::write_engine_files(std::get<table::PackedTable>(fitted.stored), *engine, path);
}

int run_fit(const FitArguments& arguments) {
  if (arguments.list) return list_brdfs();
  const fit::FitRequest& request = arguments.request;
  const table::Engine* engine = arguments.engine_asked();
  if (Status status = fit::check_extensions(request, arguments.outputs); !engine && !status) {
    fail("fit", status.error());
    return k_exit_usage;
  }
  const Result<brdf::Brdf> brdf = brdf::choose_brdf(arguments.brdf);
  if (!brdf) {
    fail("fit", brdf.error());
    return is_file(arguments.brdf) ? k_exit_failed : k_exit_usage;
  }
  // Find out now, not after the work, what cannot be written or read.
  Result<std::vector<std::string>> files = planned_files(*brdf, arguments);
  if (!files) return fail("fit", files.error());
  for (const std::string& path : arguments.reports) {
    if (Status status = check_report(path); !status) return fail("fit", status.error());
    files->push_back(path);
  }
  if (Status status = check_places(*files); !status) return fail("fit", status.error());
  const Result<std::vector<fit::Candidate>> others = read_candidates(arguments);
  if (!others) return fail("fit", others.error());
  if (Status status = check_not_read(*files); !status) return fail("fit", status.error());

  const bool terminal = isatty(STDERR_FILENO) != 0 && !arguments.quiet;
  const auto progress = [&](double share) {
    if (terminal) say("\rfitting {}: {:3.0f} % ", brdf->name, share * 100);
    return true;
  };
  Result<fit::FittedLobes> fitted = fit::fit_lobes(*brdf, request, progress);
  if (terminal) say("\r{:60}\r", "");
  if (!fitted) return fail("fit", fitted.error());
  if (!arguments.quiet) {
    say("fitted {} in {:.3f} s\n", brdf->name, fitted->seconds);
    if (!fitted->note.empty()) say("{}\n", fitted->note);
    if (!fitted->warning.empty()) say("{}\n", fitted->warning);
  }
  const Result<fit::Report> report = make_fit_report(*brdf, *fitted, *others, arguments);
  if (!report) return fail("fit", report.error());
  fit::state_error(*fitted, report->regions.front().errors.front());
  put("{}", fit::to_text(*report));

  std::vector<std::string> written;
  FileGroup together;
  for (const std::string& path : arguments.outputs) {
    const Result<std::vector<std::string>> done = write_output(*fitted, arguments, path);
    if (!done) return fail("fit", done.error());
    written.insert(written.end(), done->begin(), done->end());
  }
  for (const std::string& path : arguments.reports) {
    const std::string text = is_page(path) ? fit::to_html(*report) : fit::to_json(*report);
    if (Status status = write_text(path, text); !status) return fail("fit", status.error());
    written.push_back(path);
  }
  if (Status status = together.commit(); !status) return fail("fit", status.error());
  if (arguments.quiet) return k_exit_ok;
  for (const std::string& path : written)
    say("wrote {}\n", path);
  if (engine && !arguments.outputs.empty()) {
    say("{}: put {} into {}\n", engine->title, fmt::join(engine->files, " and "), engine->place);
    if (engine->slip[0] != '\0') say("{} {}\n", engine->title, engine->slip);
  }
  if (const auto* packed = std::get_if<table::PackedTable>(&fitted->stored)) {
    const std::string note = fit::size_note(*packed);
    if (!note.empty() && !arguments.outputs.empty()) say("{}\n", note);
  }
  return k_exit_ok;
}

/// Options that are for one form of lobes alone.
struct FormOptions {
  std::vector<CLI::Option*> of_tables;
  std::vector<CLI::Option*> of_one_lobe;
  std::vector<CLI::Option*> of_no_engine;
  CLI::Option* size = nullptr;
  CLI::Option* of_polynomials = nullptr;
};

FormOptions add_request_options(CLI::App& command, FitArguments& arguments) {
  fit::FitRequest& c = arguments.request;
  auto* size = command
                   .add_option("--size", c.size,
                               "Nodes per axis of a table, 2 to 512; of two lobes 32 unless given")
                   ->transform(whole_number(2, 512))
                   ->capture_default_str();
  command
      .add_option("--objective", c.objective,
                  "What the fit minimises: balanced, tv, l2, l3, or weights TV,L2,L3")
      ->check(CLI::Validator(
          [](std::string& text) -> std::string {
            const Result<fit::Objective> found = fit::find_objective(text);
            return found ? "" : found.error().message;
          },
          ""))
      ->capture_default_str();
  const Choices<table::LobeForm> forms = {
      {"table", table::LobeForm::table},
      {"polynomial", table::LobeForm::polynomial},
      {"two-lobe", table::LobeForm::two_lobe},
      {"two-lobe-polynomial", table::LobeForm::two_lobe_polynomial}};
  auto* form = add_choice(
      command, "--form", c.form,
      "Table, or polynomials instead of one; both also of two lobes, half the error [table]",
      forms);
  auto* degree =
      command.add_option("--degree", c.degree, "Total degree of the polynomials, 3 to 6")
          ->transform(whole_number(table::LobePolynomial::k_min_degree,
                                   table::LobePolynomial::k_max_degree))
          ->capture_default_str();
  Choices<int> engines;
  for (const table::Engine& engine : table::all_engines())
    engines.emplace_back(engine.name, int(engines.size()));
  add_choice(command, "--engine", arguments.engine,
             "Files for this engine instead of its own table: layout, size, precision, container "
             "and names are the engine's, -o is a folder",
             engines);
  Choices<table::Layout> layouts;
  for (const table::Layout layout : table::all_layouts())
    layouts.emplace_back(name_of(layout), layout);
  auto* layout =
      add_choice(command, "--layout", c.layout, "Whose look-up reads the table [native]", layouts);
  const Choices<table::Precision> precisions = {
      {name_of(table::Precision::float32), table::Precision::float32},
      {name_of(table::Precision::float16), table::Precision::float16}};
  auto* precision =
      add_choice(command, "--precision", c.precision, "Numbers of a table [float32]", precisions);
  const Choices<fit::Refine> refines = {
      {"auto", fit::Refine::automatic}, {"on", fit::Refine::on}, {"off", fit::Refine::off}};
  auto* refine = add_choice(
      command, "--refine", c.refine,
      "Fit all nodes once more, jointly, through the bilinear look-up of the layout; auto "
      "does so up to 32 nodes of layout native, and with --engine [auto]",
      refines);
  auto* clip_aware = command.add_flag(
      "--clip-aware", c.clip_aware,
      "For layouts other than native: fit for a renderer that clips lights at the surface's "
      "horizon, amplitudes over the share of the lobe above it; the file says horizon divided");
  return {{size, layout, precision, refine, clip_aware},
          {layout, refine, clip_aware},
          {size, form, layout, precision},
          size,
          degree};
}

void add_file_options(CLI::App& command, FitArguments& arguments) {
  command
      .add_option(
          "-o,--output", arguments.outputs,
          "File to write; the container by extension: .json .dds .ktx2 .exr .npy .h .glsl "
          ".hlsl .wgsl .js, or .cpp/.inc, C++ source of the built-in; with --engine a folder. "
          "May be repeated")
      ->allow_extra_args(false);
  command
      .add_option("--report", arguments.reports,
                  "Write the report to this .json or .html file. May be repeated")
      ->allow_extra_args(false);
  command
      .add_option("--against", arguments.against,
                  "A table or polynomial to compare with: any file that this tool writes, or a "
                  "bare published texture. May be repeated")
      ->allow_extra_args(false);
  command.add_flag("--quiet", arguments.quiet, "No progress and messages on stderr");
}

/// What would be passed over in silence is wrong usage.
Status check_form(const FitArguments& arguments, const FormOptions& options) {
  const fit::FitRequest& request = arguments.request;
  const bool polynomial = is_polynomial(request.form);
  const bool two = request.form == table::LobeForm::two_lobe;
  const auto refusal = [&](const CLI::Option* option, const char* form, const char* not_form) {
    return Error{fmt::format("{} is for {}, not for {}", option->get_name(), form, not_form)};
  };
  if (arguments.engine >= 0 && arguments.outputs.size() > 1)
    return Error{"--engine has one folder, so -o is given once"};
  for (const CLI::Option* option : options.of_no_engine)
    if (arguments.engine >= 0 && option->count() > 0)
      return Error{fmt::format("{} is not for --engine, which chooses it", option->get_name())};
  for (const CLI::Option* option : options.of_tables)
    if (polynomial && option->count() > 0)
      return refusal(option, "tables",
                     request.form == table::LobeForm::polynomial ? "--form polynomial"
                                                                 : "--form two-lobe-polynomial");
  for (const CLI::Option* option : options.of_one_lobe)
    if (two && option->count() > 0)
      return refusal(option, "tables of one lobe",
                     "--form two-lobe, whose layout only this project "
                     "reads");
  if (!polynomial && options.of_polynomials->count() > 0)
    return refusal(options.of_polynomials, "--form polynomial", "tables");
  return Success{};
}

} // namespace

void add_fit(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<FitArguments>();
  CLI::App* command =
      app.add_subcommand("fit", "Fit lobes to a BRDF, as a table or a polynomial, and report how "
                                "far they are from it");
  command->footer(k_fit_footer);
  command
      ->add_option("--brdf", arguments->brdf, "BRDF by name (--list), or a MERL file FILE.binary")
      ->capture_default_str();
  command->add_flag("--list", arguments->list, "List the BRDFs, their sources and parameters");
  const FormOptions form_options = add_request_options(*command, *arguments);
  add_file_options(*command, *arguments);
  command->callback([arguments, form_options, &exit_code] {
    fit::FitRequest& request = arguments->request;
    if (Status status = check_form(*arguments, form_options); !status) {
      exit_code = fail("fit", status.error(), k_exit_usage);
      return;
    }
    if (request.form == table::LobeForm::two_lobe && form_options.size->count() == 0)
      request.size = fit::k_two_lobe_size;
    const table::Engine* engine = arguments->engine_asked();
    if (engine) {
      request.layout = engine->layout;
      request.precision = engine->precision;
      request.size = engine->size;
      if (request.refine == fit::Refine::automatic) request.refine = fit::Refine::on;
    }
    request.tool_version = OPENLTC_VERSION;
    request.command = fit_command_of(arguments->brdf, request, engine);
    exit_code = run_fit(*arguments);
  });
}

} // namespace openltc::cli
