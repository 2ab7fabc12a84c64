// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Programming languages in which tables and polynomials are written.

#pragma once

namespace openltc::table {

enum class SourceLanguage {
  c, ///< a header for C99 and C++
  glsl,
  hlsl,
  wgsl,
  javascript, ///< an ES module
};

} // namespace openltc::table
