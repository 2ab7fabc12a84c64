// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The built-in polynomials as constants of a shader file.

#pragma once

#include "openltc/shaders/syntax.h"

namespace openltc::shaders {

/// The polynomials of one lobe or of two: k_polynomial_degree, and an array for each kind of
/// coefficient, in the order of terms of shade/polynomial.glsl.
SourceFile lobe_constants(bool two);

} // namespace openltc::shaders
