// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/commands.h"
#include "cli/options/finite_numbers.h"
#include "cli/process/ending.h"
#include "cli/process/file_watch.h"
#include "cli/process/message.h"
#include "cli/process/standard_streams.h"
#include "openltc/base/quote.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <new>
#include <sstream>
#include <string>

namespace {

// What was wrong with the arguments, and where to read on: one line.
std::string usage_message(const CLI::App* app, const CLI::Error& error) {
  std::string command = "openltc";
  for (const CLI::App* at = app; !at->get_subcommands().empty();) {
    at = at->get_subcommands().front();
    command += " " + at->get_name();
  }
  std::string what = error.what();
  if (app->get_subcommands().empty() && !app->remaining().empty())
    what = fmt::format("no command or option '{}'", app->remaining()[0]);
  std::replace(what.begin(), what.end(), '\n', ' '); // CLI11 lists on lines of their own
  what = openltc::escaped(what);
  return fmt::format("{0}: {1}; see {0} --help\n", command, what);
}

// An empty argument is a variable that a script forgot to fill, not an option that was left out.
void refuse_empty_values(CLI::App& app) {
  for (CLI::Option* option : app.get_options())
    if (option->get_items_expected_max() > 0)
      option->transform(CLI::Validator(
          [](std::string& text) { return std::string(text.empty() ? "must not be empty" : ""); },
          ""));
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
    refuse_empty_values(*command);
}

int run_command(int argc, char** argv) {
  CLI::App app{"OpenLTC: physically based area lights, noise-free.\n"
               "Closed-form shading with linearly transformed cosines (LTC), proved against a "
               "reference."};
  app.name("openltc");
  app.set_version_flag("--version", "openltc " OPENLTC_VERSION);
  app.require_subcommand(1);
  app.failure_message(usage_message);

  int exit_code = openltc::cli::k_exit_ok;
  openltc::cli::add_render(app, exit_code);
  openltc::cli::add_compare(app, exit_code);
  openltc::cli::add_fit(app, exit_code);
  openltc::cli::add_inspect(app, exit_code);
  openltc::cli::add_convert(app, exit_code);
  openltc::cli::add_plot(app, exit_code);
  openltc::cli::add_shaders(app, exit_code);
  openltc::cli::add_view(app, exit_code);
  refuse_empty_values(app);
  openltc::cli::require_finite_numbers(app);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    // Not std::cout and std::cerr, which do not say why they fail.
    std::ostringstream out, err;
    const int code = app.exit(e, out, err);
    openltc::cli::put_text(out.str());
    openltc::cli::say_text(err.str());
    return code == 0 ? openltc::cli::k_exit_ok : openltc::cli::k_exit_usage;
  }
  return exit_code;
}

int run_guarded(int argc, char** argv) {
  try {
    return run_command(argc, argv);
  } catch (const std::bad_alloc&) {
    openltc::cli::say_text("openltc: not enough memory for this job\n");
  } catch (const std::exception& e) {
    openltc::cli::say("openltc: {}\n", openltc::escaped(e.what()));
  }
  return openltc::cli::k_exit_failed;
}

} // namespace

int openltc::cli::fail(const std::string& command, const Error& error, ExitCode code) {
  say("openltc {}: {}\n", command, escaped(error.message));
  return code;
}

int main(int argc, char** argv) {
  openltc::cli::open_standard_streams();
  openltc::cli::end_cleanly_on_signals();
  openltc::cli::watch_files();
  return openltc::cli::finish_standard_output(run_guarded(argc, argv));
}
