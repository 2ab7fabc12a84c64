// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Frames as a user writes them, and the names of their files.

#pragma once

#include "openltc/base/result.h"

#include <string>
#include <vector>

namespace openltc::cli {

/// Frames that one command takes, at most, and the largest number of a frame.
inline constexpr int k_most_frames = 1000000, k_last_frame = 99999999;

/// "7", "1-240", "1-240x10" (every tenth: 1, 11, ...), and several of them with commas. Ascending,
/// each once. The error says what is wrong with `text`, which it does not repeat.
Result<std::vector<int>> parse_frames(const std::string& text);

/// Ascending frames in that form, "1-3,7"; empty for none.
std::string text_of_frames(const std::vector<int>& frames);

/// `pattern` with the number in place of its last ####: as many digits, or more where it has more.
/// There must be one.
std::string path_of_frame(const std::string& pattern, int frame);

/// Whether there is a # in the name of the file.
bool has_frame_number(const std::string& pattern);

} // namespace openltc::cli
