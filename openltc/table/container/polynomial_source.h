// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A lobe polynomial as a function in a programming language, to paste into a shader or a program.

#pragma once

#include "openltc/table/lobe_polynomial.h"

#include <string>

namespace openltc::table {

enum class SourceLanguage {
  c,    ///< a header for C99 and C++
  glsl, ///< GLSL 1.10 and later, ES 1.00 and later
  hlsl, ///< shader model 2 and later
  wgsl,
  javascript, ///< an ES module
};

/// Self-contained text that defines openltc_BRDF_lobe(roughness, cos_theta), BRDF being the
/// metadata's name of it. What the function returns is said in the text: the entries of M^-1, its
/// determinant, the share of the lobe above the horizon, n1 and n5. Arguments out of range are
/// clamped.
std::string to_source(const LobePolynomial& polynomial, SourceLanguage language);

} // namespace openltc::table
