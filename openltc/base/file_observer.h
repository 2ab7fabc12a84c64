// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What a program can learn of the files that the library reads and writes. The library itself keeps
// no list of them and handles no signal; a tool that does both observes it.

#pragma once

#include <string>

namespace openltc {

/// Told of files. Every function may be called from any thread, several at a time; those that are
/// not overridden do nothing.
class FileObserver {
public:
  virtual ~FileObserver() = default;

  /// `path` is read, or is named by a file that is read.
  virtual void reads(const std::string& path);

  /// What happens between these two should not be cut in two by the end of the process. It lasts
  /// for milliseconds. May be nested.
  virtual void begins_undivided() noexcept;
  virtual void ends_undivided() noexcept;

  /// An unfinished file has this name, which the end of the process would leave behind. Called
  /// between the two above, as are the next ones.
  virtual void makes_unfinished(const std::string& path);
  /// It has it no longer.
  virtual void ends_unfinished(const std::string& path) noexcept;
  /// Files are written and have their names.
  virtual void has_written() noexcept;
};

/// The one observer of this process, which must live until another takes its place; null for none,
/// as at first. To be called while the library reads and writes nothing.
void observe_files(FileObserver* observer) noexcept;

/// What observe_files was given, or one that does nothing.
FileObserver& file_observer() noexcept;

/// While one lives: between begins_undivided and ends_undivided.
class Undivided {
public:
  Undivided() noexcept : observer_(file_observer()) { observer_.begins_undivided(); }
  ~Undivided() { observer_.ends_undivided(); }
  Undivided(const Undivided&) = delete;
  Undivided& operator=(const Undivided&) = delete;

private:
  FileObserver& observer_;
};

} // namespace openltc
