// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// From the arguments of openltc render to a picture: what one picture and each frame of a sequence
// go through.

#pragma once

#include "cli/render/render_options.h"
#include "openltc/base/memory_budget.h"
#include "openltc/base/result.h"
#include "openltc/image/display.h"
#include "openltc/render/renderer.h"
#include "openltc/render/view/studio_choice.h"
#include "openltc/scene/scene.h"
#include "openltc/table/shading_lobes.h"

#include <optional>
#include <string>
#include <vector>

namespace openltc::cli {

/// What the arguments ask for, read; the scene may still change size, background and exposure.
struct RenderJob {
  const RenderArguments& arguments;
  render::RenderOptions options;
  image::DisplayOptions display;
  bool reference = false, has_standard_error = false;
  std::vector<std::string> outputs; ///< paths as they were given
  std::vector<std::string> files;   ///< that will be written
};

/// The error names the option: it is wrong usage.
Result<RenderJob> read_arguments(const RenderArguments& arguments);

/// The reference has no lobes: to ask it for some is wrong usage.
Status check_lobe_options(const RenderJob& job);

/// What stays the same while a scene moves, in coordinates about `origin` (scene::Scene).
struct SteadyView {
  Vec3d origin{0, 0, 0};
  std::optional<scene::Camera> framed; ///< none: a camera of the file, which may move
  render::LightsChosen lights;
};

/// A scene as it is rendered: with its camera, the lights that were chosen, and the lobes.
struct PreparedScene {
  scene::Scene scene;
  scene::Camera camera;
  render::LightsChosen lights;
  double load_seconds = 0;
  MemoryShare picture_memory;
};

/// Loads the scene at that moment and fits the job to it. With `steady` the view that was framed,
/// and the studio rig, are those of another moment.
Result<PreparedScene> prepare_scene(RenderJob& job, const scene::PoseOptions& pose,
                                    const SteadyView* steady = nullptr);

/// What of a scene at one moment the others are to share.
SteadyView steady_view_of(const RenderJob& job, const PreparedScene& prepared);

/// The lobes to shade with; those of a file are kept in `own`, and what there is to say of them is
/// added to `warnings`. The materials of the reference are defined with the table of one lobe.
Result<render::LobeSource> choose_lobes(const RenderJob& job, const scene::Scene& scene,
                                        table::ShadingLobes& own,
                                        std::vector<std::string>& warnings);

/// Renders, exposes and writes all files or none. The exposure, a factor from nits, is stored where
/// it is wanted.
Result<render::Picture> render_and_write(const RenderJob& job, const PreparedScene& prepared,
                                         const render::LobeSource& lobes, float* exposure);

} // namespace openltc::cli
