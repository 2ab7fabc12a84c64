// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/commands.h"
#include "openltc/base/quote.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
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

} // namespace

int openltc::cli::fail(const std::string& command, const Error& error, ExitCode code) {
  fmt::print(stderr, "openltc {}: {}\n", command, escaped(error.message));
  return code;
}

int main(int argc, char** argv) {
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

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const int code = app.exit(e);
    return code == 0 ? openltc::cli::k_exit_ok : openltc::cli::k_exit_usage;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "openltc: not enough memory for this job\n");
    return openltc::cli::k_exit_failed;
  } catch (const std::exception& e) {
    fmt::print(stderr, "openltc: {}\n", e.what());
    return openltc::cli::k_exit_failed;
  }
  return exit_code;
}
