// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/process/input_files.h"

#include <mutex>
#include <set>
#include <utility>

namespace openltc::cli {

namespace {

std::mutex g_mutex;
std::set<FilePlace>& inputs() {
  static std::set<FilePlace> places;
  return places;
}
std::set<std::string>& paths() {
  static std::set<std::string> all;
  return all;
}

} // namespace

void remember_input(const std::string& path) {
  FilePlace place = place_of(path);
  const std::lock_guard lock(g_mutex);
  inputs().insert(std::move(place));
  paths().insert(path);
}

bool is_input(const FilePlace& place) {
  const std::lock_guard lock(g_mutex);
  return inputs().count(place) > 0;
}

std::vector<std::string> input_paths() {
  const std::lock_guard lock(g_mutex);
  return {paths().begin(), paths().end()};
}

} // namespace openltc::cli
