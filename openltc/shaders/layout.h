// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Text with places where its lines may be broken.

#pragma once

#include <string>
#include <vector>

namespace openltc::shaders {

/// A piece of code. Pieces that belong together closely are nested deeply: lines break as far out
/// as they can.
struct Piece {
  std::string text;              ///< where there are no parts
  std::vector<Piece> parts = {}; ///< set one after the other, a break being allowed before each but
                                 ///< the first; what follows a break begins below the first part
};

/// A piece of text that is not broken.
Piece piece(std::string text);

/// Pieces between which no line is broken, one after the other.
Piece joined(std::vector<Piece> parts);

/// Pieces between which lines may be broken; each ends with what stands before the break, less the
/// blank, which `broken` sets where there is none.
Piece broken(std::vector<Piece> parts);

/// The lines of `piece`, the first at column `indent`, none longer than `width` where that can be.
std::string lay_out(const Piece& piece, int indent, int width);

} // namespace openltc::shaders
