// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Formulas in figures.

#pragma once

#include <string>
#include <string_view>

namespace openltc::draw {

/// The content of an SVG text element of that size: *...* is slanted, _{...} lowered and smaller,
/// the rest as it is, escaped.
std::string marked_text(std::string_view text, double size);

} // namespace openltc::draw
