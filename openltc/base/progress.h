// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Progress of a long job on stderr.

#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace openltc {

/// A bar with an estimate of the time left when stderr is a terminal; otherwise a line for each
/// quarter of the work. Silent when `quiet`. add() may be called from any thread.
class Progress {
public:
  Progress(std::string label, std::int64_t total, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void add(std::int64_t amount);

private:
  void print(std::int64_t done, bool last);

  std::string label_;
  std::int64_t total_;
  bool quiet_;
  bool terminal_;
  std::atomic<std::int64_t> done_{0};
  std::mutex mutex_;
  std::chrono::steady_clock::time_point start_, last_print_;
  int quarter_ = 0;
};

} // namespace openltc
