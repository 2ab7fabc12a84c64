// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The sub-commands of the tool. Each file of this folder adds one to the application.

#pragma once

#include "cli/process/exit_code.h"
#include "openltc/base/result.h"

#include <CLI/CLI.hpp>

#include <string>

namespace openltc::cli {

/// Prints "openltc COMMAND: message" to stderr and returns `code`.
int fail(const std::string& command, const Error& error, ExitCode code = k_exit_failed);

/// Adds the sub-command with its options to `app`. When it is chosen, its callback runs the job,
/// prints errors to stderr and stores the exit code in `exit_code`.
void add_compare(CLI::App& app, int& exit_code);
void add_convert(CLI::App& app, int& exit_code);
void add_fit(CLI::App& app, int& exit_code);
void add_inspect(CLI::App& app, int& exit_code);
void add_plot(CLI::App& app, int& exit_code);
void add_render(CLI::App& app, int& exit_code);
void add_shaders(CLI::App& app, int& exit_code);
void add_view(CLI::App& app, int& exit_code);

} // namespace openltc::cli
