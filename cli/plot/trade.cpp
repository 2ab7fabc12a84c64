// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc plot trade: error over time of every form of the closed form, on any scenes.

#include "cli/fit_command.h"
#include "cli/options/number.h"
#include "cli/options/pose_options.h"
#include "cli/options/reading_options.h"
#include "cli/plot/plot.h"
#include "cli/process/message.h"
#include "cli/process/progress_bar.h"
#include "cli/process/standard_streams.h"
#include "openltc/plot/figures/trade_figure.h"
#include "openltc/render/view/camera_choice.h"
#include "openltc/render/view/studio_choice.h"
#include "openltc/scene/gltf.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace openltc::cli {

namespace {

constexpr float k_usual_aspect = 16.0f / 9;

struct TradeArguments {
  PlotOutput output;
  std::vector<std::string> scenes;
  int samples = render::TradeOptions{}.samples;
  int height = render::TradeOptions{}.height;
  std::string kernel = "auto";
  scene::ReadOptions reading;
};

std::string command_of(const TradeArguments& a) {
  std::string command = "openltc plot trade";
  const auto folder_of = [](const std::string& file) {
    return std::filesystem::path(file).parent_path().string();
  };
  for (auto file = a.scenes.begin(); file != a.scenes.end();) {
    const std::string folder = folder_of(*file);
    const auto end = std::find_if(
        file, a.scenes.end(), [&](const std::string& other) { return folder_of(other) != folder; });
    if (end - file > 3) { // the folder says enough
      command += folder.empty() ? " *" : " " + shell_word(folder) + "/*";
      file = end;
    } else {
      command += " " + shell_word(*file++);
    }
  }
  const TradeArguments standard;
  if (a.samples != standard.samples) command += fmt::format(" --samples {}", a.samples);
  if (a.height != standard.height) command += fmt::format(" --height {}", a.height);
  if (a.kernel != standard.kernel) command += " --kernel " + a.kernel;
  return command;
}

/// Nothing where the picture is black.
Result<std::optional<render::TradeErrors>> measure(const TradeArguments& a,
                                                   const std::string& file) {
  Result<scene::Scene> scene = scene::load_gltf(file, {}, a.reading);
  if (!scene) return scene.error();
  Result<scene::Camera> camera = render::choose_camera(*scene, "", k_usual_aspect);
  if (!camera) return wrong_camera(file, "", camera.error());
  const Result<render::LightsChosen> lights =
      render::choose_lights(*scene, render::LightsFrom::automatic, *camera);
  if (!lights) return lights.error();
  render::TradeOptions options;
  options.samples = a.samples;
  options.height = a.height;
  const float aspect = camera->aspect > 0 ? camera->aspect : k_usual_aspect;
  options.width = std::clamp(int(float(a.height) * aspect + 0.5f), 1, 8192);
  ProgressBar bar(std::filesystem::path(file).stem().string(), a.output.quiet);
  options.progress = bar.progress();
  Result<std::optional<render::TradeErrors>> errors =
      render::trade_errors(*scene, *camera, options);
  if (!errors) return Error{fmt::format("{}: {}", file, errors.error().message)};
  return errors;
}

Result<draw::Figure> make_figure(const TradeArguments& a) {
  plot::Trade trade;
  trade.samples = a.samples;
  trade.command = command_of(a);
  const Result<render::TradeValues> times = render::time_of_quad(a.kernel);
  if (!times) return times.error();
  trade.nanoseconds = *times;
  trade.kernel = render::kernel_by_name(a.kernel.c_str()).name;
  for (const std::string& file : a.scenes) {
    const Result<std::optional<render::TradeErrors>> errors = measure(a, file);
    if (!errors) return errors.error();
    if (*errors)
      trade.scenes.push_back({std::filesystem::path(file).stem().string(), **errors});
    else if (!a.output.quiet)
      say("warning: {}: its picture is black, so no error can be a share of it; left out\n", file);
  }
  if (trade.scenes.empty()) return Error{"every picture is black: nothing lights what is seen"};
  put("{}", plot::trade_table(trade));
  return plot::make_trade_figure(trade);
}

} // namespace

void add_plot_trade(CLI::App& plot, int& exit_code) {
  auto arguments = std::make_shared<TradeArguments>();
  TradeArguments& a = *arguments;
  CLI::App* command = add_figure(
      plot, "trade", "Error over time of every way to shade by an area light, on your scenes",
      a.output);
  command->add_option("scenes", a.scenes, "glTF scenes, .gltf or .glb")->required();
  command->add_option("--samples", a.samples, "Samples of the reference per pixel")
      ->transform(whole_number(2, 1 << 20))
      ->capture_default_str()
      ->type_name("N");
  command->add_option("--height", a.height, "Height of the pictures in pixels")
      ->transform(whole_number(1, 4096))
      ->capture_default_str()
      ->type_name("N");
  command->add_option("--kernel", a.kernel, "Shading kernel to time, as for openltc render")
      ->capture_default_str()
      ->type_name("NAME");
  add_reading_options(*command, a.reading);
  command->footer(
      "One lobe and two, each by itself and times the BRDF's ratio to it in the light's mean\n"
      "direction, two with GGX itself where they err, which openltc render takes, and GGX itself.\n"
      "Every scene is rendered without shadows by each of them and by the reference; the error\n"
      "is the sum of |picture - reference| over the reference's. The time is that of one more\n"
      "quad at a point. The numbers go to stdout as a table in Markdown; its last column is how\n"
      "much of the error may be the reference's noise: more --samples halve it.\n"
      "\n"
      "Examples:\n"
      "  openltc plot trade room.glb                              trade.svg, here\n"
      "  openltc plot trade scenes/*.glb --samples 4096 -o trade.png");
  command->callback([arguments, &exit_code] {
    exit_code = run_figure(arguments->output, [&] { return make_figure(*arguments); });
  });
}

} // namespace openltc::cli
