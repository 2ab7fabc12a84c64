// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/render/render_job.h"

#include "cli/options/pose_options.h"
#include "cli/picture_output.h"
#include "openltc/base/atomic_file.h"
#include "openltc/render/view/camera_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <string_view>
#include <utility>
#include <variant>

namespace openltc::cli {

namespace {

constexpr int k_default_samples_ltc = 8;
constexpr int k_default_samples_reference = 256;

std::optional<float> parse_float(std::string_view text) {
  float value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

/// "V" or "R,G,B".
std::optional<Vec3f> parse_color(const std::string& text) {
  std::vector<float> values;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    const auto value = parse_float(std::string_view(text).substr(begin, comma - begin));
    if (!value || *value < 0) return {};
    values.push_back(*value);
    begin = comma + 1;
  }
  if (values.size() == 1) return Vec3f(values[0]);
  if (values.size() == 3) return Vec3f(values[0], values[1], values[2]);
  return {};
}

/// "1280x720".
bool parse_size(const std::string& text, int& width, int& height) {
  const std::size_t x = text.find('x');
  if (x == std::string::npos) return false;
  const auto number = [](std::string_view part, int& out) {
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), out);
    return error == std::errc() && end == part.data() + part.size() && out > 0;
  };
  return number(std::string_view(text).substr(0, x), width) &&
         number(std::string_view(text).substr(x + 1), height);
}

const char* name_of(table::LobeForm form) {
  return form == table::LobeForm::polynomial            ? "polynomial"
         : form == table::LobeForm::two_lobe            ? "table of two lobes"
         : form == table::LobeForm::two_lobe_polynomial ? "polynomial of two lobes"
                                                        : "table";
}

table::LobeForm form_of(const table::ShadingLobes& lobes) {
  if (const auto* polynomial = std::get_if<table::LobePolynomial>(&lobes))
    return polynomial->two_lobes() ? table::LobeForm::two_lobe_polynomial
                                   : table::LobeForm::polynomial;
  return std::get<table::LobeTable>(lobes).two_lobes() ? table::LobeForm::two_lobe
                                                       : table::LobeForm::table;
}

void move_by(const Vec3f& shift, light::Lights& lights) {
  for (light::PolygonLight& light : lights.polygons) {
    for (Vec3f& vertex : light.vertices)
      vertex += shift;
    light.texture_corner += shift;
  }
}

} // namespace

Result<RenderJob> read_arguments(const RenderArguments& arguments) {
  RenderJob job{arguments, {}, arguments.display, false, false, arguments.outputs, {}};
  render::RenderOptions& options = job.options;
  if (!arguments.size.empty() && !parse_size(arguments.size, options.width, options.height))
    return Error{fmt::format("--size {}: write WIDTHxHEIGHT, e.g. 1280x720", arguments.size)};
  if (!arguments.background.empty()) {
    const auto background = parse_color(arguments.background);
    if (!background)
      return Error{fmt::format("--background {}: write one number or R,G,B in nits, each 0 or more",
                               arguments.background)};
    options.background = *background;
  }
  if (arguments.exposure != "auto") {
    job.display.ev100 = parse_float(arguments.exposure);
    if (!job.display.ev100)
      return Error{fmt::format("--exposure {}: write \"auto\" or an EV100 such as 12.5",
                               arguments.exposure)};
    if (Status status = check_ev100(*job.display.ev100); !status) return status.error();
  }
  options.integrator = arguments.integrator;
  job.reference = options.integrator == render::Integrator::reference;
  options.samples = arguments.samples.value_or(job.reference ? k_default_samples_reference
                                                             : k_default_samples_ltc);
  job.has_standard_error = job.reference && options.samples > 1;
  options.shadow_samples = arguments.shadow_samples;
  options.light_error = arguments.light_error;
  options.punctual_form = arguments.point_lights;
  options.specular_form = arguments.specular;
  options.filter = arguments.filter;
  options.seed = arguments.seed;
  options.threads = arguments.threads;
  options.kernel = arguments.kernel;
  job.files = all_output_files(job.outputs, job.has_standard_error);
  return job;
}

Status check_lobe_options(const RenderJob& job) {
  const RenderArguments& arguments = job.arguments;
  if (!job.reference || (!arguments.lobes && arguments.table.empty())) return Success{};
  return Error{fmt::format("{}: the reference has no lobes, and its materials are defined with "
                           "the built-in table; use --integrator ltc",
                           arguments.lobes ? "--lobes" : "--table")};
}

