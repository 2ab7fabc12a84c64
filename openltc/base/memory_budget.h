// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// How much memory files may ask for. A few bytes of a file can name any size: a picture of 16
// billion pixels, an instance a million times over. Whoever takes memory by the word of a file
// first asks here, so that the answer is a line of text and not the end of the process or of the
// machine. It counts what files ask for, and the picture that is rendered; the program's own needs
// (code, rays) live in the rest of the machine's memory.

#pragma once

#include "openltc/base/result.h"

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace openltc {

/// A limit, and what of it is in use. All functions may be called from any thread.
class MemoryBudget {
public:
  explicit MemoryBudget(std::uint64_t limit_bytes) : limit_(limit_bytes) {}

  std::uint64_t limit() const { return limit_; }
  void set_limit(std::uint64_t bytes) { limit_ = bytes; }
  std::uint64_t in_use() const { return in_use_; }
  std::uint64_t left() const;

  /// Whether `bytes` more would fit. The error begins with `what`, which names file and field, and
  /// says what was asked for, the limit and --memory.
  Status check(std::uint64_t bytes, const std::string& what) const;

  /// Counts them, or fails as check does and counts nothing. See MemoryShare, which gives them
  /// back.
  Status take(std::uint64_t bytes, const std::string& what);
  void give_back(std::uint64_t bytes) { in_use_ -= bytes; }

private:
  Error refusal(std::uint64_t bytes, const std::string& what) const;

  std::atomic<std::uint64_t> limit_;
  std::atomic<std::uint64_t> in_use_{0};
};

/// The one of this process; its limit is default_memory_limit() until something sets another.
MemoryBudget& memory_budget();

/// Half of what this process can have: the least of the machine's memory, the control group's and
/// the resource limit's. Bytes; 4 GiB when none of them is known.
std::uint64_t default_memory_limit();

/// What one owner has of a budget; given back when the owner ends.
class MemoryShare {
public:
  explicit MemoryShare(MemoryBudget& budget = memory_budget()) : budget_(&budget) {}
  MemoryShare(MemoryShare&& other) noexcept : budget_(other.budget_), bytes_(other.bytes_) {
    other.bytes_ = 0;
  }
  MemoryShare& operator=(MemoryShare&& other) noexcept {
    std::swap(budget_, other.budget_);
    std::swap(bytes_, other.bytes_);
    return *this;
  }
  ~MemoryShare() { budget_->give_back(bytes_); }

  Status take(std::uint64_t bytes, const std::string& what) {
    Status status = budget_->take(bytes, what);
    if (status) bytes_ += bytes;
    return status;
  }
  /// What another owner of the same budget has is this one's from now on.
  void take_over(MemoryShare&& other) {
    bytes_ += other.bytes_;
    other.bytes_ = 0;
  }
  std::uint64_t bytes() const { return bytes_; }
  MemoryBudget& budget() const { return *budget_; }

private:
  MemoryBudget* budget_;
  std::uint64_t bytes_ = 0;
};

/// "8G", "512M", "1.5 GiB", "100000": bytes, with K, M, G, T for powers of 1024. Nothing for other
/// texts, for less than 1 byte and for more than 2^60.
Result<std::uint64_t> parse_memory_size(std::string_view text);

/// "1.5 GiB", "20 KiB", "300 bytes".
std::string memory_size_text(std::uint64_t bytes);

} // namespace openltc
