// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// One texture of a table, as the containers hold it.

#pragma once

#include "openltc/base/result.h"

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace openltc::table {

/// How a number is stored.
enum class Precision { float32, float16 };

/// What a file says about itself, in the order in which it is written. Keys are lower case.
using KeyValues = std::vector<std::pair<std::string, std::string>>;

/// Values of `key`, nullptr when it is not there.
const std::string* find_value(const KeyValues& values, const std::string& key);

/// A rectangle of texels, row 0 first, the channels of a texel side by side.
struct Texture {
  static constexpr int k_max_side = 512; ///< larger ones are refused: no table needs them

  int width = 0;    ///< columns: roughness
  int height = 0;   ///< rows: view angle
  int channels = 0; ///< 1..4
  Precision precision = Precision::float32;
  std::vector<float> values; ///< width * height * channels; in half precision already rounded
  KeyValues metadata;        ///< only the containers .ktx2 and .exr hold it

  std::size_t count() const {
    return std::size_t(width) * std::size_t(height) * std::size_t(channels);
  }
};

/// Refuses sizes outside 1..k_max_side and channels outside 1..4. The error begins with `name`.
Status check_texture_size(const std::string& name, std::uint64_t width, std::uint64_t height,
                          std::uint64_t channels);

/// Refuses NaN and infinities, naming the first texel. The error begins with `name`.
Status check_finite(const std::string& name, const Texture& texture);

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

/// The values as little-endian floats or halves, and back: `bytes` holds texture.count() of them.
void append_values(Bytes& out, const Texture& texture);
void read_values(Texture& texture, ByteView bytes);

/// Bytes of one number.
inline std::size_t bytes_of(Precision precision) { return precision == Precision::float32 ? 4 : 2; }

/// Little-endian numbers at a place, which must lie within.
void append_u32(Bytes& out, std::uint32_t value);
void append_u64(Bytes& out, std::uint64_t value);
std::uint32_t u32_at(ByteView bytes, std::size_t at);
std::uint64_t u64_at(ByteView bytes, std::size_t at);

} // namespace openltc::table
