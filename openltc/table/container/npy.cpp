// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

//
// Source: NumPy, "NPY format" (numpy.lib.format): magic, version, a Python dictionary as text
// padded to 64 bytes, the values.

#include "openltc/table/container/container.h"

#include <fmt/format.h>

#include <cctype>
#include <string_view>

namespace openltc::table {

namespace {

constexpr std::string_view k_magic = "\x93NUMPY";
constexpr std::size_t k_prefix = 10; // magic, version, length of the dictionary

// What follows `key` in the dictionary, from its first character that is no blank; "" without it.
std::string_view value_of(std::string_view dictionary, std::string_view key) {
  std::size_t at = dictionary.find(key);
  if (at == std::string_view::npos) return {};
  at += key.size();
  while (at < dictionary.size() && (dictionary[at] == ' ' || dictionary[at] == ':'))
    ++at;
  return dictionary.substr(at);
}

// The numbers of "(a, b, c)"; empty when it is anything else or longer than three.
std::vector<std::uint64_t> read_shape(std::string_view text) {
  std::vector<std::uint64_t> shape;
  std::size_t at = 1;
  if (text.empty() || text[0] != '(') return {};
  while (at < text.size() && text[at] != ')') {
    std::uint64_t number = 0;
    std::size_t digits = 0;
    for (; at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])); ++at, ++digits)
      number = number * 10 + std::uint64_t(text[at] - '0');
    if (digits < 1 || digits > 9 || shape.size() == 3) return {};
    shape.push_back(number);
    while (at < text.size() && (text[at] == ',' || text[at] == ' '))
      ++at;
  }
  return at < text.size() ? shape : std::vector<std::uint64_t>();
}

} // namespace

Bytes encode_npy(const Texture& texture) {
  std::string dictionary =
      fmt::format("{{'descr': '<f{}', 'fortran_order': False, 'shape': ({}, {}, {}), }}",
                  bytes_of(texture.precision), texture.height, texture.width, texture.channels);
  const std::size_t whole = (k_prefix + dictionary.size() + 1 + 63) / 64 * 64;
  dictionary.resize(whole - k_prefix - 1, ' ');
  dictionary += '\n';
  Bytes out(k_magic.begin(), k_magic.end());
  out.push_back(1); // version 1.0
  out.push_back(0);
  out.push_back(std::uint8_t(dictionary.size()));
  out.push_back(std::uint8_t(dictionary.size() >> 8));
  out.insert(out.end(), dictionary.begin(), dictionary.end());
  append_values(out, texture);
  return out;
}

Result<Texture> decode_npy(ByteView bytes, const std::string& name) {
  if (bytes.size() < k_prefix ||
      !std::equal(k_magic.begin(), k_magic.end(), bytes.begin(),
                  [](char a, std::uint8_t b) { return std::uint8_t(a) == b; }))
    return Error{fmt::format("{}: not a NumPy file, or cut off in its header", name)};
  if (bytes[6] != 1)
    return Error{fmt::format("{}: NumPy format {}.{} is not 1.0, the one that arrays of plain "
                             "numbers have",
                             name, bytes[6], bytes[7])};
  const std::size_t length = std::size_t(bytes[8]) | std::size_t(bytes[9]) << 8;
  if (length > bytes.size() - k_prefix)
    return Error{fmt::format("{}: the NumPy file is cut off in its header", name)};
  const std::string dictionary(bytes.begin() + k_prefix,
                               bytes.begin() + std::ptrdiff_t(k_prefix + length));
  const std::string_view type = value_of(dictionary, "'descr'");
  const bool single = type.substr(0, 5) == "'<f4'";
  if (!single && type.substr(0, 5) != "'<f2'")
    return Error{fmt::format("{}: the type of the NumPy array is not '<f4' or '<f2'", name)};
  if (value_of(dictionary, "'fortran_order'").substr(0, 5) != "False")
    return Error{fmt::format("{}: the NumPy array is in Fortran order; write it in C order", name)};
  std::vector<std::uint64_t> shape = read_shape(value_of(dictionary, "'shape'"));
  if (shape.size() == 2) shape.push_back(1);
  if (shape.size() != 3)
    return Error{
        fmt::format("{}: the shape of the NumPy array is not (rows, columns, channels)", name)};
  if (Status status = check_texture_size(name, shape[1], shape[0], shape[2]); !status)
    return status.error();

  Texture texture;
  texture.height = int(shape[0]);
  texture.width = int(shape[1]);
  texture.channels = int(shape[2]);
  texture.precision = single ? Precision::float32 : Precision::float16;
  const std::size_t present = bytes.size() - k_prefix - length;
  const std::size_t needed = texture.count() * bytes_of(texture.precision);
  if (present != needed)
    return Error{
        fmt::format("{}: {} bytes of numbers, but the shape ({}, {}, {}) needs {}; cut off "
                    "or damaged",
                    name, present, shape[0], shape[1], shape[2], needed)};
  read_values(texture, bytes.subspan(k_prefix + length));
  if (Status status = check_finite(name, texture); !status) return status.error();
  return texture;
}

} // namespace openltc::table
