// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The options by which every command that shows a scene chooses its moment.

#pragma once

#include "openltc/scene/pose.h"

#include <CLI/CLI.hpp>

namespace openltc::cli {

/// Adds --time and --animation. `options` must live as long as `command`.
void add_pose_options(CLI::App& command, scene::PoseOptions& options);

} // namespace openltc::cli
