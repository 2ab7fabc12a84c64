// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Finding out before the work, not after it, that its result cannot be written, or would be written
// over what it is made from.

#pragma once

#include "openltc/base/result.h"

#include <string>
#include <vector>

namespace openltc::cli {

/// Whether a file can be written to `path`: nothing lies there that cannot be replaced, and a
/// folder in which a file can be created, which is tried. The error names `path`.
Status check_place(const std::string& path);

/// check_place for all files that a command writes, and whether they are different files, in
/// whatever way they are spelled or linked, none of them one that was read up to now (as
/// check_not_read), nor the one that standard output or standard error goes to. The error names the
/// file.
Status check_places(const std::vector<std::string>& files);

/// Whether none of these files was read by this command or is named by a scene that was read. To be
/// called when everything was read, before the work.
Status check_not_read(const std::vector<std::string>& files);

} // namespace openltc::cli
