// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/draw/palette.h"

#include <fmt/format.h>
#include <png.h>

namespace openltc::draw {

Result<std::vector<std::uint8_t>> encode_png(const PaletteImage& picture) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = png_uint_32(picture.width);
  header.height = png_uint_32(picture.height);
  header.format = PNG_FORMAT_RGBA_COLORMAP;
  header.colormap_entries = png_uint_32(picture.palette.size());
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::vector<std::uint8_t> bytes(size);
  if (!png_image_write_to_memory(&header, bytes.data(), &size, 0, picture.indices.data(), 0,
                                 picture.palette.data()))
    return Error{fmt::format("cannot encode PNG: {}", header.message)};
  bytes.resize(size);
  return bytes;
}

} // namespace openltc::draw
