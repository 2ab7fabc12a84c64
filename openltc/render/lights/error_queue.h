// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A queue that gives the entry with the largest error, as nearly as matters.

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace openltc::render {

/// Entries with a member `error`, not negative, by that: one of the largest to within a quarter
/// comes out first, of equal ones the last to come in. In buckets, since a heap of thousands of
/// entries costs more than all that is done with them.
template <class Entry> class ErrorQueue {
public:
  bool empty() const { return count_ == 0; }
  std::size_t size() const { return count_; }

  void clear() {
    for (std::size_t bucket = 0; bucket <= highest_; ++bucket)
      heads_[bucket] = k_none;
    highest_ = 0;
    count_ = 0;
    slots_.clear();
    free_ = k_none;
  }

  void push(const Entry& entry) {
    std::uint32_t slot = free_;
    if (slot == k_none) {
      slot = std::uint32_t(slots_.size());
      slots_.emplace_back();
    } else {
      free_ = slots_[slot].next;
    }
    const std::size_t bucket = bucket_of(entry.error);
    slots_[slot] = {entry, heads_[bucket]};
    heads_[bucket] = slot;
    highest_ = std::max(highest_, bucket);
    ++count_;
  }

  /// Not of an empty queue.
  Entry pop() {
    while (heads_[highest_] == k_none)
      --highest_;
    const std::uint32_t slot = heads_[highest_];
    heads_[highest_] = slots_[slot].next;
    slots_[slot].next = free_;
    free_ = slot;
    --count_;
    return slots_[slot].entry;
  }

  /// In the order in which they would come out.
  template <class Visit> void for_each(const Visit& visit) const {
    for (std::size_t bucket = highest_ + 1; bucket-- > 0;)
      for (std::uint32_t slot = heads_[bucket]; slot != k_none; slot = slots_[slot].next)
        visit(slots_[slot].entry);
  }

private:
  static constexpr std::uint32_t k_none = 0xffffffffu;
  // The exponent of a float and the first two bits behind its point.
  static constexpr std::size_t k_buckets = 1024;
  static std::size_t bucket_of(float error) {
    std::uint32_t bits = 0;
    static_assert(sizeof(bits) == sizeof(error));
    std::memcpy(&bits, &error, sizeof(bits));
    return (bits >> 21) & (k_buckets - 1);
  }

  struct Slot {
    Entry entry;
    std::uint32_t next;
  };
  static constexpr std::array<std::uint32_t, k_buckets> no_heads() {
    std::array<std::uint32_t, k_buckets> heads{};
    for (std::uint32_t& head : heads)
      head = k_none;
    return heads;
  }
  std::vector<Slot> slots_;
  std::array<std::uint32_t, k_buckets> heads_ = no_heads();
  std::size_t highest_ = 0, count_ = 0;
  std::uint32_t free_ = k_none;
};

} // namespace openltc::render
