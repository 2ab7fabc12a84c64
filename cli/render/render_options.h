// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The options of openltc render.

#pragma once

#include "openltc/image/display.h"
#include "openltc/render/renderer.h"
#include "openltc/render/view/studio_choice.h"
#include "openltc/scene/gltf.h"
#include "openltc/table/shading_lobes.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace openltc::cli {

/// What the command line says. Texts are not yet read.
struct RenderArguments {
  std::string scene;
  std::vector<std::string> outputs;
  render::Integrator integrator = render::Integrator::ltc;
  render::PunctualForm point_lights = render::PunctualForm::exact;
  std::optional<render::SpecularForm> specular;
  render::LightsFrom lights = render::LightsFrom::automatic;
  std::string camera;
  std::string size;
  std::string background;
  std::optional<table::LobeForm> lobes;
  std::string table;
  std::optional<int> samples;
  int shadow_samples = 16;
  float light_error = render::RenderOptions{}.light_error;
  image::DisplayOptions display;
  render::PixelFilter filter = render::PixelFilter::blackman_harris;
  std::string exposure = "auto";
  std::uint32_t seed = 0;
  int threads = 0;
  std::string kernel = "auto";
  scene::EmissiveOptions emissive;
  scene::ReadOptions reading;
  std::string frames; ///< of the animation; empty: one picture
  double frames_per_second = 24;
  bool list_missing = false;
  std::string scheduler;
  /// Every option that was given and what with, but for those that leave a frame as it is.
  std::string picture_options;
  bool half = false;
  bool quiet = false;
  bool json = false;
};

/// Adds all options to `command`, which writes into `arguments`; these must live as long.
void add_render_options(CLI::App& command, RenderArguments& arguments);

} // namespace openltc::cli
