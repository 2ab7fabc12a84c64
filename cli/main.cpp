// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/commands.h"

#include <cstdio>

int main(int argc, char** argv) {
  CLI::App app{"OpenLTC: physically based area lights, noise-free.\n"
               "Closed-form shading with linearly transformed cosines (LTC), proved against a "
               "reference."};
  app.name("openltc");
  app.set_version_flag("--version", "openltc " OPENLTC_VERSION);
  app.require_subcommand(1);
  app.failure_message(CLI::FailureMessage::simple);

  int exit_code = openltc::cli::k_exit_ok;
#define OPENLTC_COMMAND(name) openltc::cli::add_##name(app, exit_code);
  OPENLTC_COMMANDS
#undef OPENLTC_COMMAND

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const int code = app.exit(e);
    return code == 0 ? openltc::cli::k_exit_ok : openltc::cli::k_exit_usage;
  }
  return exit_code;
}
