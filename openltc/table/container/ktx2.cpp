// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

//
// Source: Khronos Group, "KTX File Format Specification", version 2.0, and "Khronos Data Format
// Specification" 1.3, section 5 (the basic descriptor block).

#include "openltc/table/container/container.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace openltc::table {

namespace {

constexpr std::array<std::uint8_t, 12> k_identifier = {0xab, 'K',  'T',  'X',  ' ',  '2',
                                                       '0',  0xbb, '\r', '\n', 0x1a, '\n'};
constexpr std::size_t k_header = 80, k_level = 24; // header with index, one entry of the levels
const std::string k_prefix = "openltc.";           // of the keys that are ours
constexpr const char* k_writer = "OpenLTC";

struct Format {
  std::uint32_t vk; // VkFormat
  int channels;
  Precision precision;
};
constexpr Format k_formats[] = {
    {109, 4, Precision::float32}, {97, 4, Precision::float16},  {103, 2, Precision::float32},
    {83, 2, Precision::float16},  {100, 1, Precision::float32}, {76, 1, Precision::float16},
};

// Data format descriptor: total size, one basic block with a sample per channel.
Bytes descriptor_of(const Texture& texture) {
  const std::uint32_t bits = std::uint32_t(8 * bytes_of(texture.precision));
  const std::uint32_t channels = std::uint32_t(texture.channels), block = 24 + 16 * channels;
  constexpr std::uint32_t ids[] = {0, 1, 2, 15}; // R G B A
  Bytes out;
  append_u32(out, 4 + block);
  append_u32(out, 0);                    // Khronos, basic format
  append_u32(out, 2 | block << 16);      // version 1.3, size
  append_u32(out, 1 | 1 << 8 | 1 << 16); // RGBSDA, BT.709 primaries, linear, no flags
  append_u32(out, 0);                    // a texel block is one texel
  append_u32(out, channels * bits / 8);
  append_u32(out, 0);
  for (std::uint32_t c = 0; c < channels; ++c) {
    append_u32(out, c * bits | (bits - 1) << 16 | (ids[c] | 0x80 | 0x40) << 24); // float, signed
    append_u32(out, 0);
    append_u32(out, 0xbf800000); // -1 and 1 in single precision, whatever the channel's
    append_u32(out, 0x3f800000);
  }
  return out;
}

Bytes key_values_of(const KeyValues& metadata) {
  KeyValues all = {{"KTXorientation", "rd"}, {"KTXwriter", k_writer}};
  for (const auto& [key, value] : metadata)
    all.emplace_back(k_prefix + key, value);
  std::sort(all.begin(), all.end()); // the format wants the order of the bytes
  Bytes out;
  for (const auto& [key, value] : all) {
    append_u32(out, std::uint32_t(key.size() + value.size() + 2));
    out.insert(out.end(), key.begin(), key.end());
    out.push_back(0);
    out.insert(out.end(), value.begin(), value.end());
    out.push_back(0);
    out.resize((out.size() + 3) / 4 * 4, 0);
  }
  return out;
}

// Our keys of a key/value block; an error when its lengths do not fit together.
Status read_key_values(ByteView block, const std::string& name, KeyValues& metadata) {
  std::size_t at = 0;
  while (at + 4 <= block.size()) {
    const std::size_t length = u32_at(block, at);
    at += 4;
    if (length > block.size() - at)
      return Error{fmt::format("{}: the key/values of the KTX2 file run over their end", name)};
    const std::string entry(block.begin() + std::ptrdiff_t(at),
                            block.begin() + std::ptrdiff_t(at + length));
    const std::size_t end = entry.find('\0');
    if (end == std::string::npos)
      return Error{fmt::format("{}: a key of the KTX2 file has no end", name)};
    std::string value = entry.substr(end + 1);
    while (!value.empty() && value.back() == '\0')
      value.pop_back();
    if (entry.compare(0, k_prefix.size(), k_prefix) == 0)
      metadata.emplace_back(entry.substr(k_prefix.size(), end - k_prefix.size()), value);
    at = std::min(block.size(), (at + length + 3) / 4 * 4);
  }
  return Success{};
}

} // namespace

Bytes encode_ktx2(const Texture& texture) { return encode_ktx2_array({&texture, 1}); }

