// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The options by which every command that reads a scene recognises round lights in its meshes.

#pragma once

#include "openltc/scene/emissive/emissive.h"

#include <CLI/CLI.hpp>

namespace openltc::cli {

/// Adds --recognise-shapes and --shape-tolerance. `options` must live as long as `command`.
void add_shape_options(CLI::App& command, scene::EmissiveOptions& options);

} // namespace openltc::cli
