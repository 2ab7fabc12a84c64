// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A file on its way to its name.

#pragma once

#include "openltc/base/result.h"

#include <string>

namespace openltc {

/// A new empty file that goes away with this object and, where it has no name, with the process,
/// however that ends. While it has one, the FileObserver knows it and can remove it.
class TemporaryFile {
public:
  TemporaryFile() = default;
  TemporaryFile(TemporaryFile&& other) noexcept;
  TemporaryFile& operator=(TemporaryFile&& other) noexcept;
  ~TemporaryFile();

  int descriptor() const { return descriptor_; }
  /// To write to it.
  std::string path() const;
  /// Permission bits that a new file gets here: those of the umask.
  unsigned new_mode() const { return new_mode_; }

  /// Gives it a name, which must be free, or another one. False with errno set.
  bool link_as(const std::string& path);
  /// Makes it the file `path`, of which it takes the place. False with errno set.
  bool rename_to(const std::string& path);
  /// Gives it the name of the file `path`, and that file its own hidden name, under which it is
  /// still there until this object goes. False with errno set, and nothing changed.
  bool change_places_with(const std::string& path);
  /// Undoes change_places_with.
  bool put_back(const std::string& path);

private:
  friend Result<TemporaryFile> make_temporary_file(const std::string& folder,
                                                   const std::string& label);
  bool give_name();

  int descriptor_ = -1;
  std::string folder_, label_;
  std::string name_; ///< empty: none
  unsigned new_mode_ = 0;
};

/// In `folder`, without a name where the file system can make such files, else with a hidden one
/// that holds `label`. Only its owner may read it. The error is the system's reason alone.
Result<TemporaryFile> make_temporary_file(const std::string& folder, const std::string& label);

/// For tests: from now on as on a file system that has neither files without a name nor an exchange
/// of two names.
void assume_plain_file_system(bool plain);

} // namespace openltc
