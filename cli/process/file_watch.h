// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The tool watches what the library does with files.

#pragma once

namespace openltc::cli {

/// From now on a signal removes unfinished files (ending.h) and is_input knows what is read. To be
/// called once, at the start.
void watch_files();

} // namespace openltc::cli
