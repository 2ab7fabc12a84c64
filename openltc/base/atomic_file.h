// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Writing files so that they are either complete or not there, and several together.

#pragma once

#include "openltc/base/result.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace openltc {

/// Calls `write` with the path of a temporary file, whose name and extension say nothing, and then
/// makes that file `path`. When `write` fails, throws or writes nothing, or the process ends, an
/// existing `path` is left as it was and nothing else stays; where the file system has no files
/// without a name (NFS, FAT), SIGKILL and a power failure leave the hidden .NAME.PID-N.part.
///
/// A symbolic link is followed and stays; an existing file keeps its permission bits, access list
/// and, as far as the system lets us, owner and group. Into a pipe or a character device the bytes
/// are copied once they are complete. The error names `path`.
Status write_atomically(const std::string& path,
                        const std::function<Status(const std::string& temporary)>& write);

/// While it lives, what this thread writes by write_atomically only gets ready; commit() then lets
/// all files change together. Without it, none changes. One inside another hands over to it.
class FileGroup {
public:
  FileGroup();
  ~FileGroup();
  FileGroup(const FileGroup&) = delete;
  FileGroup& operator=(const FileGroup&) = delete;

  /// All files in the order in which they were written, pipes and devices first. If one fails,
  /// those before it are put back, and the error names it. The FileObserver is told that
  /// this must not be cut in two.
  Status commit();

private:
  friend Status write_atomically(const std::string&,
                                 const std::function<Status(const std::string&)>&);
  struct Member;
  std::vector<std::unique_ptr<Member>> members_;
  FileGroup* outer_ = nullptr;
};

/// A file in memory: what a writer makes before anything of it is on a disk.
struct FileBytes {
  std::string path; ///< where it belongs, or its name alone
  std::vector<std::uint8_t> bytes;
};

/// A file of text.
inline FileBytes file_of_text(std::string path, const std::string& text) {
  return {std::move(path), std::vector<std::uint8_t>(text.begin(), text.end())};
}

/// Writes all files or none: when one fails, older files of these names stay as they were. Returns
/// their paths.
Result<std::vector<std::string>> write_files(std::span<const FileBytes> files);

} // namespace openltc
