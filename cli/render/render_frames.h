// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc render --frames: the pictures of an animation.

#pragma once

#include "cli/render/render_options.h"

#include <CLI/CLI.hpp>

#include <string>

namespace openltc::cli {

/// Renders the frames that are missing. Those that fail are named at the end, the others are done.
/// Returns the exit code.
int run_render_frames(const RenderArguments& arguments);

/// Every option of the command line with what it was given, but for those that change no picture:
/// which frames, where to, how it runs and what it says.
std::string picture_options(const CLI::App& command);

} // namespace openltc::cli
