// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Arguments that are the same in all calls, or that nobody reads, are no arguments.

#pragma once

#include "openltc/shaders/simplify.h"
#include "openltc/shaders/syntax.h"

#include <set>
#include <string>
#include <vector>

namespace openltc::shaders {

/// Takes parameters out of functions that get the same `true` or `false` in every call, and decides
/// what hangs on them; and values that functions do not read, but for the functions of `kept`.
/// Returns whether there were any.
bool settle_arguments(std::vector<SourceFile>& files, const Facts& facts,
                      const std::set<std::string>& kept);

} // namespace openltc::shaders
