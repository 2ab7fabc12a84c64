// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Options that say what files may have and where they may lead; docs/security.md.

#pragma once

#include "openltc/scene/read_options.h"

#include <CLI/CLI.hpp>

namespace openltc::cli {

/// --memory, which sets the limit of memory_budget() when it is given.
void add_memory_option(CLI::App& command);

/// --memory and --allow-outside, for commands that read scenes.
void add_reading_options(CLI::App& command, scene::ReadOptions& options);

} // namespace openltc::cli
