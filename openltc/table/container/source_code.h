// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A packed table as source text, for programs and shaders that carry it in themselves.

#pragma once

#include "openltc/table/container/source_language.h"
#include "openltc/table/layout.h"

#include <string>

namespace openltc::table {

/// Source that defines the textures as NAME_1 (and NAME_2), row by row, with the description as
/// comments. `name` may be any text; what identifiers cannot hold becomes an underscore.
///   c: C99 and C++; static const float arrays and the sizes as enumerators; guarded.
///   glsl: const vec4 (vec2) arrays of columns * rows; GLSL 3.30, ES 3.00 and later.
///   hlsl: static const float4 (float2) arrays.
///   wgsl: const arrays of rows, each an array of columns (one constructor takes at most 2047).
///   javascript: an ES module; Float32Arrays, and the description as NAME_info.
std::string to_source(const PackedTable& packed, SourceLanguage language, const std::string& name);

} // namespace openltc::table
