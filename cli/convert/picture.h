// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// openltc convert of pictures: from one file format to another.

#pragma once

#include "openltc/base/result.h"
#include "openltc/image/file.h"
#include "openltc/image/tonemap.h"

#include <optional>
#include <string>

namespace openltc::cli {

struct PictureConversion {
  std::string layer; ///< of an .exr; "": that of the name, else the picture itself
  std::optional<std::string> exposure;   ///< EV100 or "auto" (default), from linear to .png
  std::optional<image::Tonemap> tonemap; ///< the same; default neutral
  image::ExrPrecision precision = image::ExrPrecision::full_float;
};

/// "auto" or a number from -60 to 60; else what is wrong.
std::string check_exposure(const std::string& text);

/// Whether `input`, FILE or FILE:LAYER, is to be read as a picture: by its extension and, for an
/// .exr, by what it becomes and whether it says that it is a lobe table.
bool is_picture_file(const std::string& input, const std::string& output);

/// Writes `input` as .exr, .hdr or .png. Scene-linear pictures are exposed and tone-mapped for a
/// .png; displayed ones become linear light for .exr and .hdr. Alpha is premultiplied in .exr,
/// straight in .png; .hdr has none and gets the picture over black.
Status convert_picture(const std::string& input, const std::string& output,
                       const PictureConversion& options, bool quiet);

} // namespace openltc::cli
