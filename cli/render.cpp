// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc render: a picture of a glTF scene.

#include "cli/camera_choice.h"
#include "cli/choice.h"
#include "cli/commands.h"
#include "cli/number.h"
#include "cli/output_place.h"
#include "cli/picture_output.h"
#include "cli/pose_options.h"
#include "cli/process/message.h"
#include "cli/process/progress_bar.h"
#include "cli/process/standard_streams.h"
#include "cli/reading_options.h"
#include "cli/shape_options.h"
#include "openltc/base/atomic_file.h"
#include "openltc/base/memory_budget.h"
#include "openltc/image/display.h"
#include "openltc/render/renderer.h"
#include "openltc/render/studio_choice.h"
#include "openltc/scene/gltf.h"
#include "openltc/table/shading_lobes.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace openltc::cli {

namespace {

struct RenderArguments {
  std::string scene;
  std::vector<std::string> outputs;
  render::Integrator integrator = render::Integrator::ltc;
  render::PunctualForm point_lights = render::PunctualForm::exact;
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
  bool half = false;
  bool quiet = false;
  bool json = false;
};

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

/// The lobes to shade with; those of a file are kept in `own`.
Result<render::LobeSource> choose_lobes(const RenderArguments& arguments, table::ShadingLobes& own,
                                        std::vector<std::string>& notes) {
  if (arguments.table.empty()) {
    if (arguments.lobes.value_or(table::LobeForm::table) == table::LobeForm::polynomial)
      return render::LobeSource(table::builtin_ggx_polynomial());
    return render::LobeSource(table::builtin_ggx_table());
  }
  Result<table::ShadingLobes> read = table::read_shading_lobes(arguments.table, notes);
  if (!read) return read.error();
  own = std::move(*read);
  const bool polynomial = std::holds_alternative<table::LobePolynomial>(own);
  if (arguments.lobes && (*arguments.lobes == table::LobeForm::polynomial) != polynomial)
    return Error{fmt::format("{}: holds a lobe {}, but --lobes asks for a {}", arguments.table,
                             polynomial ? "polynomial" : "table",
                             polynomial ? "table" : "polynomial")};
  return std::visit([](const auto& lobes) { return render::LobeSource(lobes); }, own);
}

int run_render(const RenderArguments& arguments) {
  render::RenderOptions options;
  const bool size_given = !arguments.size.empty();
  if (size_given && !parse_size(arguments.size, options.width, options.height))
    return fail("render",
                Error{fmt::format("--size {}: write WIDTHxHEIGHT, e.g. 1280x720", arguments.size)},
                k_exit_usage);
  const bool background_given = !arguments.background.empty();
  if (background_given) {
    const auto background = parse_color(arguments.background);
    if (!background)
      return fail(
          "render",
          Error{fmt::format("--background {}: write one number or R,G,B in nits, each 0 or more",
                            arguments.background)},
          k_exit_usage);
    options.background = *background;
  }
  image::DisplayOptions display = arguments.display;
  if (arguments.exposure != "auto") {
    display.ev100 = parse_float(arguments.exposure);
    if (!display.ev100)
      return fail("render",
                  Error{fmt::format("--exposure {}: write \"auto\" or an EV100 such as 12.5",
                                    arguments.exposure)},
                  k_exit_usage);
    if (Status status = check_ev100(*display.ev100); !status)
      return fail("render", status.error(), k_exit_usage);
  }
  options.integrator = arguments.integrator;
  const bool reference = options.integrator == render::Integrator::reference;
  options.samples =
      arguments.samples.value_or(reference ? k_default_samples_reference : k_default_samples_ltc);
  options.shadow_samples = arguments.shadow_samples;
  options.light_error = arguments.light_error;
  options.punctual_form = arguments.point_lights;
  options.filter = arguments.filter;
  options.seed = arguments.seed;
  options.threads = arguments.threads;
  options.kernel = arguments.kernel;

  // Find out now, not after the work, that a picture cannot be written.
  const bool has_standard_error = reference && options.samples > 1;
  if (Status status = check_outputs(arguments.outputs, has_standard_error); !status.ok())
    return fail("render", status.error());
  if (reference && (arguments.lobes || !arguments.table.empty()))
    return fail(
        "render",
        Error{fmt::format("{}: the reference has no lobes, and its materials are defined with "
                          "the built-in table; use --integrator ltc",
                          arguments.lobes ? "--lobes" : "--table")},
        k_exit_usage);
  if (reference && !has_standard_error && !arguments.quiet)
    say("warning: one sample per pixel has no standard error; it is left out\n");

  const auto load_start = std::chrono::steady_clock::now();
  Result<scene::Scene> loaded =
      scene::load_gltf(arguments.scene, arguments.emissive, arguments.reading);
  if (!loaded) return fail("render", loaded.error());
  scene::Scene& scene = *loaded;
  const double load_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - load_start).count();

