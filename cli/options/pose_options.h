// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The options by which every command that shows a scene chooses its moment, and its camera.

#pragma once

#include "openltc/base/result.h"
#include "openltc/scene/pose.h"

#include <CLI/CLI.hpp>

#include <string>

namespace openltc::cli {

/// Adds --time and --animation. `options` must live as long as `command`.
void add_pose_options(CLI::App& command, scene::PoseOptions& options);

/// What to say when render::choose_camera fails for --camera `camera` of the scene in `file`.
Error wrong_camera(const std::string& file, const std::string& camera, const Error& error);

} // namespace openltc::cli
