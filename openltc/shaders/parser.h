// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The dialect's files as trees.

#pragma once

#include "openltc/base/result.h"
#include "openltc/shaders/syntax.h"

#include <string>

namespace openltc::shaders {

/// Reads a file of the dialect. `name` is that of the file, for SourceFile and for errors, which
/// say where it stops and what was expected there. Brackets that only the order of evaluation needs
/// are not kept: writers set them.
Result<SourceFile> parse_file(const std::string& source, const std::string& name);

} // namespace openltc::shaders
