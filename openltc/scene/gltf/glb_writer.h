// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Writing a .glb that holds everything it refers to.

#pragma once

#include "openltc/base/result.h"
#include "openltc/scene/gltf/file/uri.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace openltc::scene::gltf {

/// The bytes of the binary chunk, and whether the file has one.
struct Binary {
  std::vector<std::uint8_t> bytes;
  bool exists = false;
};

/// Adds `bytes` as a buffer view of the binary chunk, which `root` may lack, and returns its index.
/// The buffers of `root` refer to nothing outside any more.
std::size_t add_view(nlohmann::ordered_json& root, Binary& binary,
                     std::span<const std::uint8_t> bytes);

/// Moves the buffers, pictures and photometric files of EXT_lights_ies that `root` refers to by URI
/// into `binary`, which holds those of buffers[0] if it has none, and turns the references over.
/// Pictures that are not there or of no known kind keep their URI. A file that is
/// named more than once goes in once. Counts the bytes in `memory`. Throws Failure when a buffer
/// cannot be read.
void embed_references(nlohmann::ordered_json& root, Binary& binary, const Folder& folder,
                      MemoryShare& memory);

/// Writes both to `path`, whole or not at all. The error names `path`.
Status write_glb(const std::string& path, const nlohmann::ordered_json& root, const Binary& binary);

} // namespace openltc::scene::gltf
