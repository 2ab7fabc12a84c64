// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Which files this process has read, so that it writes over none of them.

#pragma once

#include "openltc/base/file_place.h"

#include <string>
#include <vector>

namespace openltc::cli {

/// Remembers that `path` is read, or is named by a file that is read. From any thread.
void remember_input(const std::string& path);

/// Whether a file at this place was read since watch_files() was called.
bool is_input(const FilePlace& place);

/// The paths that were remembered, as they were spelled, in order.
std::vector<std::string> input_paths();

} // namespace openltc::cli
