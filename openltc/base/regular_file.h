// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Opening a file that a user or another file names. Only regular files are read: a pipe or a device
// may keep its reader waiting for ever, or never end.

#pragma once

#include "openltc/base/result.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace openltc {

/// A size that refuses nothing.
inline constexpr std::uint64_t k_any_size = std::numeric_limits<std::uint64_t>::max();

/// A regular file that is open for reading. It closes itself and can be moved, not copied.
class RegularFile {
public:
  RegularFile(RegularFile&& other) noexcept;
  RegularFile& operator=(RegularFile&& other) noexcept;
  ~RegularFile();

  /// Bytes, when it was opened.
  std::uint64_t size() const { return size_; }

  /// Reads up to to.size() bytes from `offset` on, fewer only at the end of the file. The number
  /// read, or an error that names the file.
  Result<std::size_t> read_at(std::uint64_t offset, std::span<std::uint8_t> to) const;

private:
  friend Result<RegularFile> open_regular_file(const std::string& path, std::uint64_t max_bytes);
  RegularFile(std::string path, int descriptor, std::uint64_t size);

  std::string path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

/// Opens a file without ever waiting. An error, which begins with `path`, when it is not there, may
/// not be read, is not a regular file (folder, pipe, device, socket; links are followed) or is
/// larger than `max_bytes`.
Result<RegularFile> open_regular_file(const std::string& path,
                                      std::uint64_t max_bytes = k_any_size);

/// All bytes of such a file; an error too when there is not enough memory for them.
Result<std::vector<std::uint8_t>> read_regular_file(const std::string& path,
                                                    std::uint64_t max_bytes = k_any_size);

/// The same as text, without a look at its characters.
Result<std::string> read_regular_text(const std::string& path,
                                      std::uint64_t max_bytes = k_any_size);

} // namespace openltc
