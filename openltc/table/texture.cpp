// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/table/texture.h"

#include "openltc/table/half.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>

namespace openltc::table {

const std::string* find_value(const KeyValues& values, const std::string& key) {
  for (const auto& [name, value] : values)
    if (name == key) return &value;
  return nullptr;
}

Status check_texture_size(const std::string& name, std::uint64_t width, std::uint64_t height,
                          std::uint64_t channels) {
  const std::uint64_t limit = Texture::k_max_side;
  if (width < 1 || height < 1 || width > limit || height > limit)
    return Error{fmt::format("{}: {} x {} texels are no table; each side must be 1 to {}", name,
                             width, height, limit)};
  if (channels < 1 || channels > 4)
    return Error{fmt::format("{}: {} channels are no table; it has 1 to 4", name, channels)};
  return Success{};
}

Status check_finite(const std::string& name, const Texture& texture) {
  for (std::size_t i = 0; i < texture.values.size(); ++i) {
    if (std::isfinite(texture.values[i])) continue;
    const std::size_t texel = i / std::size_t(texture.channels);
    return Error{fmt::format("{}: texel ({}, {}), channel {}, is {}, not a finite number", name,
                             texel % std::size_t(texture.width), texel / std::size_t(texture.width),
                             i % std::size_t(texture.channels), texture.values[i])};
  }
  return Success{};
}

void append_u32(Bytes& out, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8)
    out.push_back(std::uint8_t(value >> shift));
}

void append_u64(Bytes& out, std::uint64_t value) {
  append_u32(out, std::uint32_t(value));
  append_u32(out, std::uint32_t(value >> 32));
}

std::uint32_t u32_at(ByteView bytes, std::size_t at) {
  return std::uint32_t(bytes[at]) | std::uint32_t(bytes[at + 1]) << 8 |
         std::uint32_t(bytes[at + 2]) << 16 | std::uint32_t(bytes[at + 3]) << 24;
}

std::uint64_t u64_at(ByteView bytes, std::size_t at) {
  return u32_at(bytes, at) | std::uint64_t(u32_at(bytes, at + 4)) << 32;
}

void append_values(Bytes& out, const Texture& texture) {
  for (const float value : texture.values) {
    if (texture.precision == Precision::float32) {
      append_u32(out, std::bit_cast<std::uint32_t>(value));
    } else {
      const std::uint16_t half = half_from_float(value);
      out.push_back(std::uint8_t(half));
      out.push_back(std::uint8_t(half >> 8));
    }
  }
}

void read_values(Texture& texture, ByteView bytes) {
  texture.values.resize(texture.count());
  for (std::size_t i = 0; i < texture.values.size(); ++i)
    texture.values[i] = texture.precision == Precision::float32
                            ? std::bit_cast<float>(u32_at(bytes, 4 * i))
                            : float_from_half(std::uint16_t(bytes[2 * i] | bytes[2 * i + 1] << 8));
}

} // namespace openltc::table
