// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The fitted lobes that are built in as constants of a shader.

#pragma once

#include "openltc/base/result.h"
#include "openltc/shaders/syntax.h"

#include <vector>

namespace openltc::shaders {

/// Writes the coefficients of the built-in polynomials of one lobe, or of two, into the functions
/// that sum them (shade/polynomial.glsl), a line for each term: compilers keep an array that a loop
/// walks through in memory, and some make it anew at each call.
Status set_lobe_constants(std::vector<SourceFile>& files, bool two);

} // namespace openltc::shaders
