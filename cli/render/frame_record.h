// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What a frame was made of, written down beside it: in the folder .openltc of its own folder, in
// the file NAME.inputs, two lines, the fingerprint of what it was made of and its size in bytes.
// Not in the picture: so a frame is the very file that --time makes, whatever its container, and
// says nothing of the machine to whom it is given.

#pragma once

#include "openltc/base/result.h"

#include <string>
#include <vector>

namespace openltc::cli {

/// Whether all these files are there, made of what has this fingerprint, and as long as they were.
bool is_made_of(const std::vector<std::string>& files, const std::string& fingerprint);

/// Writes that down, when the files are written.
Status record_made_of(const std::vector<std::string>& files, const std::string& fingerprint);

} // namespace openltc::cli
