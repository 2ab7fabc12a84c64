// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/image/png_bytes.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>

namespace openltc::image {

namespace {

Result<std::vector<std::uint8_t>> write(png_image& header, const void* pixels,
                                        const void* palette) {
  header.version = PNG_IMAGE_VERSION;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::vector<std::uint8_t> bytes(size);
  if (!png_image_write_to_memory(&header, bytes.data(), &size, 0, pixels, 0, palette))
    return Error{fmt::format("cannot encode PNG: {}", header.message)};
  bytes.resize(size);
  return bytes;
}

} // namespace

Result<std::vector<std::uint8_t>> png_bytes(const Image& display) {
  if (display.channels != 4) return Error{"cannot encode PNG: the picture needs 4 channels"};
  std::vector<std::uint8_t> pixels(display.data.size());
  std::transform(display.data.begin(), display.data.end(), pixels.begin(), [](float v) {
    return v > 0.0f ? std::uint8_t(std::lround(std::min(v, 1.0f) * 255.0f)) : std::uint8_t(0);
  });
  png_image header{};
  header.width = png_uint_32(display.width);
  header.height = png_uint_32(display.height);
  header.format = PNG_FORMAT_RGBA;
  return write(header, pixels.data(), nullptr);
}

Result<std::vector<std::uint8_t>> png_bytes(const PaletteImage& picture) {
  png_image header{};
  header.width = png_uint_32(picture.width);
  header.height = png_uint_32(picture.height);
  header.format = PNG_FORMAT_RGBA_COLORMAP;
  header.colormap_entries = png_uint_32(picture.palette.size());
  return write(header, picture.indices.data(), picture.palette.data());
}

} // namespace openltc::image
