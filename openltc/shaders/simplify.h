// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The dialect is written for lanes and for every kind of light: what one lane of a shader knows
// beforehand is put in its place, and what follows from it is left out.

#pragma once

#include "openltc/shaders/syntax.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace openltc::shaders {

/// What is known of the shader.
struct Facts {
  std::map<std::string, bool> fields; ///< those of Surface that always have the same value
  std::set<std::string> integers;     ///< constants, and functions that return one
};

/// Names of integers among the constants and functions of a file, for Facts.
void note_integers(const SourceFile& file, Facts& facts);

/// In a function or constant: words of the dialect become plain expressions (select a conditional,
/// Real a conversion or nothing, all_lanes and any_lane their argument), assertions go, and what
/// facts decide is decided: no lane agrees with another, and fields have their values.
void simplify(Item& item, const Facts& facts);

/// Takes out of a function variables that are set and never read. Returns whether there were any.
bool remove_unread_variables(Item& function);

} // namespace openltc::shaders
