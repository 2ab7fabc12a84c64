// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/file_place.h"

#include <filesystem>
#include <sys/stat.h>

namespace openltc {

namespace fs = std::filesystem;

namespace {

constexpr int k_most_links = 40; // as Linux

std::string folder_of(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

} // namespace

std::string without_dangling_links(const std::string& path) {
  struct stat facts = {};
  fs::path at = path;
  for (int i = 0; i < k_most_links && ::stat(at.c_str(), &facts) != 0; ++i) {
    std::error_code ec;
    const fs::path next = fs::read_symlink(at, ec);
    if (ec) return at.string(); // no link: simply not there
    at = next.is_absolute() ? next : at.parent_path() / next;
  }
  return at.string();
}

FilePlace place_of(const std::string& path) {
  const std::string at = without_dangling_links(path);
  struct stat facts = {};
  if (::stat(at.c_str(), &facts) == 0)
    return {std::uint64_t(facts.st_dev), std::uint64_t(facts.st_ino), ""};
  if (::stat(folder_of(at).c_str(), &facts) == 0)
    return {std::uint64_t(facts.st_dev), std::uint64_t(facts.st_ino),
            fs::path(at).filename().string()};
  return {0, 0, at};
}

} // namespace openltc