  const float wanted_aspect = float(options.width) / float(options.height);
  Result<scene::Camera> camera =
      choose_camera(scene, arguments.camera, arguments.scene, wanted_aspect);
  if (!camera) return fail("render", camera.error());
  if (!size_given && camera->aspect > 0)
    options.width = int(std::clamp(float(options.height) * camera->aspect + 0.5f, 16.0f, 8192.0f));
  MemoryShare picture_memory;
  if (Status status =
          take_picture_memory(picture_memory, options.width, options.height, has_standard_error);
      !status)
    return fail("render", status.error());
  const Result<render::LightsChosen> lights =
      render::choose_lights(scene, arguments.lights, *camera);
  if (!lights) return fail("render", lights.error());
  if (lights->background_nits && !background_given)
    options.background = Vec3f(*lights->background_nits);
  display.usual_exposure = lights->usual_exposure.value_or(0.0f);
  display.light_nits = lights->light_nits;

  table::ShadingLobes own_lobes;
  const Result<render::LobeSource> lobes = choose_lobes(arguments, own_lobes, scene.warnings);
  if (!lobes) return fail("render", lobes.error());
  const std::vector<std::string> files = all_output_files(arguments.outputs, has_standard_error);
  if (Status status = check_not_read(files); !status.ok()) return fail("render", status.error());

  if (!arguments.quiet) {
    for (const std::string& warning : scene.warnings)
      say("warning: {}\n", warning);
    std::size_t triangles = 0;
    for (const scene::Mesh& mesh : scene.meshes)
      triangles += mesh.triangles.size();
    say("{}: {} triangles, {} area and {} punctual lights, loaded in {:.2f} s\n", arguments.scene,
        triangles, scene.lights.area_light_count(), scene.lights.punctual.size(), load_seconds);
    const std::string message = message_of(*lights);
    if (!message.empty()) say("{}\n", message);
    if (scene.lights.empty() && message.empty())
      say("warning: the scene has no light; --lights studio adds one\n");
  }

  Result<render::Picture> picture = [&] {
    ProgressBar bar("rendering", arguments.quiet);
    options.progress = bar.progress();
    return render::render(scene, *camera, *lobes, options);
  }();
  if (!picture) return fail("render", picture.error());
  if (!arguments.quiet)
    for (const std::string& warning : picture->warnings)
      say("warning: {}\n", warning);

  Result<float> exposure = image::resolve_exposure(picture->radiance, display);
  if (!exposure) return fail("render", exposure.error());
  const image::Image* standard_error = has_standard_error ? &picture->standard_error : nullptr;
  const auto precision =
      arguments.half ? image::ExrPrecision::half_float : image::ExrPrecision::full_float;
  FileGroup together;
  for (const std::string& output : arguments.outputs) {
    const Status status = image::write_picture(output, picture->radiance, standard_error, *exposure,
                                               display.tonemap, precision);
    if (!status.ok()) return fail("render", status.error());
  }
  if (Status status = together.commit(); !status.ok()) return fail("render", status.error());
  if (!arguments.quiet)
    for (const std::string& file : files)
      say("wrote {}\n", file);
  if (arguments.half && !arguments.quiet) {
    const auto& values = picture->radiance.data;
    const auto above =
        std::count_if(values.begin(), values.end(), [](float v) { return v > k_largest_half; });
    if (above > 0)
      say("warning: {} values are above {}, the largest that half precision holds, and were "
          "cut; write .exr without --half to keep them\n",
          above, k_largest_half);
  }

