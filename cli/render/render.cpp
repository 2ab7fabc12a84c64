// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc render: a picture of a glTF scene.

#include "cli/commands.h"
#include "cli/output_place.h"
#include "cli/picture_output.h"
#include "cli/process/message.h"
#include "cli/process/progress_bar.h"
#include "cli/process/standard_streams.h"
#include "cli/render/render_frames.h"
#include "cli/render/render_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

namespace openltc::cli {

namespace {

constexpr float k_largest_half = 65504;

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
  if (Status status = check_outputs(job->outputs, job->has_standard_error); !status)
    return fail("render", status.error());
  if (Status status = check_lobe_options(*job); !status)
    return fail("render", status.error(), k_exit_usage);
  if (job->reference && !job->has_standard_error && !arguments.quiet)
    say("warning: one sample per pixel has no standard error; it is left out\n");

  Result<PreparedScene> prepared = prepare_scene(*job, arguments.reading.pose);
  if (!prepared) return fail("render", prepared.error());
  table::ShadingLobes own_lobes;
  const Result<render::LobeSource> lobes =
      choose_lobes(*job, prepared->scene, own_lobes, prepared->scene.warnings);
  if (!lobes) return fail("render", lobes.error());
  if (Status status = check_not_read(job->files); !status) return fail("render", status.error());
  if (!arguments.quiet) say_what_is_rendered(*job, *prepared);

  float exposure = 0;
  const Result<render::Picture> picture = [&] {
    ProgressBar bar("rendering", arguments.quiet);
    job->options.progress = bar.progress();
    return render_and_write(*job, *prepared, *lobes, &exposure);
  }();
  if (!picture) return fail("render", picture.error());
  if (!arguments.quiet)
    for (const std::string& warning : picture->warnings)
      say("warning: {}\n", warning);
  if (!arguments.quiet) say_what_was_written(*job, *picture);
  const float ev100 = image::ev100_from_exposure(exposure);
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
  command->callback([arguments, command, &exit_code] {
    arguments->picture_options = picture_options(*command);
    if (!arguments->frames.empty()) {
      exit_code = run_render_frames(*arguments);
      return;
    }
    if (arguments->outputs.empty()) arguments->outputs = {default_output(arguments->scene)};
    exit_code = run_render(*arguments);
  });
}

} // namespace openltc::cli
