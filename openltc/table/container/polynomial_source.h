// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A lobe polynomial as a function in a programming language, to paste into a shader or a program.

#pragma once

#include "openltc/table/container/source_language.h"
#include "openltc/table/lobe_polynomial.h"

#include <string>

namespace openltc::table {

/// Self-contained text that defines openltc_BRDF_lobe(roughness, cos_theta), BRDF being the
/// metadata's name of it. What the function returns is said in the text: the entries of M^-1, its
/// determinant, the share of the lobe above the horizon, n1 and n5; of two lobes the function is
/// openltc_BRDF_two_lobes, and the second has all but amplitudes, and a weight. Arguments out of
/// range are clamped. GLSL 1.10 and later, ES 1.00 and later; HLSL of shader model 2 and later.
std::string to_source(const LobePolynomial& polynomial, SourceLanguage language);

} // namespace openltc::table
