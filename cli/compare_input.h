// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The two pictures of openltc compare, and whether they can be compared at all.

#pragma once

#include "openltc/base/result.h"
#include "openltc/image/file.h"

#include <string>

namespace openltc::cli {

/// A picture as the user named it, read.
struct ComparedPicture {
  std::string name; ///< FILE, or FILE:LAYER of the layer that was chosen
  std::string path;
  image::Picture picture; ///< grey pictures in three channels
};

/// Reads FILE or FILE:LAYER; `layer` where the name has none.
Result<ComparedPicture> read_compared(const std::string& name, const std::string& layer);

/// An error when the two are not pictures of the same pixels: other sizes, windows that begin
/// elsewhere or pixels of another shape, colours beside numbers that are none, one channel beside
/// three. Pictures of which only a part is known have black elsewhere; where these parts differ, a
/// warning goes to stderr.
Status check_comparable(const ComparedPicture& a, const ComparedPicture& b);

/// The same for sizes alone, of a mask.
Status check_same_size(const std::string& name_a, const image::Image& a, const std::string& name_b,
                       const image::Image& b);

} // namespace openltc::cli
