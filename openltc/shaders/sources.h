// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The shading source as text: it is a part of the program.

#pragma once

#include <vector>

namespace openltc::shaders {

/// A file of the repository.
struct EmbeddedFile {
  const char* path; ///< from the repository's root
  const char* text;
};

/// openltc/shade/*.glsl and its rooms, openltc/shaders/dialect/*.glsl and
/// openltc/target/shade_all.inc.
const std::vector<EmbeddedFile>& embedded_files();

} // namespace openltc::shaders
