// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Where rendered pictures go: by the extension of the path.

#pragma once

#include "openltc/base/memory_budget.h"
#include "openltc/base/result.h"

#include <string>
#include <vector>

namespace openltc::cli {

/// "SCENE.png" in the current folder.
std::string default_output(const std::string& scene);

/// The files that writing a picture to each of these paths makes; see image::picture_files.
std::vector<std::string> all_output_files(const std::vector<std::string>& paths,
                                          bool with_standard_error);

/// Counts what a picture of this size takes until it is written, or says that there is no room.
Status take_picture_memory(MemoryShare& memory, int width, int height, bool with_standard_error);

/// Whether pictures can be written to these paths: known extensions, and check_places.
Status check_outputs(const std::vector<std::string>& paths, bool with_standard_error);

/// Whether an exposure has a factor that is a number; to be asked before the work.
Status check_ev100(float ev100);

} // namespace openltc::cli