Bytes encode_ktx2_array(std::span<const Texture> layers) {
  const Texture& texture = layers[0];
  const Format* format = std::find_if(std::begin(k_formats), std::end(k_formats), [&](auto& f) {
    return f.channels == texture.channels && f.precision == texture.precision;
  });
  const Bytes descriptor = descriptor_of(texture), keys = key_values_of(texture.metadata);
  const std::size_t texel = std::size_t(texture.channels) * bytes_of(texture.precision);
  const std::size_t descriptor_at = k_header + k_level;
  const std::size_t keys_at = descriptor_at + descriptor.size();
  const std::size_t alignment = std::max<std::size_t>(texel, 4); // lcm(texel, 4)
  const std::size_t level_at = (keys_at + keys.size() + alignment - 1) / alignment * alignment;
  const std::size_t level_size = layers.size() * texture.count() * bytes_of(texture.precision);

  Bytes out(k_identifier.begin(), k_identifier.end());
  append_u32(out, format->vk);
  append_u32(out, std::uint32_t(bytes_of(texture.precision))); // size of the data type
  append_u32(out, std::uint32_t(texture.width));
  append_u32(out, std::uint32_t(texture.height));
  append_u32(out, 0);                                                    // depth
  append_u32(out, layers.size() > 1 ? std::uint32_t(layers.size()) : 0); // 0: no array
  append_u32(out, 1);                                                    // one face
  append_u32(out, 1);                                                    // one level
  append_u32(out, 0);                                                    // not compressed
  append_u32(out, std::uint32_t(descriptor_at));
  append_u32(out, std::uint32_t(descriptor.size()));
  append_u32(out, std::uint32_t(keys_at));
  append_u32(out, std::uint32_t(keys.size()));
  append_u64(out, 0); // no data of a compression
  append_u64(out, 0);
  append_u64(out, level_at);
  append_u64(out, level_size);
  append_u64(out, level_size);
  out.insert(out.end(), descriptor.begin(), descriptor.end());
  out.insert(out.end(), keys.begin(), keys.end());
  out.resize(level_at, 0);
  for (const Texture& layer : layers)
    append_values(out, layer);
  return out;
}

Result<Texture> decode_ktx2(ByteView bytes, const std::string& name) {
  if (bytes.size() < k_header + k_level ||
      !std::equal(k_identifier.begin(), k_identifier.end(), bytes.begin()))
    return Error{fmt::format("{}: not a KTX2 file, or cut off in its header", name)};
  const std::uint32_t vk = u32_at(bytes, 12);
  const Format* format = nullptr;
  for (const Format& known : k_formats)
    if (vk == known.vk) format = &known;
  if (!format)
    return Error{
        fmt::format("{}: the KTX2 file's VkFormat {} is not one of 16- or 32-bit floats in "
                    "1, 2 or 4 channels",
                    name, vk)};
  if (u32_at(bytes, 28) > 1 || u32_at(bytes, 32) > 1 || u32_at(bytes, 36) != 1)
    return Error{
        fmt::format("{}: a volume, cube or array is no table; a plain KTX2 texture is", name)};
  if (u32_at(bytes, 44) != 0)
    return Error{fmt::format("{}: the KTX2 file is supercompressed; write it without", name)};
  if (Status status = check_texture_size(name, u32_at(bytes, 20), u32_at(bytes, 24),
                                         std::uint64_t(format->channels));
      !status)
    return status.error();

  Texture texture;
  texture.width = int(u32_at(bytes, 20));
  texture.height = int(u32_at(bytes, 24));
  texture.channels = format->channels;
  texture.precision = format->precision;
  const std::uint64_t at = u64_at(bytes, k_header), size = u64_at(bytes, k_header + 8);
  const std::uint64_t needed = texture.count() * bytes_of(texture.precision);
  if (size != needed || at < k_header + k_level || at > bytes.size() || size > bytes.size() - at)
    return Error{fmt::format("{}: {} bytes of texels at {} of {}, but {} x {} of this format need "
                             "{}; cut off or damaged",
                             name, size, at, bytes.size(), texture.width, texture.height, needed)};
  const std::uint64_t keys_at = u32_at(bytes, 56), keys_size = u32_at(bytes, 60);
  if (keys_size > 0) {
    if (keys_at + keys_size > bytes.size())
      return Error{fmt::format("{}: the key/values of the KTX2 file lie outside of it", name)};
    if (Status status = read_key_values(bytes.subspan(keys_at, keys_size), name, texture.metadata);
        !status)
      return status.error();
  }
  read_values(texture, bytes.subspan(at, needed));
  if (Status status = check_finite(name, texture); !status) return status.error();
  return texture;
}

} // namespace openltc::table
