// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What all figures of openltc plot have in common: where they go, and how the job runs.

#pragma once

#include "openltc/brdf/brdf.h"
#include "openltc/draw/figure.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace openltc::cli {

struct PlotOutput {
  std::string what; ///< the figure's name: "lobes"; without -o it goes to lobes.svg
  std::vector<std::string> paths;
  draw::Theme theme = draw::Theme::automatic;
  double scale = 2; ///< pixels of a .png to a unit of the figure
  bool quiet = false;
};

/// A sub-command of openltc plot with the options of every figure. `output` must outlive it.
CLI::App* add_figure(CLI::App& plot, const std::string& what, const std::string& description,
                     PlotOutput& output);

/// Checks the outputs, makes the figure and writes it, all files or none begun; returns the exit
/// code. `make` reports its own progress, if not quiet; an error of its that begins with the name
/// of an option, "--", is wrong usage.
int run_figure(const PlotOutput& output, const std::function<Result<draw::Figure>()>& make);

/// The BRDF that --brdf names. An unknown name is wrong usage, a file that cannot be read is not.
Result<brdf::Brdf> brdf_of_option(const std::string& name_or_path);

/// Each of these adds one figure, in a file of its own.
void add_plot_error(CLI::App& plot, int& exit_code);
void add_plot_fit(CLI::App& plot, int& exit_code);
void add_plot_literal(CLI::App& plot, int& exit_code);
void add_plot_lobes(CLI::App& plot, int& exit_code);
void add_plot_photometry(CLI::App& plot, int& exit_code);
void add_plot_point(CLI::App& plot, int& exit_code);
void add_plot_polygon(CLI::App& plot, int& exit_code);
void add_plot_trade(CLI::App& plot, int& exit_code);

/// "openltc plot WHAT: message" on stderr; the exit code for a job that failed.
int fail_plot(const PlotOutput& output, const Error& error);

} // namespace openltc::cli
