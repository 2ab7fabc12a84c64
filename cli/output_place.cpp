// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/output_place.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <unistd.h>

namespace openltc::cli {

namespace fs = std::filesystem;

Status check_place(const std::string& path) {
  std::error_code ec;
  if (fs::is_directory(path, ec)) return Error{fmt::format("{}: is a directory", path)};
  fs::path folder = fs::path(path).parent_path();
  if (folder.empty()) folder = ".";
  if (!fs::is_directory(folder, ec))
    return Error{fmt::format("{}: the folder {} does not exist", path, folder.string())};
  // Permission bits do not tell all (root, read-only and virtual file systems): try it.
  std::string probe = (folder / ".openltc-XXXXXX").string();
  const int file = mkstemp(probe.data());
  if (file < 0)
    return Error{fmt::format("{}: cannot write in the folder {}: {}", path, folder.string(),
                             std::strerror(errno))};
  close(file);
  unlink(probe.c_str());
  return Success{};
}

} // namespace openltc::cli
