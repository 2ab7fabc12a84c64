// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/process/file_watch.h"

#include "cli/process/ending.h"
#include "cli/process/input_files.h"
#include "openltc/base/file_observer.h"

namespace openltc::cli {

namespace {

class FileWatch : public FileObserver {
public:
  void reads(const std::string& path) override { remember_input(path); }
  void begins_undivided() noexcept override { hold_ending(); }
  void ends_undivided() noexcept override { release_ending(); }
  void makes_unfinished(const std::string& path) override { remember_unfinished(path); }
  void ends_unfinished(const std::string& path) noexcept override { forget_unfinished(path); }
  void has_written() noexcept override { note_written(); }
};

} // namespace

void watch_files() {
  static FileWatch& watch = *new FileWatch; // files may be closed while the process exits
  observe_files(&watch);
}

} // namespace openltc::cli
