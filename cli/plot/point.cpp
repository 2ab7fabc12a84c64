// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc plot point: one point light by the exact BRDF and by the lobe's density.

#include "cli/commands.h"
#include "cli/fit_command.h"
#include "cli/options/choice.h"
#include "cli/plot/plot.h"
#include "cli/process/message.h"
#include "openltc/fit/polynomial_fit.h"
#include "openltc/plot/figures/point_figure.h"
#include "openltc/table/shading_lobes.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>

namespace openltc::cli {

namespace {

struct PointArguments {
  PlotOutput output;
  plot::PointSetup setup;
  std::vector<double> roughness;
  plot::Scan scan = plot::Scan::along;
  std::string table;
};

Result<draw::Figure> make_figure(const PointArguments& a, bool f0_given) {
  if (f0_given && a.setup.metallic >= 1)
    return Error{"--f0 is of the part that is no metal; give --metallic below 1"};
  plot::PointFigureOptions options;
  options.setup = a.setup;
  options.scan = a.scan;
  const plot::PointSetup standard;
  options.command = "openltc plot point";
  const auto add = [&](const char* name, double value, double usual) {
    if (value != usual) options.command += fmt::format(" {} {:g}", name, value);
  };
  add("--theta", a.setup.theta_degrees, standard.theta_degrees);
  if (!a.roughness.empty()) {
    options.roughness = a.roughness;
    options.command += fmt::format(" --roughness {:g}", fmt::join(a.roughness, ","));
  }
  add("--metallic", a.setup.metallic, standard.metallic);
  add("--base-color", a.setup.base_color, standard.base_color);
  add("--f0", a.setup.f0, standard.f0);
  if (a.scan == plot::Scan::across) options.command += " --scan across";
  if (a.table.empty()) return plot::make_point_figure(options);

  options.command += " --table " + shell_word(a.table);
  std::vector<std::string> notes;
  const Result<table::ShadingLobes> read = table::read_shading_lobes(a.table, notes);
  if (!read) return read.error();
  if (!a.output.quiet)
    for (const std::string& note : notes)
      say("warning: {}\n", note);
  options.label = std::filesystem::path(a.table).filename().string();
  return std::visit(
      [&](const auto& lobes) {
        options.lobes = fit::lobes_of(lobes);
        options.source = render::LobeSource(lobes);
        return plot::make_point_figure(options);
      },
      *read);
}

} // namespace

void add_plot_point(CLI::App& plot, int& exit_code) {
  auto arguments = std::make_shared<PointArguments>();
  PointArguments& a = *arguments;
  CLI::App* command = add_figure(
      plot, "point", "One point light by the exact BRDF and by the lobe's density", a.output);
  command
      ->add_option("--theta", a.setup.theta_degrees,
                   "Angle of light and camera at the mirror point, degrees from the normal, 0 to "
                   "below 90")
      ->capture_default_str();
  command->add_option("--roughness", a.roughness, "Up to four, 0.05 to 1, a row each [0.2,0.5]")
      ->delimiter(',')
      ->type_name("A,B,...");
  command->add_option("--metallic", a.setup.metallic, "0 to 1")->capture_default_str();
  command
      ->add_option("--base-color", a.setup.base_color,
                   "Albedo of the dielectric part, reflectance of the metallic one, 0 to 1")
      ->capture_default_str();
  auto* f0 = command
                 ->add_option("--f0", a.setup.f0,
                              "Reflectance of the dielectric part at normal incidence, 0 to 1")
                 ->capture_default_str();
  const Choices<plot::Scan> scans = {{"along", plot::Scan::along}, {"across", plot::Scan::across}};
  add_choice(*command, "--scan", a.scan, "The plane of incidence, or across it [along]", scans);
  command
      ->add_option("--table", a.table,
                   "Table or polynomial to shade with [the built-in table]; the exact BRDF is ggx")
      ->type_name("FILE");
  command->footer("Examples:\n"
                  "  openltc plot point                               point.svg, here\n"
                  "  openltc plot point --theta 80 --roughness 0.1,0.3 -o grazing.png\n"
                  "  openltc plot point --metallic 0 --roughness 0.3 --table mine.json");
  command->callback([arguments, f0, &exit_code] {
    exit_code =
        run_figure(arguments->output, [&] { return make_figure(*arguments, f0->count() > 0); });
  });
}

} // namespace openltc::cli
