// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A fit as a command line, and the text below its help.

#pragma once

#include "openltc/fit/fit_job.h"
#include "openltc/table/engine.h"

#include <string>

namespace openltc::cli {

/// Below the options in `openltc fit --help`.
extern const char* const k_fit_footer;

/// A path as one word of a shell's command line, in quotes where it needs them.
std::string shell_word(const std::string& path);

/// The command line that makes the same again: all choices that are not defaults. `brdf` is a name
/// or the path of a MERL file, `engine` the one whose files were asked for or nullptr.
std::string fit_command_of(const std::string& brdf, const fit::FitRequest& request,
                           const table::Engine* engine = nullptr);

} // namespace openltc::cli