  if (arguments.json) {
    const nlohmann::ordered_json report = {
        {"scene", arguments.scene},
        {"integrator", reference ? "reference" : "ltc"},
        {"width", options.width},
        {"height", options.height},
        {"samples", options.samples},
        {"shadow_samples", options.shadow_samples},
        {"area_lights", scene.lights.area_light_count()},
        {"punctual_lights", scene.lights.punctual.size()},
        {"light_error_nits", picture->light_error_nits},
        {"lights_per_point", picture->lights_per_point},
        {"kernel", picture->kernel},
        {"load_seconds", load_seconds},
        {"build_seconds", picture->build_seconds},
        {"render_seconds", picture->render_seconds},
        {"ev100", image::ev100_from_exposure(*exposure)},
        {"outputs", arguments.outputs},
    };
    // A path may hold any bytes; they must not break the output.
    const auto replace = nlohmann::ordered_json::error_handler_t::replace;
    put("{}\n", report.dump(2, ' ', false, replace));
  } else if (!arguments.quiet) {
    say("{}x{}, {} samples per pixel, {}: {:.2f} s; EV100 {:.2f}\n", options.width, options.height,
        options.samples, picture->kernel, picture->render_seconds,
        double(image::ev100_from_exposure(*exposure)));
  }
  return k_exit_ok;
}

} // namespace

