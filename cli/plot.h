// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc plot: the figures, one file per figure.

#pragma once

#include "openltc/base/result.h"
#include "openltc/plot/sketch.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace openltc::cli {

/// Where a figure goes, the same for all.
struct PlotOutput {
  std::vector<std::string> files; ///< none = FIGURE.svg in the current folder
  plot::Theme theme = plot::Theme::automatic;
  bool quiet = false;
};

/// Adds -o, --background and --quiet.
void add_plot_output(CLI::App& command, PlotOutput& output, const std::string& figure);

/// Checks the files, draws, writes and reports; the exit code. `make` returns the figure; an error
/// that begins with an option, "--", is wrong usage.
int run_plot(const std::string& figure, const PlotOutput& output,
             const std::function<Result<plot::Sketch>()>& make);

void add_plot_lobes(CLI::App& plot, int& exit_code);
void add_plot_polygon(CLI::App& plot, int& exit_code);

} // namespace openltc::cli
