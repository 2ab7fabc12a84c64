// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/progress.h"

#include "openltc/base/message.h"

#include <fmt/format.h>

#include <algorithm>
#include <unistd.h>

namespace openltc {

namespace {

std::string duration(double seconds) {
  if (seconds < 60) return fmt::format("{:.1f} s", seconds);
  const int whole = int(seconds + 0.5);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

} // namespace

Progress::Progress(std::string label, std::int64_t total, bool quiet)
    : label_(std::move(label)), total_(std::max<std::int64_t>(total, 1)), quiet_(quiet),
      terminal_(isatty(2) != 0), start_(std::chrono::steady_clock::now()), last_print_(start_) {}

Progress::~Progress() {
  if (!quiet_) print(done_.load(), true);
}

void Progress::add(std::int64_t amount) {
  const std::int64_t done = done_.fetch_add(amount) + amount;
  if (quiet_) return;
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock.owns_lock()) return;
  const auto now = std::chrono::steady_clock::now();
  if (terminal_) {
    if (now - last_print_ < std::chrono::milliseconds(100)) return;
  } else {
    const int quarter = int(4 * done / total_);
    if (quarter <= quarter_ || quarter >= 4) return;
    if (now - start_ < std::chrono::seconds(2)) return; // short work needs no lines
    quarter_ = quarter;
  }
  last_print_ = now;
  print(done, false);
}

void Progress::print(std::int64_t done, bool last) {
  const double elapsed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const double part = std::min(double(done) / double(total_), 1.0);
  if (last) {
    say("{}{}: {} in {}{}\n", terminal_ ? "\r" : "", label_, done >= total_ ? "done" : "stopped",
        duration(elapsed), terminal_ ? "\033[K" : "");
  } else {
    const double left = part > 0 ? elapsed * (1 - part) / part : 0;
    if (terminal_) {
      const int filled = int(part * 30);
      say("\r{} [{:=<{}}{:>{}}] {:3.0f} %, {} left\033[K", label_, "", filled, "", 30 - filled,
          100 * part, duration(left));
    } else {
      say("{}: {:.0f} %, about {} left\n", label_, 100 * part, duration(left));
    }
  }
}

} // namespace openltc
