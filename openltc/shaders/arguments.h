// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Arguments that are the same in all calls are no arguments.

#pragma once

#include "openltc/shaders/simplify.h"
#include "openltc/shaders/syntax.h"

#include <vector>

namespace openltc::shaders {

/// Takes parameters out of functions that get the same `true` or `false` in every call, and decides
/// what hangs on them. Returns whether there were any.
bool settle_arguments(std::vector<SourceFile>& files, const Facts& facts);

} // namespace openltc::shaders
