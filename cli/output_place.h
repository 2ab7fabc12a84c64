// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Finding out before the work, not after it, that its result cannot be written.

#pragma once

#include "openltc/base/result.h"

#include <string>

namespace openltc::cli {

/// Whether a file can be made at `path`: no directory of that name, and a folder in which a file
/// can be created, which is tried. The error names `path`.
Status check_place(const std::string& path);

} // namespace openltc::cli
