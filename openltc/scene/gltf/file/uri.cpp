// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Data URIs: RFC 2397; base64: RFC 4648; percent-encoding: RFC 3986, section 2.1.

#include "openltc/scene/gltf/file/uri.h"

#include "openltc/base/quote.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace openltc::scene::gltf {

namespace {

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return -1;
}

std::vector<std::uint8_t> decode_base64(std::string_view text, const std::string& field) {
  while (!text.empty() && text.back() == '=')
    text.remove_suffix(1);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int bit_count = 0;
  for (const char c : text) {
    const int digit = base64_digit(c);
    if (digit < 0) fail(field, "the data URI is not valid base64; export the file again");
    bits = (bits << 6 | std::uint32_t(digit)) & 0xFFFFFF;
    bit_count += 6;
    if (bit_count >= 8) {
      bit_count -= 8;
      bytes.push_back(std::uint8_t(bits >> bit_count & 0xFF));
    }
  }
  return bytes;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string decode_percent(std::string_view uri) {
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool is_escape = uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 &&
                           hex_digit(uri[i + 2]) >= 0;
    path += is_escape ? char(hex_digit(uri[i + 1]) * 16 + hex_digit(uri[i + 2])) : uri[i];
    if (is_escape) i += 2;
  }
  return path;
}

// "https://...", "file:...", but not "a:b.bin" deeper in a path and no Windows drive letter.
bool has_scheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  return colon != std::string_view::npos && uri.find('/') >= colon;
}

} // namespace

bool is_data_uri(const std::string& uri) { return uri.rfind("data:", 0) == 0; }

std::string resolve_uri(const std::string& uri, const Folder& folder, const std::string& field) {
  if (uri.empty()) fail(field, "the reference is empty; export the file again");
  if (has_scheme(uri))
    fail(field,
         fmt::format("{} is a network or absolute address, which is not loaded; put the file "
                     "beside the glTF file and refer to it by a relative path",
                     quote(uri, k_longest_path)));
  std::string name = decode_percent(uri);
  if (name.find('\0') != std::string::npos)
    fail(field, fmt::format("{} holds a zero byte, which no path has", quote(uri, k_longest_path)));
  if (folder.path.empty())
    fail(field, fmt::format("the file {} cannot be looked up when loading from memory without a "
                            "folder; embed it or give the folder",
                            quote(uri, k_longest_path)));
  return find_in_folder(name, uri, folder, field);
}

std::vector<std::uint8_t> read_uri(const std::string& uri, const Folder& folder,
                                   const std::string& field, MemoryShare& memory,
                                   std::uint64_t most) {
  if (!is_data_uri(uri)) return read_file(resolve_uri(uri, folder, field), field, memory, most);
  const std::size_t comma = uri.find(',');
  if (comma == std::string::npos) fail(field, "the data URI has no data; export the file again");
  if (uri.substr(0, comma).find(";base64") == std::string::npos)
    fail(field, "the data URI is not base64; export the file again");
  take_memory(memory, (uri.size() - comma) / 4 * 3 + 2, field);
  std::vector<std::uint8_t> bytes = decode_base64(std::string_view(uri).substr(comma + 1), field);
  if (bytes.size() > most) bytes.resize(most);
  return bytes;
}

} // namespace openltc::scene::gltf
