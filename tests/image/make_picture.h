// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Pictures and picture files for the tests.

#pragma once

#include "openltc/image/image.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace openltc::image::test {

/// A folder of its own for each object, removed with it.
class TemporaryFolder {
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  /// Number of files in it, hidden ones too.
  int file_count() const;

private:
  std::filesystem::path path_;
};

/// Values in [low, high), the same for the same seed on every machine.
Image random_image(int width, int height, int channels, std::uint32_t seed, float low = 0.0f,
                   float high = 1.0f);

std::vector<std::uint8_t> file_bytes(const std::string& path);
void write_bytes(const std::string& path, const std::vector<std::uint8_t>& bytes);

/// A PNG file by libpng of `color_type` (PNG_COLOR_TYPE_...), samples most significant byte first.
/// Palette files get the palette entry (3 i, 2 i, i) for index i, index 0 transparent.
std::vector<std::uint8_t> make_png(int width, int height, int color_type, int bit_depth,
                                   std::vector<std::uint8_t> rows, bool interlaced = false);

/// A baseline JPEG file by stb_image_write, at quality 95.
std::vector<std::uint8_t> make_jpeg(int width, int height, int channels,
                                    const std::vector<std::uint8_t>& samples);

} // namespace openltc::image::test