void add_render(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<RenderArguments>();
  CLI::App* command =
      app.add_subcommand("render", "Render a glTF scene, lit by its area and point lights");
  command->footer(
      "Area lights are integrated in closed form with linearly transformed cosines (LTC), so the\n"
      "light itself has no noise; shadows are sampled. Lights come from the file: emissive\n"
      "surfaces, KHR_lights_punctual, EXT_lights_area, openltc_light in a node's extras. A file\n"
      "that says nothing of lights gets a studio rig, a file without camera is framed.\n"
      "\n"
      "Examples:\n"
      "  openltc render helmet.glb                          writes helmet.png here\n"
      "  openltc render room.glb -o room.exr -o room.png    radiance and a picture to look at\n"
      "  openltc render room.glb --shadow-samples 0 --samples 64 -o clean.png\n"
      "  openltc render room.glb --integrator reference --samples 1024 -o truth.exr\n"
      "  openltc compare room.exr truth.exr");
  RenderArguments& a = *arguments;
  command->add_option("scene", a.scene, "The scene, .gltf or .glb")->required()->type_name("FILE");
  command
      ->add_option("-o,--output", a.outputs,
                   "File to write, may be repeated; .exr and .hdr hold scene-linear radiance in "
                   "nits, .png an exposed, tone-mapped picture [SCENE.png in this folder]")
      ->allow_extra_args(false)
      ->type_name("FILE");
  const Choices<render::Integrator> integrators = {{"ltc", render::Integrator::ltc},
                                                   {"reference", render::Integrator::reference}};
  command
      ->add_option("--integrator", a.integrator,
                   "ltc: closed form times sampled shadows; reference: unbiased sampling with "
                   "the true BRDF, and a layer \"stderr\" with its standard error [ltc]")
      ->transform(one_of(integrators))
      ->type_name(words_of(integrators));
  command
      ->add_option("--samples", a.samples,
                   "Camera samples per pixel [8; reference 256, each with one light sample]")
      ->transform(whole_number(1, 1 << 20))
      ->type_name("N");
  command
      ->add_option(
          "--shadow-samples", a.shadow_samples,
          "Shadow rays per pixel and area light: half of them where neighbours agree, three times "
          "as many in penumbrae; 0 turns all shadows off")
      ->transform(whole_number(0, 4096))
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--light-error", a.light_error,
                   "Scenes of many area lights: how far a surface's light may be from that of all "
                   "lights one by one, as a fraction of what surfaces there reflect, shadows "
                   "included, and at most of the view's median. Within it, lights are left out or "
                   "taken in groups; 0 shades all")
      ->check(number(0, 1))
      ->type_name("FRACTION")
      ->capture_default_str();
  const Choices<render::PixelFilter> filters = {
      {"blackman-harris", render::PixelFilter::blackman_harris},
      {"none", render::PixelFilter::none}};
  command
      ->add_option("--filter", a.filter,
                   "Reconstruction filter; none: all rays through the middle of the pixel, to "
                   "compare light without edges [blackman-harris]")
      ->transform(one_of(filters))
      ->type_name(words_of(filters));
  const Choices<render::PunctualForm> forms = {{"exact", render::PunctualForm::exact},
                                               {"ltc", render::PunctualForm::ltc}};
  command
      ->add_option("--point-lights", a.point_lights,
                   "Point, spot and directional lights by the exact BRDF or by the density of "
                   "its LTC lobe [exact]")
      ->transform(one_of(forms))
      ->type_name(words_of(forms));
  const Choices<render::LightsFrom> choices = {{"auto", render::LightsFrom::automatic},
                                               {"scene", render::LightsFrom::scene},
                                               {"studio", render::LightsFrom::studio},
                                               {"both", render::LightsFrom::both}};
  command
      ->add_option("--lights", a.lights,
                   "Which lights: those of the scene, a studio rig of three soft boxes, or both "
                   "[scene; studio where it says nothing of lights]")
      ->transform(one_of(choices))
      ->type_name(words_of(choices));
  add_shape_options(*command, a.emissive);
  add_reading_options(*command, a.reading);
  add_pose_options(*command, a.reading.pose);
  command
      ->add_option(
          "--camera", a.camera,
          "Camera by name or number from 0; \"frame\" shows what the scene is of, without its "
          "ground and sky, from where most of it is seen [the first]")
      ->type_name("NAME|N|frame");
  command->add_option("--size", a.size, "WIDTHxHEIGHT in pixels [height 720, the camera's aspect]")
      ->type_name("WxH");
  command
      ->add_option("--background", a.background,
                   "Radiance where nothing is hit, in nits: one number or R,G,B [0; with the "
                   "studio rig alone 0.07, a dark grey]")
      ->type_name("NITS");
  command
      ->add_option(
          "--exposure", a.exposure,
          "EV100 or \"auto\", from the picture or for the studio rig, 99 % of the pixels below "
          "white; for .png only")
      ->capture_default_str()
      ->type_name("EV100|auto");
  const Choices<image::Tonemap> tonemaps = {{"neutral", image::Tonemap::neutral},
                                            {"aces", image::Tonemap::aces},
                                            {"none", image::Tonemap::none}};
  command
      ->add_option("--tonemap", a.display.tonemap,
                   "For .png: Khronos PBR Neutral, ACES, or none [neutral]")
      ->transform(one_of(tonemaps))
      ->type_name(words_of(tonemaps));
  command->add_flag("--half", a.half, "Write .exr in half precision, which ends at 65504 nits");
  const Choices<table::LobeForm> forms_of_lobes = {{"table", table::LobeForm::table},
                                                   {"polynomial", table::LobeForm::polynomial}};
  command
      ->add_option(
          "--lobes", a.lobes,
          "Lobes of the LTC integrator from a table or from a polynomial [what --table holds; "
          "table]")
      ->transform(one_of(forms_of_lobes))
      ->type_name(words_of(forms_of_lobes));
  command
      ->add_option(
          "--table", a.table,
          "Lobes from openltc fit: a table (.json .ktx2 .dds .exr .npy) or a polynomial (.json) "
          "[built-in GGX]")
      ->type_name("FILE");
  command->add_option("--seed", a.seed, "Seed of the sampling")
      ->transform(whole_number(0, std::numeric_limits<std::uint32_t>::max()))
      ->capture_default_str()
      ->type_name("N");
  command
      ->add_option("--threads", a.threads,
                   "Threads, 0 for all cores; the picture is the same for any number")
      ->transform(whole_number(0, 4096))
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--kernel", a.kernel,
                   "Shading kernel, to compare: auto, scalar, sse4, avx2, avx512, neon")
      ->check(CLI::IsMember({"auto", "scalar", "sse4", "avx2", "avx512", "neon"}).description(""))
      ->type_name("NAME")
      ->capture_default_str();
  command->add_flag("--json", a.json, "Print what was done and the times as JSON on stdout");
  command->add_flag("--quiet", a.quiet, "No progress, warnings and messages on stderr");
  command->callback([arguments, &exit_code] {
    if (arguments->outputs.empty()) arguments->outputs = {default_output(arguments->scene)};
    exit_code = run_render(*arguments);
  });
}

} // namespace openltc::cli
