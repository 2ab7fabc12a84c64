// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/plot.h"

#include "cli/choice.h"
#include "cli/commands.h"
#include "cli/output_place.h"
#include "openltc/base/atomic_file.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>

namespace openltc::cli {

namespace {

int fail(const std::string& figure, const Error& error, int code) {
  fmt::print(stderr, "openltc plot {}: {}\n", figure, error.message);
  return code;
}

Status check_files(const std::vector<std::string>& files) {
  std::set<std::filesystem::path> seen;
  for (const std::string& file : files) {
    if (std::filesystem::path(file).extension() != ".svg")
      return Error{file + ": a figure is written as .svg"};
    if (Status status = check_place(file); !status) return status;
    std::error_code ec;
    if (!seen.insert(std::filesystem::weakly_canonical(file, ec)).second)
      return Error{file + ": would be written twice; give each -o a name of its own"};
  }
  return Success{};
}

} // namespace

void add_plot_output(CLI::App& command, PlotOutput& output, const std::string& figure) {
  command.add_option("-o,--output", output.files,
                     fmt::format("Picture to write, .svg; repeatable [{}.svg]", figure));
  const Choices<plot::Theme> themes = {
      {"auto", plot::Theme::automatic}, {"light", plot::Theme::light}, {"dark", plot::Theme::dark}};
  command
      .add_option("--background", output.theme,
                  "Page the figure stands on; auto follows the reader [auto]")
      ->transform(one_of(themes))
      ->type_name(words_of(themes));
  command.add_flag("--quiet", output.quiet, "No messages");
}

int run_plot(const std::string& figure, const PlotOutput& output,
             const std::function<Result<plot::Sketch>()>& make) {
  const std::vector<std::string> files =
      output.files.empty() ? std::vector<std::string>{figure + ".svg"} : output.files;
  if (Status status = check_files(files); !status)
    return fail(figure, status.error(), k_exit_failed);
  const Result<plot::Sketch> sketch = make();
  if (!sketch) {
    const bool usage = sketch.error().message.rfind("--", 0) == 0;
    return fail(figure, sketch.error(), usage ? k_exit_usage : k_exit_failed);
  }
  for (const std::string& file : files) {
    const Status written = write_atomically(file, [&](const std::string& temporary) -> Status {
      std::ofstream stream(temporary, std::ios::binary);
      stream << to_svg(*sketch, output.theme);
      stream.close();
      if (!stream) return Error{file + ": cannot write; is the disk full?"};
      return Success{};
    });
    if (!written) return fail(figure, written.error(), k_exit_failed);
    if (!output.quiet) fmt::print(stderr, "wrote {}\n", file);
  }
  return k_exit_ok;
}

void add_plot(CLI::App& app, int& exit_code) {
  CLI::App* plot = app.add_subcommand("plot", "Draw the figures that explain the method");
  plot->require_subcommand(1);
  add_plot_lobes(*plot, exit_code);
  add_plot_polygon(*plot, exit_code);
}

} // namespace openltc::cli
