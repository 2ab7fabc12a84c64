// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A folder for a test's files.

#pragma once

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace openltc::test {

/// A folder of its own for each object, removed with it.
class Folder {
public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "openltc-base-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  int file_count() const {
    return int(std::distance(std::filesystem::directory_iterator(path_),
                             std::filesystem::directory_iterator()));
  }

private:
  std::filesystem::path path_;
};

inline void put_text(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  REQUIRE(file.good());
}

inline std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

} // namespace openltc::test
