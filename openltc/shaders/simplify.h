// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The dialect is written for lanes and for every kind of light: what one lane of a shader knows
// beforehand is put in its place, and what follows from it is left out.

#pragma once

#include "openltc/shaders/syntax.h"

#include <set>
#include <string>
#include <vector>

namespace openltc::shaders {

/// What is known of the shader.
struct Facts {
  bool second_lobe = false;       ///< the value of Surface.two
  std::set<std::string> integers; ///< constants, and functions that return one
};

/// Names of integers among the constants and functions of a file, for Facts.
void note_integers(const SourceFile& file, Facts& facts);

/// In a function or constant: words of the dialect become plain expressions (select a conditional,
/// Real a conversion or nothing, all_lanes and any_lane their argument), assertions go, and what
/// facts decide is decided: no lane agrees with another, Surface.exact is false, Surface.two is
/// `second_lobe`.
void simplify(Item& item, const Facts& facts);

/// Takes out of a function variables that are set and never read.
void remove_unread_variables(Item& function);

} // namespace openltc::shaders
