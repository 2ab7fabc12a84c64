// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The GLB container: glTF 2.0 specification, section 4.4.

#include "openltc/scene/gltf/file/container.h"

#include "openltc/scene/gltf/file/failure.h"

#include <fmt/format.h>

#include <cstring>

namespace openltc::scene::gltf {

namespace {

constexpr std::size_t k_header_size = 12;
constexpr std::size_t k_chunk_header_size = 8;
constexpr std::uint32_t k_chunk_json = 0x4E4F534A;   // "JSON"
constexpr std::uint32_t k_chunk_binary = 0x004E4942; // "BIN"

// Nesting of arrays and objects. glTF itself needs about ten levels; what reads the text after us
// recurses, so that a file of a million brackets would exhaust the stack.
constexpr int k_max_json_depth = 96;

std::uint32_t read_u32(std::span<const std::uint8_t> bytes, std::size_t offset) {
  return std::uint32_t(bytes[offset]) | std::uint32_t(bytes[offset + 1]) << 8 |
         std::uint32_t(bytes[offset + 2]) << 16 | std::uint32_t(bytes[offset + 3]) << 24;
}

std::string_view as_text(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Container split_glb(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < k_header_size + k_chunk_header_size)
    fail("GLB header", "the file is cut short; export or copy it again");
  const std::uint32_t version = read_u32(bytes, 4);
  if (version != 2)
    fail("GLB header", fmt::format("version {} is not supported; export as glTF 2.0", version));
  const std::size_t length = read_u32(bytes, 8);
  if (length > bytes.size())
    fail("GLB header", fmt::format("{} bytes are announced but the file has {}; it is cut short, "
                                   "export or copy it again",
                                   length, bytes.size()));

  Container container;
  bool has_json = false;
  std::size_t offset = k_header_size;
  while (offset + k_chunk_header_size <= length) {
    const std::size_t chunk_length = read_u32(bytes, offset);
    const std::uint32_t chunk_type = read_u32(bytes, offset + 4);
    offset += k_chunk_header_size;
    if (chunk_length > length - offset)
      fail("GLB chunk", fmt::format("{} bytes are announced but {} are left; the file is damaged, "
                                    "export or copy it again",
                                    chunk_length, length - offset));
    const auto chunk = bytes.subspan(offset, chunk_length);
    if (!has_json) {
      if (chunk_type != k_chunk_json)
        fail("GLB chunk", "the first chunk is not JSON; the file is damaged");
      container.json = as_text(chunk);
      has_json = true;
    } else if (chunk_type == k_chunk_binary && !container.has_binary) {
      container.binary = chunk;
      container.has_binary = true;
    }
    offset += chunk_length;
  }
  if (!has_json) fail("GLB chunk", "the file has no JSON chunk; it is cut short");
  return container;
}

Container split_text(std::span<const std::uint8_t> bytes) {
  std::string_view text = as_text(bytes);
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.substr(0, 3) == byte_order_mark) text.remove_prefix(3);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || text[first] != '{')
    fail("",
         "not a glTF file: it begins neither with \"glTF\" nor with a JSON object; give a .gltf "
         "or .glb file");
  return {text, {}, false};
}

} // namespace

void check_json_depth(std::string_view json, const std::string& field) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
      continue;
    }
    if (c == '"') in_string = true;
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    if (depth > k_max_json_depth)
      fail(field, fmt::format("nested deeper than {} levels; this is not a usable glTF file",
                              k_max_json_depth));
  }
}

std::uint64_t memory_to_parse(std::string_view json) {
  // The text three times over (ours, tinygltf's and what is handed over), and for every value a
  // node of a tree or an element of an array, with its share of growth; each value but the first
  // follows one of these characters.
  constexpr std::uint64_t k_value = 100;
  std::uint64_t values = 1;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (c == '"') in_string = !in_string;
    if (in_string && c == '\\') ++i;
    if (!in_string && (c == ',' || c == '{' || c == '[')) ++values;
  }
  return 3 * std::uint64_t(json.size()) + k_value * values;
}

Container split_container(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) fail("", "the file is empty; give a .gltf or .glb file");
  const bool is_glb = bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0;
  const Container container = is_glb ? split_glb(bytes) : split_text(bytes);
  check_json_depth(container.json, "JSON");
  return container;
}

} // namespace openltc::scene::gltf
