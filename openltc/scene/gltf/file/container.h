// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The two containers of glTF: .glb (binary chunks) and .gltf (text).

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace openltc::scene::gltf {

/// Views into the file's bytes.
struct Container {
  std::string_view json;
  std::span<const std::uint8_t> binary; ///< the BIN chunk of a .glb
  bool has_binary = false;
};

/// Tells .glb from .gltf by content and finds the parts. Throws Failure when the bytes are neither,
/// when a .glb is cut short, or when its JSON nests deeper than a parser may be trusted with.
Container split_container(std::span<const std::uint8_t> bytes);

/// About how many bytes it takes to parse `json`: its values are many times as large in memory.
std::uint64_t memory_to_parse(std::string_view json);

/// Throws Failure that names `field` when `json` nests deeper than that.
void check_json_depth(std::string_view json, const std::string& field);

} // namespace openltc::scene::gltf
