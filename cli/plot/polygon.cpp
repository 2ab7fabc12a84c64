// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc plot polygon: a polygon under the lobe, and carried by M^-1 under the cosine.

#include "cli/fit_command.h"
#include "cli/plot/plot.h"
#include "openltc/plot/figures/polygon_figure.h"
#include "openltc/plot/lobe_rows.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

namespace openltc::cli {

namespace {

struct PolygonArguments {
  PlotOutput output;
  std::string brdf = "ggx";
  std::optional<std::string> matrix, points;
  double theta = 60, roughness = 0.6;
  plot::PolygonSampling sampling{500, 0};
};

std::string command_of(const PolygonArguments& arguments) {
  const PolygonArguments defaults;
  std::string command = "openltc plot polygon";
  if (arguments.matrix) {
    command += " --matrix " + *arguments.matrix;
  } else {
    if (arguments.brdf != defaults.brdf) command += " --brdf " + shell_word(arguments.brdf);
    if (arguments.theta != defaults.theta) command += fmt::format(" --theta {}", arguments.theta);
    if (arguments.roughness != defaults.roughness)
      command += fmt::format(" --roughness {}", arguments.roughness);
  }
  if (arguments.points) command += fmt::format(" --points \"{}\"", *arguments.points);
  if (arguments.sampling.samples != defaults.sampling.samples)
    command += fmt::format(" --samples {}", arguments.sampling.samples);
  if (arguments.sampling.seed != 0) command += fmt::format(" --seed {}", arguments.sampling.seed);
  return command;
}

Result<plot::PolygonOptions> options_of(const PolygonArguments& arguments) {
  plot::PolygonOptions options;
  options.sampling = arguments.sampling;
  options.command = command_of(arguments);
  if (arguments.points) {
    Result<std::vector<Vec3d>> corners = plot::parse_points(*arguments.points);
    if (!corners) return corners.error();
    options.corners = std::move(*corners);
  }
  if (arguments.matrix) {
    const Result<plot::LobeMatrix> matrix = plot::parse_matrix(*arguments.matrix);
    if (!matrix) return matrix.error();
    options.lobe = plot::lobe_of_matrix(*matrix);
    options.lobe_name = plot::entries_text(*matrix);
    return options;
  }
  const Result<brdf::Brdf> brdf = brdf_of_option(arguments.brdf);
  if (!brdf) return brdf.error();
  const Result<f64::Lobe> lobe = plot::fitted_lobe(*brdf, arguments.theta, arguments.roughness);
  if (!lobe) return lobe.error();
  options.lobe = *lobe;
  options.theta_degrees = arguments.theta;
  options.lobe_name =
      brdf->name + ", " + plot::view_text(*brdf, arguments.theta, arguments.roughness);
  return options;
}

} // namespace

void add_plot_polygon(CLI::App& plot, int& exit_code) {
  auto arguments = std::make_shared<PolygonArguments>();
  PolygonArguments& a = *arguments;
  CLI::App* command = add_figure(
      plot, "polygon", "A polygon under the lobe, and carried by M^-1 under the cosine", a.output);
  command->footer(
      "The integral of the lobe D over a polygon P is that of the cosine over M^-1 P. Both spaces\n"
      "are drawn, with the horizons that cut the polygon, both integrals, one by quadrature and "
      "one\n"
      "in closed form, and samples of D, of which as many lie inside on either side.\n"
      "\n"
      "Examples:\n"
      "  openltc plot polygon\n"
      "  openltc plot polygon --brdf ggx --theta 30 --roughness 0.4\n"
      "  openltc plot polygon --matrix 0.5,-0.6,0.3,0 --points \"-1,-1,1 -1,1,1 -2,1,0.5 "
      "-2,-1,0.5\"");
  auto* brdf = command
                   ->add_option("--brdf", a.brdf,
                                "BRDF by name (openltc fit --list), or a MERL file FILE.binary")
                   ->capture_default_str();
  auto* theta = command->add_option("--theta", a.theta, "View angle, degrees")
                    ->check(CLI::Range(0.0, 89.9))
                    ->capture_default_str();
  auto* roughness = command->add_option("--roughness", a.roughness, "Perceptual roughness")
                        ->check(CLI::Range(0.0, 1.0))
                        ->capture_default_str();
  command->add_option("--matrix", a.matrix, "The lobe by its matrix, a,b,c,d, instead of a BRDF")
      ->type_name("A,B,C,D")
      ->excludes(brdf)
      ->excludes(theta)
      ->excludes(roughness);
  command
      ->add_option(
          "--points", a.points,
          "Corners of the polygon in order, \"x,y,z x,y,z ...\", in shading space: z along "
          "the normal, the viewer at positive x; the shaded point is the origin")
      ->type_name("POINTS");
  command->add_option("--samples", a.sampling.samples, "Samples of the lobe")
      ->check(CLI::Range(1, plot::k_most_samples))
      ->capture_default_str();
  command->add_option("--seed", a.sampling.seed, "Of the samples")->capture_default_str();
  command->callback([arguments, &exit_code] {
    exit_code = run_figure(arguments->output, [&]() -> Result<draw::Figure> {
      const Result<plot::PolygonOptions> options = options_of(*arguments);
      if (!options) return options.error();
      return plot::make_polygon_figure(*options);
    });
  });
}

} // namespace openltc::cli
