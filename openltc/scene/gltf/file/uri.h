// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// References from a glTF file to its buffers and images.

#pragma once

#include "openltc/base/memory_budget.h"
#include "openltc/base/regular_file.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace openltc::scene::gltf {

/// Characters of a path in messages.
inline constexpr std::size_t k_longest_path = 160;

/// Where a file's references are looked up.
struct Folder {
  std::string path;           ///< empty: there is none, and references to files are refused
  bool allow_outside = false; ///< ReadOptions

  Folder() = default;
  Folder(std::string path_, bool allow_outside_ = false)
      : path(std::move(path_)), allow_outside(allow_outside_) {}
};

/// The folder that the file at `path` lies in.
Folder folder_of(const std::string& path, bool allow_outside);

/// The path of a file that `uri` refers to, relative to `folder`. Backslashes, which Windows
/// programs write, are slashes where no file has them in its name. Throws Failure that names
/// `field` when it is a network address, leads out of the folder and may not, or when there is no
/// folder. Whether the file exists is not asked.
std::string resolve_uri(const std::string& uri, const Folder& folder, const std::string& field);

/// The path of `name`, which `uri` says, in `folder`: the second half of resolve_uri, with its
/// errors.
std::string find_in_folder(const std::string& name, const std::string& uri, const Folder& folder,
                           const std::string& field);

/// One text for all spellings of a path, links followed.
std::string canonical_path(const std::string& path);

/// Whether `uri` holds the data itself.
bool is_data_uri(const std::string& uri);

/// The bytes behind `uri`, no more than the first `most`: a base64 data URI or a file as above.
/// Counts them in `memory` before it reads them. Throws Failure that names `field` when it cannot.
std::vector<std::uint8_t> read_uri(const std::string& uri, const Folder& folder,
                                   const std::string& field, MemoryShare& memory,
                                   std::uint64_t most = k_any_size);

/// The first `most` bytes of a file; memory and errors as above.
std::vector<std::uint8_t> read_file(const std::string& path, const std::string& field,
                                    MemoryShare& memory, std::uint64_t most = k_any_size);

/// A whole .gltf or .glb, which no format lets be larger than 4 GiB.
std::vector<std::uint8_t> read_scene_file(const std::string& path, MemoryShare& memory);

} // namespace openltc::scene::gltf
