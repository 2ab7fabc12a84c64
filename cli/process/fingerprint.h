// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Whether something is still what it was: a number of 64 bits for any bytes.

#pragma once

#include "openltc/base/regular_file.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace openltc::cli {

/// FNV-1a (Fowler, Noll, Vo), 64 bits: one changed byte always changes it, other changes leave it
/// the same once in 2^64 times. It holds against accidents, not against who wants two files to
/// have one fingerprint.
class Fingerprint {
public:
  /// These bytes come next.
  void add_bytes(std::string_view bytes) {
    std::uint64_t state = state_;
    for (const char c : bytes)
      state = (state ^ std::uint8_t(c)) * 1099511628211u;
    state_ = state;
  }
  /// A text and its length: "ab", "c" is not "a", "bc".
  void add(std::string_view text) {
    add_bytes(fmt::format("{}:", text.size()));
    add_bytes(text);
  }
  /// All bytes of a file. A file that is not there or cannot be read is something to tell from any
  /// other as well, and no error.
  void add_file(const std::string& path) {
    const Result<RegularFile> file = open_regular_file(path);
    if (!file) {
      add("no file");
      return;
    }
    add(fmt::format("{} bytes", file->size()));
    std::vector<std::uint8_t> part(std::size_t(1) << 20);
    for (std::uint64_t at = 0; at < file->size();) {
      const Result<std::size_t> got = file->read_at(at, part);
      if (!got || *got == 0) {
        add("cannot be read");
        return;
      }
      add_bytes({reinterpret_cast<const char*>(part.data()), *got});
      at += *got;
    }
  }

  /// 16 digits, 0 to 9 and a to f.
  std::string text() const { return fmt::format("{:016x}", state_); }

private:
  std::uint64_t state_ = 14695981039346656037u;
};

} // namespace openltc::cli
