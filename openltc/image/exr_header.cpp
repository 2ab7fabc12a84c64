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

#include "openltc/image/exr_header.h"

#include <algorithm>
#include <cstdint>
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

} // namespace

bool exr_attributes_fit(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 8) return false;
  const bool many_parts = (bytes[5] & 0x10) != 0; // bit 12 of the version
  Walk walk{bytes, 8};
  for (bool first = true; first || many_parts; first = false) {
    for (int attributes = 0;; ++attributes) {
      const std::optional<std::string> name = walk.text();
      if (!name) return false;
      if (name->empty() && attributes == 0) return !first; // the empty header behind many parts
      if (name->empty()) break;
      const std::optional<std::string> type = walk.text();
      const std::optional<std::uint32_t> size = walk.number();
      if (!type || !size) return false;
      const std::size_t begin = walk.at;
      if (!walk.skip(*size) || !value_fits(*type, bytes.subspan(begin, *size))) return false;
    }
  }
  return true;
}

} // namespace openltc::image
