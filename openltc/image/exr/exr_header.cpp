// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Source: The OpenEXR project, "OpenEXR File Layout", sections Header, Attribute Layout and
// Predefined Attribute Types.
//
//   file      magic, version (4 bytes each), header {header, empty when there are many parts}
//   header    attribute {attribute} 0
//   attribute name 0, type 0, size (4 bytes), value
//
// The library reads a value by its type and goes on where that ends, not where `size` says. Both
// must agree, or the two readings of a header would part.

#include "openltc/image/exr/exr_header.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>

namespace openltc::image {

namespace {

struct FixedSize {
  const char* type;
  std::size_t size;
};
constexpr FixedSize k_fixed_sizes[] = {
    {"box2f", 16},      {"box2i", 16},   {"chromaticities", 32},
    {"compression", 1}, {"double", 8},   {"envmap", 1},
    {"float", 4},       {"int", 4},      {"keycode", 28},
    {"lineOrder", 1},   {"m33d", 72},    {"m33f", 36},
    {"m44d", 128},      {"m44f", 64},    {"rational", 8},
    {"tiledesc", 9},    {"timecode", 8}, {"v2d", 16},
    {"v2f", 8},         {"v2i", 8},      {"v3d", 24},
    {"v3f", 12},        {"v3i", 12},     {"deepImageState", 1},
};

// Bytes that are not believed; `at` stays within them.
struct Walk {
  std::span<const std::uint8_t> bytes;
  std::size_t at = 0;

  std::size_t left() const { return bytes.size() - at; }
  bool skip(std::size_t count) {
    if (count > left()) return false;
    at += count;
    return true;
  }
  std::optional<std::uint32_t> number() {
    if (left() < 4) return {};
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;)
      value = value << 8 | bytes[at + i];
    at += 4;
    return value;
  }
  std::optional<std::string> text() {
    const auto begin = bytes.begin() + std::ptrdiff_t(at);
    const auto end = std::find(begin, bytes.end(), std::uint8_t(0));
    if (end == bytes.end()) return {};
    at += std::size_t(end - begin) + 1;
    return std::string(begin, end);
  }
};

// Channels: name 0, sixteen bytes; an empty name ends the list.
bool is_channel_list(Walk value) {
  while (const std::optional<std::string> name = value.text()) {
    if (name->empty()) return value.left() == 0;
    if (!value.skip(16)) return false;
  }
  return false;
}

bool is_string_vector(Walk value) {
  while (value.left() > 0) {
    const std::optional<std::uint32_t> size = value.number();
    if (!size || !value.skip(*size)) return false;
  }
  return true;
}

// Width, height, four bytes a pixel.
bool is_preview(Walk value) {
  const std::optional<std::uint32_t> width = value.number(), height = value.number();
  if (!width || !height || *width > value.left() || *height > value.left()) return false;
  return std::uint64_t(*width) * *height * 4 == value.left();
}

bool value_fits(const std::string& type, std::span<const std::uint8_t> value) {
  for (const FixedSize& fixed : k_fixed_sizes)
    if (type == fixed.type) return value.size() == fixed.size;
  if (type == "chlist") return is_channel_list({value});
  if (type == "stringvector") return is_string_vector({value});
  if (type == "preview") return is_preview({value});
  if (type == "floatvector") return value.size() % 4 == 0;
  return true; // a string, or unknown: as many bytes as it says
}

// What a header says of the number of its chunks, blocks of lines or tiles.
class ChunkCount {
public:
  void look_at(const std::string& name, Walk value) {
    if (name == "dataWindow" && value.left() == 16) {
      std::int64_t corners[4];
      for (std::int64_t& corner : corners)
        corner = std::int32_t(*value.number());
      width_ = corners[2] - corners[0] + 1;
      height_ = corners[3] - corners[1] + 1;
    } else if (name == "compression" && value.left() == 1) {
      compression_ = value.bytes[0];
    } else if (name == "tiles" && value.left() == 9) {
      tile_width_ = *value.number();
      tile_height_ = *value.number();
    } else if (name == "chunkCount" && value.left() == 4) {
      stated_ = *value.number();
    }
  }

  /// At least so many, for tiles of several levels more. 0 when the library will refuse the header.
  std::uint64_t least(bool tiled) const {
    if (width_ <= 0 || height_ <= 0) return stated_;
    const auto blocks = [](std::int64_t length, std::int64_t block) {
      return block > 0 ? std::uint64_t((length + block - 1) / block) : 0;
    };
    // None, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA, DWAB.
    static constexpr std::int64_t lines[] = {1, 1, 1, 16, 32, 16, 32, 32, 32, 256};
    const std::int64_t block = compression_ < std::size(lines) ? lines[compression_] : 256;
    const std::uint64_t counted = tiled
                                      ? blocks(width_, tile_width_) * blocks(height_, tile_height_)
                                      : blocks(height_, block);
    return std::max(counted, stated_);
  }

private:
  std::int64_t width_ = 0, height_ = 0, tile_width_ = 0, tile_height_ = 0;
  std::size_t compression_ = 0;
  std::uint64_t stated_ = 0;
};

constexpr int k_max_parts = 4096; // each costs the library some kilobytes

} // namespace

bool exr_header_fits(std::span<const std::uint8_t> bytes, std::uint64_t file_bytes) {
  if (bytes.size() < 8) return false;
  const bool many_parts = (bytes[5] & 0x10) != 0;   // bit 12 of the version
  const bool single_tiled = (bytes[5] & 0x02) != 0; // bit 9
  Walk walk{bytes, 8};
  std::uint64_t chunks = 0;
  for (int part = 0; part == 0 || many_parts; ++part) {
    if (part > k_max_parts) return false;
    bool tiled = single_tiled;
    ChunkCount count;
    for (int attributes = 0;; ++attributes) {
      const std::optional<std::string> name = walk.text();
      if (!name) return false;
      if (name->empty() && attributes == 0) return part > 0; // the empty header behind many parts
      if (name->empty()) break;
      const std::optional<std::string> type = walk.text();
      const std::optional<std::uint32_t> size = walk.number();
      if (!type || !size) return false;
      const std::size_t begin = walk.at;
      if (!walk.skip(*size)) return false;
      const std::span<const std::uint8_t> value = bytes.subspan(begin, *size);
      if (!value_fits(*type, value)) return false;
      count.look_at(*name, {value});
      if (*name == "type" && *type == "string")
        tiled = std::string(value.begin(), value.end()).find("tile") != std::string::npos;
    }
    // Of each chunk the file has the place, in eight bytes.
    chunks += std::min<std::uint64_t>(count.least(tiled), file_bytes);
    if (chunks > file_bytes / 8) return false;
  }
  return true;
}

} // namespace openltc::image
