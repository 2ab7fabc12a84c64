// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc render: a picture of a glTF scene.

#include "cli/commands.h"
#include "cli/options/pose_options.h"
#include "cli/output_place.h"
#include "cli/picture_output.h"
#include "cli/process/message.h"
#include "cli/process/progress_bar.h"
#include "cli/process/standard_streams.h"
#include "cli/render_options.h"
#include "openltc/base/atomic_file.h"
#include "openltc/base/memory_budget.h"
#include "openltc/render/view/camera_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace openltc::cli {

namespace {

constexpr int k_default_samples_ltc = 8;
constexpr int k_default_samples_reference = 256;
constexpr float k_largest_half = 65504;

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

/// What the arguments ask for, read; the scene may still change size, background and exposure.
struct RenderJob {
  const RenderArguments& arguments;
  render::RenderOptions options;
  image::DisplayOptions display;
  bool reference = false, has_standard_error = false;
  std::vector<std::string> files; ///< that will be written
};

/// The error names the option: it is wrong usage.
Result<RenderJob> read_arguments(const RenderArguments& arguments) {
  RenderJob job{arguments, {}, arguments.display, false, false, {}};
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
  job.files = all_output_files(arguments.outputs, job.has_standard_error);
  return job;
}

/// The reference has no lobes: to ask it for some is wrong usage.
Status check_lobe_options(const RenderJob& job) {
  const RenderArguments& arguments = job.arguments;
  if (!job.reference || (!arguments.lobes && arguments.table.empty())) return Success{};
  return Error{fmt::format("{}: the reference has no lobes, and its materials are defined with "
                           "the built-in table; use --integrator ltc",
                           arguments.lobes ? "--lobes" : "--table")};
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

/// The lobes to shade with; those of a file are kept in `own`. The materials of the reference are
/// defined with the table of one lobe.
Result<render::LobeSource> choose_lobes(const RenderJob& job, scene::Scene& scene,
                                        table::ShadingLobes& own) {
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
  Result<table::ShadingLobes> read = table::read_shading_lobes(arguments.table, scene.warnings);
  if (!read) return read.error();
  own = std::move(*read);
  const table::LobeForm form = form_of(own);
  if (arguments.lobes && *arguments.lobes != form)
    return Error{fmt::format("{}: holds a lobe {}, but --lobes asks for a {}", arguments.table,
                             name_of(form), name_of(*arguments.lobes))};
  return std::visit([](const auto& lobes) { return render::LobeSource(lobes); }, own);
}

/// A scene as it is rendered: with its camera, the lights that were chosen, and the lobes.
struct PreparedScene {
  scene::Scene scene;
  scene::Camera camera;
  render::LightsChosen lights;
  double load_seconds = 0;
  MemoryShare picture_memory;
};

/// Loads the scene and fits the job to it.
Result<PreparedScene> prepare_scene(RenderJob& job) {
  const RenderArguments& arguments = job.arguments;
  render::RenderOptions& options = job.options;
  const auto load_start = std::chrono::steady_clock::now();
  Result<scene::Scene> loaded =
      scene::load_gltf(arguments.scene, arguments.emissive, arguments.reading);
  if (!loaded) return loaded.error();
  PreparedScene prepared;
  prepared.scene = std::move(*loaded);
  prepared.load_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - load_start).count();

  const float wanted_aspect = float(options.width) / float(options.height);
  Result<scene::Camera> camera =
      render::choose_camera(prepared.scene, arguments.camera, wanted_aspect);
  if (!camera) return wrong_camera(arguments.scene, arguments.camera, camera.error());
  prepared.camera = std::move(*camera);
  if (arguments.size.empty() && prepared.camera.aspect > 0)
    options.width =
        int(std::clamp(float(options.height) * prepared.camera.aspect + 0.5f, 16.0f, 8192.0f));
  if (Status status = take_picture_memory(prepared.picture_memory, options.width, options.height,
                                          job.has_standard_error);
      !status)
    return status.error();

  Result<render::LightsChosen> lights =
      render::choose_lights(prepared.scene, arguments.lights, prepared.camera);
  if (!lights) return lights.error();
  prepared.lights = *lights;
  if (lights->background_nits && arguments.background.empty())
    options.background = Vec3f(*lights->background_nits);
  job.display.usual_exposure = lights->usual_exposure.value_or(0.0f);
  job.display.light_nits = lights->light_nits;
  return prepared;
}

/// What to say of the lights that were chosen; empty: nothing.
std::string message_of(const render::LightsChosen& lights) {
  const std::string in_room =
      lights.rig_is_in_room ? "; walls keep it out, so it is a soft box under the ceiling" : "";
  switch (lights.reason) {
  case render::LightsReason::asked:
    return "";
  case render::LightsReason::unusable_lights:
    return "warning: the file describes lights, but none that can be used: the picture is dark; "
           "--lights studio lights it";
  case render::LightsReason::no_lights:
    return "no lights in the file: lit by a studio rig of three soft boxes (--lights)" + in_room;
  case render::LightsReason::dim_lights:
    return "the only lights in the file are surfaces that emit 1 nit or less: a studio rig is "
           "added (--lights scene leaves it out)" +
           in_room;
  }
  return "";
}

void say_what_is_rendered(const RenderJob& job, const PreparedScene& prepared) {
  const scene::Scene& scene = prepared.scene;
  for (const std::string& warning : scene.warnings)
    say("warning: {}\n", warning);
  std::size_t triangles = 0;
  for (const scene::Mesh& mesh : scene.meshes)
    triangles += mesh.triangles.size();
  say("{}: {} triangles, {} area and {} punctual lights, loaded in {:.2f} s\n", job.arguments.scene,
      triangles, scene.lights.area_light_count(), scene.lights.punctual.size(),
      prepared.load_seconds);
  const std::string message = message_of(prepared.lights);
  if (!message.empty()) say("{}\n", message);
  if (scene.lights.empty() && message.empty())
    say("warning: the scene has no light; --lights studio adds one\n");
}

Result<render::Picture> render_with_progress(RenderJob& job, const PreparedScene& prepared,
                                             const render::LobeSource& lobes) {
  ProgressBar bar("rendering", job.arguments.quiet);
  job.options.progress = bar.progress();
  return render::render(prepared.scene, prepared.camera, lobes, job.options);
}

/// All files or none.
Status write_outputs(const RenderJob& job, const render::Picture& picture, float exposure) {
  const RenderArguments& arguments = job.arguments;
  const auto precision =
      arguments.half ? image::ExrPrecision::half_float : image::ExrPrecision::full_float;
  FileGroup together;
  for (const std::string& output : arguments.outputs)
    if (Status status = image::write_picture(
            output, picture.radiance, job.has_standard_error ? &picture.standard_error : nullptr,
            exposure, job.display.tonemap, precision);
        !status)
      return status;
  return together.commit();
}

void say_what_was_written(const RenderJob& job, const render::Picture& picture) {
  for (const std::string& file : job.files)
    say("wrote {}\n", file);
  if (!job.arguments.half) return;
  const auto& values = picture.radiance.data;
  const auto above =
      std::count_if(values.begin(), values.end(), [](float v) { return v > k_largest_half; });
  if (above > 0)
    say("warning: {} values are above {}, the largest that half precision holds, and were "
        "cut; write .exr without --half to keep them\n",
        above, k_largest_half);
}

void put_json(const RenderJob& job, const PreparedScene& prepared, const render::Picture& picture,
              float ev100) {
  const light::Lights& lights = prepared.scene.lights;
  const nlohmann::ordered_json report = {
      {"scene", job.arguments.scene},
      {"integrator", job.reference ? "reference" : "ltc"},
      {"width", job.options.width},
      {"height", job.options.height},
      {"samples", job.options.samples},
      {"shadow_samples", job.options.shadow_samples},
      {"area_lights", lights.area_light_count()},
      {"punctual_lights", lights.punctual.size()},
      {"light_error_nits", picture.light_error_nits},
      {"lights_per_point", picture.lights_per_point},
      {"kernel", picture.kernel},
      {"load_seconds", prepared.load_seconds},
      {"build_seconds", picture.build_seconds},
      {"render_seconds", picture.render_seconds},
      {"ev100", ev100},
      {"outputs", job.arguments.outputs},
  };
  // A path may hold any bytes; they must not break the output.
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  put("{}\n", report.dump(2, ' ', false, replace));
}

int run_render(const RenderArguments& arguments) {
  Result<RenderJob> job = read_arguments(arguments);
  if (!job) return fail("render", job.error(), k_exit_usage);
  // Find out now, not after the work, that a picture cannot be written.
  if (Status status = check_outputs(arguments.outputs, job->has_standard_error); !status)
    return fail("render", status.error());
  if (Status status = check_lobe_options(*job); !status)
    return fail("render", status.error(), k_exit_usage);
  if (job->reference && !job->has_standard_error && !arguments.quiet)
    say("warning: one sample per pixel has no standard error; it is left out\n");

  Result<PreparedScene> prepared = prepare_scene(*job);
  if (!prepared) return fail("render", prepared.error());
  table::ShadingLobes own_lobes;
  const Result<render::LobeSource> lobes = choose_lobes(*job, prepared->scene, own_lobes);
  if (!lobes) return fail("render", lobes.error());
  if (Status status = check_not_read(job->files); !status) return fail("render", status.error());
  if (!arguments.quiet) say_what_is_rendered(*job, *prepared);

  const Result<render::Picture> picture = render_with_progress(*job, *prepared, *lobes);
  if (!picture) return fail("render", picture.error());
  if (!arguments.quiet)
    for (const std::string& warning : picture->warnings)
      say("warning: {}\n", warning);

  const Result<float> exposure = image::resolve_exposure(picture->radiance, job->display);
  if (!exposure) return fail("render", exposure.error());
  if (Status status = write_outputs(*job, *picture, *exposure); !status)
    return fail("render", status.error());
  if (!arguments.quiet) say_what_was_written(*job, *picture);
  const float ev100 = image::ev100_from_exposure(*exposure);
  if (arguments.json)
    put_json(*job, *prepared, *picture, ev100);
  else if (!arguments.quiet)
    say("{}x{}, {} samples per pixel, {}: {:.2f} s; EV100 {:.2f}\n", job->options.width,
        job->options.height, job->options.samples, picture->kernel, picture->render_seconds,
        double(ev100));
  return k_exit_ok;
}

} // namespace

void add_render(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<RenderArguments>();
  CLI::App* command =
      app.add_subcommand("render", "Render a glTF scene, lit by its area and point lights");
  add_render_options(*command, *arguments);
  command->callback([arguments, &exit_code] {
    if (arguments->outputs.empty()) arguments->outputs = {default_output(arguments->scene)};
    exit_code = run_render(*arguments);
  });
}

} // namespace openltc::cli
