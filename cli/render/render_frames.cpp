// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Each frame is loaded and rendered by itself, so that it depends on its number alone, not on the
// frames around it nor on who makes those. What must not change from frame to frame, a view that
// was framed, the studio rig and the kind of lobes, is that of the animation's time 0.

#include "cli/render/render_frames.h"

#include "cli/commands.h"
#include "cli/output_place.h"
#include "cli/picture_output.h"
#include "cli/process/fingerprint.h"
#include "cli/process/input_files.h"
#include "cli/process/message.h"
#include "cli/process/progress_bar.h"
#include "cli/process/standard_streams.h"
#include "cli/render/frame_range.h"
#include "cli/render/frame_record.h"
#include "cli/render/render_job.h"
#include "openltc/base/quote.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

namespace openltc::cli {

namespace {

namespace fs = std::filesystem;

/// Everything about a sequence that is known before its first frame is made.
struct Sequence {
  RenderJob job;
  std::vector<int> frames;
  SteadyView steady;
  table::ShadingLobes own_lobes;
  std::optional<render::LobeSource> lobes;
  Fingerprint inputs; ///< of all files, options and the version
};

double seconds_of(const RenderArguments& arguments, int frame) {
  return double(frame) / arguments.frames_per_second;
}

std::vector<std::string> outputs_of(const RenderArguments& arguments, int frame) {
  std::vector<std::string> paths;
  for (const std::string& pattern : arguments.outputs)
    paths.push_back(path_of_frame(pattern, frame));
  return paths;
}

/// What can be said of the arguments before a file is read; it is wrong usage.
Status check_frame_arguments(const RenderArguments& arguments) {
  if (!arguments.scheduler.empty())
    return Error{"--scheduler: this is the tool alone; the command openltc of the Python package "
                 "sends frames to a cluster: pip install \"openltc[cluster]\""};
  for (const std::string& pattern : arguments.outputs) {
    if (!has_frame_number(pattern))
      return Error{fmt::format("-o {}: --frames wants #### in the file's name, where the number of "
                               "the frame goes, such as frame.####.exr",
                               pattern)};
    if (arguments.exposure == "auto" && image::is_writable_extension(pattern) &&
        !image::is_scene_linear_extension(pattern))
      return Error{fmt::format("-o {}: --exposure auto would change from frame to frame; give the "
                               "EV100 that openltc render --time prints",
                               pattern)};
  }
  return Success{};
}

/// Names relative to the scene's folder, so that the folder may move, and the bytes.
void add_inputs(const std::vector<std::string>& paths, const std::string& scene,
                Fingerprint& fingerprint) {
  std::error_code ec;
  const fs::path folder = fs::weakly_canonical(scene, ec).parent_path();
  std::set<std::pair<std::string, std::string>> named; // sorted, each file once
  for (const std::string& path : paths) {
    const fs::path canonical = fs::weakly_canonical(path, ec);
    named.insert({canonical.lexically_relative(folder).string(), canonical.string()});
  }
  for (const auto& [name, path] : named) {
    fingerprint.add(name);
    fingerprint.add_file(path);
  }
}

/// Reads what all frames share, at time 0.
Status read_shared(const RenderArguments& arguments, Sequence& sequence) {
  RenderJob first = sequence.job;
  Result<PreparedScene> prepared = prepare_scene(first, {0.0, arguments.reading.pose.animation});
  if (!prepared) return prepared.error();
  scene::Scene& scene = prepared->scene;
  if (scene.animations.empty())
    return Error{fmt::format("{}: has no animation that can be played, so that all frames would be "
                             "the same; leave out --frames",
                             arguments.scene)};
  sequence.steady = steady_view_of(first, *prepared);
  Result<render::LobeSource> lobes = choose_lobes(first, scene, sequence.own_lobes, scene.warnings);
  if (!lobes) return lobes.error();
  sequence.lobes = *lobes;
  const std::vector<std::string> inputs = input_paths();
  sequence.inputs.add(OPENLTC_VERSION);
  sequence.inputs.add(arguments.picture_options);
  add_inputs(inputs, arguments.scene, sequence.inputs);
  if (!arguments.quiet)
    for (const std::string& warning : scene.warnings)
      say("warning: {}\n", warning);
  return Success{};
}

std::string fingerprint_of(const Sequence& sequence, int frame) {
  Fingerprint fingerprint = sequence.inputs;
  fingerprint.add(fmt::format("{}", seconds_of(sequence.job.arguments, frame)));
  return fingerprint.text();
}

std::vector<int> missing_frames(const Sequence& sequence) {
  std::vector<int> missing;
  for (const int frame : sequence.frames) {
    const std::vector<std::string> files = all_output_files(
        outputs_of(sequence.job.arguments, frame), sequence.job.has_standard_error);
    if (!is_made_of(files, fingerprint_of(sequence, frame))) missing.push_back(frame);
  }
  return missing;
}

Status make_frame(const Sequence& sequence, int frame, const Progress& progress) {
  RenderJob job = sequence.job;
  job.outputs = outputs_of(job.arguments, frame);
  job.files = all_output_files(job.outputs, job.has_standard_error);
  job.options.progress = progress;
  if (Status status = check_outputs(job.outputs, job.has_standard_error); !status) return status;
  const Result<PreparedScene> prepared =
      prepare_scene(job, {seconds_of(job.arguments, frame), job.arguments.reading.pose.animation},
                    &sequence.steady);
  if (!prepared) return prepared.error();
  const Result<render::Picture> picture =
      render_and_write(job, *prepared, *sequence.lobes, nullptr);
  if (!picture) return picture.error();
  return record_made_of(job.files, fingerprint_of(sequence, frame));
}

void put_frames_json(const Sequence& sequence, const std::vector<int>& made,
                     const std::vector<std::pair<int, Error>>& failed) {
  const RenderArguments& arguments = sequence.job.arguments;
  nlohmann::ordered_json failures = nlohmann::ordered_json::array();
  for (const auto& [frame, error] : failed)
    failures.push_back({{"frame", frame}, {"message", error.message}});
  const nlohmann::ordered_json report = {{"scene", arguments.scene},
                                         {"frames", sequence.frames.size()},
                                         {"made", text_of_frames(made)},
                                         {"failed", failures},
                                         {"outputs", arguments.outputs}};
  put("{}\n", report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

/// Makes them one after the other; the exit code.
int make_frames(const Sequence& sequence, const std::vector<int>& missing) {
  const RenderArguments& arguments = sequence.job.arguments;
  std::vector<int> made;
  std::vector<std::pair<int, Error>> failed;
  {
    ProgressBar bar(
        fmt::format("rendering {} frame{}", missing.size(), missing.size() == 1 ? "" : "s"),
        arguments.quiet || missing.empty());
    const double share = 1.0 / double(std::max<std::size_t>(missing.size(), 1));
    for (std::size_t i = 0; i < missing.size(); ++i) {
      const Progress part = part_of(bar.progress(), double(i) * share, double(i + 1) * share);
      if (Status status = make_frame(sequence, missing[i], part); status)
        made.push_back(missing[i]);
      else
        failed.emplace_back(missing[i], status.error());
      part(1);
    }
  }
  if (arguments.json) put_frames_json(sequence, made, failed);
  if (!arguments.quiet)
    say("{} of {} frames made, {} were there\n", made.size(), sequence.frames.size(),
        sequence.frames.size() - missing.size());
  if (failed.empty()) return k_exit_ok;
  std::vector<int> numbers;
  for (const auto& [frame, error] : failed) {
    say("frame {}: {}\n", frame, escaped(error.message));
    numbers.push_back(frame);
  }
  return fail("render", Error{fmt::format("{} of {} frames failed: {}", failed.size(),
                                          sequence.frames.size(), text_of_frames(numbers))});
}

} // namespace

int run_render_frames(const RenderArguments& given) {
  RenderArguments arguments = given;
  if (arguments.outputs.empty())
    arguments.outputs = {fs::path(default_output(arguments.scene)).stem().string() + ".####.exr"};
  const Result<std::vector<int>> frames = parse_frames(arguments.frames);
  if (!frames)
    return fail("render",
                Error{fmt::format("--frames {}: {}", arguments.frames, frames.error().message)},
                k_exit_usage);
  const Result<RenderJob> job = read_arguments(arguments);
  if (!job) return fail("render", job.error(), k_exit_usage);
  for (const Status& status : {check_frame_arguments(arguments), check_lobe_options(*job)})
    if (!status) return fail("render", status.error(), k_exit_usage);
  // The folder and the kind of file; what is in the way of one frame is that frame's error.
  if (Status status = check_outputs(arguments.outputs, job->has_standard_error); !status)
    return fail("render", status.error());

  Sequence sequence{*job, *frames, {}, {}, {}, {}};
  if (Status status = read_shared(arguments, sequence); !status)
    return fail("render", status.error());
  const std::vector<int> missing = missing_frames(sequence);
  if (arguments.list_missing) {
    put("{}\n", text_of_frames(missing));
    return k_exit_ok;
  }
  return make_frames(sequence, missing);
}

std::string picture_options(const CLI::App& command) {
  const std::set<std::string> others = {"scene",     "-o",      "--output",   "--frames",
                                        "--fps",     "--quiet", "--json",     "--list-missing",
                                        "--threads", "--help",  "--scheduler"};
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || others.count(option->get_name()) > 0) continue;
    text += option->get_name() + '\n';
    for (const std::string& value : option->results())
      text += value + '\n';
  }
  return text;
}

} // namespace openltc::cli
