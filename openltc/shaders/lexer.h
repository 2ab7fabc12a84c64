// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The dialect as a list of tokens, each with the comments that stand before it.

#pragma once

#include "openltc/base/result.h"
#include "openltc/shaders/syntax.h"

#include <string>
#include <vector>

namespace openltc::shaders {

/// A word, number or sign.
struct Token {
  std::string text; ///< empty at the end of the file
  int line = 0;
  Comments comments = {}; ///< on lines of their own before it
  std::string note = {};  ///< on the line of the token before it
};

/// The tokens of `source`, and one of no text at the end. The error names `file` and the line.
Result<std::vector<Token>> read_tokens(const std::string& source, const std::string& file);

} // namespace openltc::shaders