Result<render::LobeSource> choose_lobes(const RenderJob& job, const scene::Scene& scene,
                                        table::ShadingLobes& own,
                                        std::vector<std::string>& warnings) {
  const RenderArguments& arguments = job.arguments;
  if (job.reference) return render::LobeSource(table::builtin_ggx_table());
  if (arguments.table.empty()) {
    if (!arguments.lobes) return render::builtin_lobes_for(scene.lights);
    switch (*arguments.lobes) {
    case table::LobeForm::polynomial:
      return render::LobeSource(table::builtin_ggx_polynomial());
    case table::LobeForm::two_lobe_polynomial:
      return render::LobeSource(table::builtin_ggx_two_lobe_polynomial());
    case table::LobeForm::two_lobe:
      return render::LobeSource(table::builtin_ggx_two_lobe_table());
    case table::LobeForm::table:
      return render::LobeSource(table::builtin_ggx_table());
    }
  }
  Result<table::ShadingLobes> read = table::read_shading_lobes(arguments.table, warnings);
  if (!read) return read.error();
  own = std::move(*read);
  const table::LobeForm form = form_of(own);
  if (arguments.lobes && *arguments.lobes != form)
    return Error{fmt::format("{}: holds a lobe {}, but --lobes asks for a {}", arguments.table,
                             name_of(form), name_of(*arguments.lobes))};
  return std::visit([](const auto& lobes) { return render::LobeSource(lobes); }, own);
}

Result<PreparedScene> prepare_scene(RenderJob& job, const scene::PoseOptions& pose,
                                    const SteadyView* steady) {
  const RenderArguments& arguments = job.arguments;
  render::RenderOptions& options = job.options;
  const auto load_start = std::chrono::steady_clock::now();
  scene::ReadOptions reading = arguments.reading;
  reading.pose = pose;
  Result<scene::Scene> loaded = scene::load_gltf(arguments.scene, arguments.emissive, reading);
  if (!loaded) return loaded.error();
  PreparedScene prepared;
  prepared.scene = std::move(*loaded);
  prepared.load_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - load_start).count();

  // Zero but far away from the file's origin.
  const Vec3d moved = steady ? steady->origin - prepared.scene.origin : Vec3d(0.0);
  const Vec3f shift(float(moved.x), float(moved.y), float(moved.z));
  if (steady && steady->framed) {
    prepared.camera = *steady->framed;
    prepared.camera.position += shift;
  } else {
    const float wanted_aspect = float(options.width) / float(options.height);
    Result<scene::Camera> camera =
        render::choose_camera(prepared.scene, arguments.camera, wanted_aspect);
    if (!camera) return wrong_camera(arguments.scene, arguments.camera, camera.error());
    prepared.camera = std::move(*camera);
  }
  if (arguments.size.empty() && prepared.camera.aspect > 0)
    options.width =
        int(std::clamp(float(options.height) * prepared.camera.aspect + 0.5f, 16.0f, 8192.0f));
  if (Status status = take_picture_memory(prepared.picture_memory, options.width, options.height,
                                          job.has_standard_error);
      !status)
    return status.error();

  if (steady) {
    prepared.lights = steady->lights;
    move_by(shift, prepared.lights.rig);
    render::use_lights(prepared.scene, prepared.lights);
  } else {
    Result<render::LightsChosen> lights =
        render::choose_lights(prepared.scene, arguments.lights, prepared.camera);
    if (!lights) return lights.error();
    prepared.lights = std::move(*lights);
  }
  const render::LightsChosen& lights = prepared.lights;
  if (lights.background_nits && arguments.background.empty())
    options.background = Vec3f(*lights.background_nits);
  job.display.usual_exposure = lights.usual_exposure.value_or(0.0f);
  job.display.light_nits = lights.light_nits;
  return prepared;
}

SteadyView steady_view_of(const RenderJob& job, const PreparedScene& prepared) {
  SteadyView steady{prepared.scene.origin, {}, prepared.lights};
  const std::string& choice = job.arguments.camera;
  if (choice == "frame" || (choice.empty() && prepared.scene.cameras.empty()))
    steady.framed = prepared.camera;
  return steady;
}

Result<render::Picture> render_and_write(const RenderJob& job, const PreparedScene& prepared,
                                         const render::LobeSource& lobes, float* exposure) {
  Result<render::Picture> picture =
      render::render(prepared.scene, prepared.camera, lobes, job.options);
  if (!picture) return picture.error();
  const Result<float> factor = image::resolve_exposure(picture->radiance, job.display);
  if (!factor) return factor.error();
  if (exposure) *exposure = *factor;
  const auto precision =
      job.arguments.half ? image::ExrPrecision::half_float : image::ExrPrecision::full_float;
  FileGroup together;
  for (const std::string& output : job.outputs)
    if (Status status = image::write_picture(
            output, picture->radiance, job.has_standard_error ? &picture->standard_error : nullptr,
            *factor, job.display.tonemap, precision);
        !status)
      return status.error();
  if (Status status = together.commit(); !status) return status.error();
  return picture;
}

} // namespace openltc::cli
