// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Whether two paths mean one file.

#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace openltc {

/// Where a file lies, the same for every spelling, symbolic or hard link: its device and number; of
/// a file that does not exist those of its folder, and its name there.
struct FilePlace {
  std::uint64_t device = 0, number = 0;
  std::string name;
  auto operator<=>(const FilePlace&) const = default;
};

/// Of a path into a folder that does not exist the path itself is the name.
FilePlace place_of(const std::string& path);

/// `path`, or, where that is a symbolic link to something that does not exist, what it points to.
std::string without_dangling_links(const std::string& path);

} // namespace openltc
