// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

//
// Source: Microsoft, "Programming Guide for DDS" and the reference of DDS_HEADER, DDS_PIXELFORMAT
// and DDS_HEADER_DXT10; D3DFORMAT for the numbers of the older FourCCs.

#include "openltc/table/container/container.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace openltc::table {

namespace {

constexpr std::uint32_t k_magic = 0x20534444; // "DDS "
constexpr std::uint32_t k_dx10 = 0x30315844;  // "DX10"
constexpr std::size_t k_header = 128, k_dx10_header = 148;

struct Format {
  std::uint32_t dxgi, fourcc; // DXGI_FORMAT, D3DFORMAT
  int channels;
  Precision precision;
};
constexpr Format k_formats[] = {
    {2, 116, 4, Precision::float32},  {10, 113, 4, Precision::float16},
    {16, 115, 2, Precision::float32}, {34, 112, 2, Precision::float16},
    {41, 114, 1, Precision::float32}, {54, 111, 1, Precision::float16},
};

} // namespace

Bytes encode_dds(const Texture& texture) {
  const Format* format = std::find_if(std::begin(k_formats), std::end(k_formats), [&](auto& f) {
    return f.channels == texture.channels && f.precision == texture.precision;
  });
  const std::uint32_t pitch = std::uint32_t(
      std::size_t(texture.width) * std::size_t(texture.channels) * bytes_of(texture.precision));
  Bytes out;
  append_u32(out, k_magic);
  append_u32(out, 124);    // size of the header
  append_u32(out, 0x100f); // caps, height, width, pitch, pixel format
  append_u32(out, std::uint32_t(texture.height));
  append_u32(out, std::uint32_t(texture.width));
  append_u32(out, pitch);
  append_u32(out, 0); // depth
  append_u32(out, 1); // mip levels
  for (int i = 0; i < 11; ++i)
    append_u32(out, 0);
  append_u32(out, 32); // size of the pixel format
  append_u32(out, 4);  // a FourCC
  append_u32(out, k_dx10);
  for (int i = 0; i < 5; ++i)
    append_u32(out, 0);
  append_u32(out, 0x1000); // caps: a texture
  for (int i = 0; i < 4; ++i)
    append_u32(out, 0);
  append_u32(out, format->dxgi);
  append_u32(out, 3); // two-dimensional
  append_u32(out, 0); // no cube
  append_u32(out, 1); // one of them
  append_u32(out, 0); // alpha has no special meaning
  append_values(out, texture);
  return out;
}

Result<Texture> decode_dds(ByteView bytes, const std::string& name) {
  if (bytes.size() < k_header || u32_at(bytes, 0) != k_magic)
    return Error{fmt::format("{}: not a DDS file, or cut off in its header", name)};
  if (u32_at(bytes, 4) != 124 || u32_at(bytes, 76) != 32)
    return Error{fmt::format("{}: the DDS header has a wrong size", name)};
  const std::uint32_t fourcc = (u32_at(bytes, 80) & 4) != 0 ? u32_at(bytes, 84) : 0;
  const bool dx10 = fourcc == k_dx10;
  if (dx10 && bytes.size() < k_dx10_header)
    return Error{fmt::format("{}: the DDS file is cut off in its header", name)};
  const std::uint32_t code = dx10 ? u32_at(bytes, 128) : fourcc;
  const Format* format = nullptr;
  for (const Format& known : k_formats)
    if (code == (dx10 ? known.dxgi : known.fourcc)) format = &known;
  if (!format)
    return Error{fmt::format("{}: the DDS file's {} {} is not one of 16- or 32-bit floats", name,
                             dx10 ? "DXGI format" : "pixel format", code)};
  if ((u32_at(bytes, 112) & 0x20fe00) != 0 ||
      (dx10 &&
       (u32_at(bytes, 132) != 3 || (u32_at(bytes, 136) & 4) != 0 || u32_at(bytes, 140) > 1)))
    return Error{
        fmt::format("{}: a volume, cube or array is no table; a plain DDS texture is", name)};

  const std::uint32_t height = u32_at(bytes, 12), width = u32_at(bytes, 16);
  if (Status status = check_texture_size(name, width, height, std::uint64_t(format->channels));
      !status)
    return status.error();
  Texture texture;
  texture.width = int(width);
  texture.height = int(height);
  texture.channels = format->channels;
  texture.precision = format->precision;
  const std::size_t start = dx10 ? k_dx10_header : k_header;
  const std::size_t needed = texture.count() * bytes_of(texture.precision);
  const std::size_t present = bytes.size() - start;
  const bool levels = u32_at(bytes, 28) > 1;
  if (levels ? present < needed : present != needed)
    return Error{fmt::format("{}: {} bytes of texels, but {} x {} of this format need {}; cut off "
                             "or damaged",
                             name, present, width, height, needed)};
  read_values(texture, bytes.subspan(start, needed));
  if (Status status = check_finite(name, texture); !status) return status.error();
  return texture;
}

} // namespace openltc::table
