// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Only what is called is in a shader: functions, and the constants, structs and fields that they
// read.

#pragma once

#include "openltc/shaders/syntax.h"

#include <set>
#include <string>
#include <vector>

namespace openltc::shaders {

/// What a caller of the shader uses.
struct Roots {
  std::set<std::string> functions;
  std::set<std::string> structs; ///< whose fields all stay
};

/// Takes out all that no root reaches: items, fields that nothing reads, and variables that only
/// set those. A field counts as read where any field of its name is.
void keep_reached(std::vector<SourceFile>& files, const Roots& roots);

} // namespace openltc::shaders
