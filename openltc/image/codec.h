// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The picture formats one by one. Private to this folder; everyone else includes file.h.

#pragma once

#include "openltc/image/file.h"

#include <array>
#include <memory>

namespace openltc::image::codec {

/// Integer samples as PNG, JPEG and WebP hold them, before any transfer function: interleaved rows,
/// top row first, `channels` 1 grey, 2 grey and alpha, 3 RGB, 4 RGB and alpha. Exactly one of the
/// two is used.
struct Samples {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::shared_ptr<const std::uint8_t> bits8; ///< may be memory of a decoder, which is not copied
  std::vector<std::uint16_t> bits16;

  std::size_t count() const {
    return std::size_t(width) * std::size_t(height) * std::size_t(channels);
  }
};

/// `count` zeros; nothing when there is no memory.
std::shared_ptr<std::uint8_t> new_bytes(std::size_t count);

bool is_png(std::span<const std::uint8_t> bytes);
bool is_jpeg(std::span<const std::uint8_t> bytes);
bool is_webp(std::span<const std::uint8_t> bytes);
/// Whether this build can decode WebP.
bool has_webp();

/// Each takes the whole file's bytes; errors begin with `name`.
Result<Samples> decode_png(std::span<const std::uint8_t> bytes, const std::string& name);
Result<Samples> decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& name);
Result<Samples> decode_webp(std::span<const std::uint8_t> bytes, const std::string& name);
Result<Image> decode_radiance(std::span<const std::uint8_t> bytes, const std::string& name);

/// An OpenEXR file, or its bytes: the layer that choose_layer finds, and all layers.
Result<Picture> read_exr(const std::string& path, const std::string& layer);
Result<Picture> decode_exr(std::span<const std::uint8_t> bytes, const std::string& layer,
                           const std::string& name);
Result<std::vector<LayerInfo>> exr_layers(std::span<const std::uint8_t> bytes,
                                          const std::string& name);

/// linear_from_srgb(i / 255), i = 0..255.
const std::array<float, 256>& linear_from_srgb8();

/// An error when a picture of this size is empty or beyond the limits of file.h.
Status check_size(const std::string& name, std::int64_t width, std::int64_t height);

/// check_size, and an error when its samples, `bytes_per_pixel` each, are more than the memory that
/// files may ask for (base/memory_budget.h).
Status check_readable(const std::string& name, std::int64_t width, std::int64_t height,
                      std::size_t bytes_per_pixel);

/// check_size, and `channels` is 1, 3 or 4 and matches the amount of data.
Status check_writable(const std::string& path, const Image& image);

} // namespace openltc::image::codec
