// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What lies where a file is to be written, and whether it may be written.

#pragma once

#include "openltc/base/result.h"

#include <string>
#include <sys/stat.h>

namespace openltc {

/// Where the bytes of an output go.
struct Destination {
  std::string path;       ///< symbolic links followed; of a stream as it was given
  std::string folder;     ///< of path, "." for the working folder
  bool exists = false;    ///< a regular file lies there
  bool is_stream = false; ///< a pipe or a character device: bytes go into it, it is not replaced
  struct stat facts = {}; ///< of what lies there, if anything does
};

/// An error, which begins with `path`, when it is empty, a directory, a block device or a socket,
/// when its folder does not exist, its links have no end, or what lies there may not be written.
Result<Destination> find_destination(const std::string& path);

/// find_destination, and whether a new file can be made in the folder, which is tried, and take the
/// place of an old one. The error names `path`.
Status check_destination(const std::string& path);

} // namespace openltc
