// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// OpenEXR as its file layout says (openexr.com, "OpenEXR File Layout", 2013): one part of scan
// lines, not compressed, since a table is small and its numbers hardly compress. So it is written
// where the OpenEXR library is not, too; that library reads it (table_exr.cpp).

#include "openltc/table/container/container.h"

#include <algorithm>
#include <bit>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace openltc::table {

namespace {

constexpr std::uint32_t k_magic = 20000630;
constexpr std::uint32_t k_version = 2;
constexpr std::uint32_t k_long_names = 0x400; // of more than 31 bytes
constexpr std::size_t k_short_name = 31;
constexpr std::uint32_t k_half = 1, k_float = 2;

void append_name(Bytes& out, std::string_view name) {
  out.insert(out.end(), name.begin(), name.end());
  out.push_back(0);
}

void append_attribute(Bytes& out, std::string_view name, std::string_view type,
                      const Bytes& value) {
  append_name(out, name);
  append_name(out, type);
  append_u32(out, std::uint32_t(value.size()));
  out.insert(out.end(), value.begin(), value.end());
}

Bytes words(std::initializer_list<std::uint32_t> values) {
  Bytes out;
  for (const std::uint32_t value : values)
    append_u32(out, value);
  return out;
}

// Names of the channels and where each lies in a texel; a file has them in alphabetical order.
std::vector<std::pair<char, int>> channels_of(const Texture& texture) {
  std::vector<std::pair<char, int>> channels;
  for (int c = 0; c < texture.channels; ++c)
    channels.emplace_back("RGBA"[c], c);
  std::sort(channels.begin(), channels.end());
  return channels;
}

} // namespace

Bytes encode_exr(const Texture& texture) {
  const auto channels = channels_of(texture);
  const bool full = texture.precision == Precision::float32;
  Bytes list;
  for (const auto& [name, at] : channels) {
    append_name(list, {&name, 1});
    for (const std::uint32_t word : {full ? k_float : k_half, 0u, 1u, 1u}) // linear, every pixel
      append_u32(list, word);
  }
  list.push_back(0);
  const std::uint32_t right = std::uint32_t(texture.width - 1);
  const std::uint32_t bottom = std::uint32_t(texture.height - 1);
  const std::uint32_t one = std::bit_cast<std::uint32_t>(1.0f);

  Bytes header;
  bool long_names = false;
  append_attribute(header, "channels", "chlist", list);
  append_attribute(header, "compression", "compression", {0});
  append_attribute(header, "dataWindow", "box2i", words({0, 0, right, bottom}));
  append_attribute(header, "displayWindow", "box2i", words({0, 0, right, bottom}));
  append_attribute(header, "lineOrder", "lineOrder", {0});
  for (const auto& [key, value] : texture.metadata) {
    const std::string name = "openltc." + key;
    long_names = long_names || name.size() > k_short_name;
    append_attribute(header, name, "string", Bytes(value.begin(), value.end()));
  }
  append_attribute(header, "pixelAspectRatio", "float", words({one}));
  append_attribute(header, "screenWindowCenter", "v2f", words({0, 0}));
  append_attribute(header, "screenWindowWidth", "float", words({one}));
  header.push_back(0);

  Bytes out = words({k_magic, k_version | (long_names ? k_long_names : 0)});
  out.insert(out.end(), header.begin(), header.end());
  const std::size_t size = bytes_of(texture.precision), texel = size * channels.size();
  const std::size_t line = texel * std::size_t(texture.width);
  const std::size_t begin = out.size() + 8 * std::size_t(texture.height);
  for (std::size_t y = 0; y < std::size_t(texture.height); ++y)
    append_u64(out, begin + y * (8 + line));
  Bytes texels;
  append_values(texels, texture);
  for (std::size_t y = 0; y < std::size_t(texture.height); ++y) {
    append_u32(out, std::uint32_t(y));
    append_u32(out, std::uint32_t(line));
    for (const auto& [name, at] : channels)
      for (std::size_t x = 0; x < std::size_t(texture.width); ++x) {
        const auto from = texels.begin() + std::ptrdiff_t(y * line + x * texel) +
                          std::ptrdiff_t(std::size_t(at) * size);
        out.insert(out.end(), from, from + std::ptrdiff_t(size));
      }
  }
  return out;
}

} // namespace openltc::table
