// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/process/progress_bar.h"

#include "cli/process/message.h"

#include <fmt/format.h>

#include <unistd.h>
#include <utility>

namespace openltc::cli {

namespace {

std::string duration(double seconds) {
  if (seconds < 60) return fmt::format("{:.1f} s", seconds);
  const int whole = int(seconds + 0.5);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

} // namespace

ProgressBar::ProgressBar(std::string label, bool quiet)
    : label_(std::move(label)), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()), last_print_(start_) {}

ProgressBar::~ProgressBar() {
  if (!quiet_) print(share_, true);
}

Progress ProgressBar::progress() {
  return [this](double share) {
    show(share);
    return true;
  };
}

void ProgressBar::show(double share) {
  share_ = share;
  if (quiet_) return;
  const auto now = std::chrono::steady_clock::now();
  if (terminal_) {
    if (now - last_print_ < std::chrono::milliseconds(100)) return;
  } else {
    const int quarter = int(4 * share);
    if (quarter <= quarter_ || quarter >= 4) return;
    if (now - start_ < std::chrono::seconds(2)) return; // short work needs no lines
    quarter_ = quarter;
  }
  last_print_ = now;
  print(share, false);
}

void ProgressBar::print(double share, bool last) {
  const double elapsed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  if (last) {
    say("{}{}: {} in {}{}\n", terminal_ ? "\r" : "", label_, share >= 1 ? "done" : "stopped",
        duration(elapsed), terminal_ ? "\033[K" : "");
  } else {
    const double left = share > 0 ? elapsed * (1 - share) / share : 0;
    if (terminal_) {
      const int filled = int(share * 30);
      say("\r{} [{:=<{}}{:>{}}] {:3.0f} %, {} left\033[K", label_, "", filled, "", 30 - filled,
          100 * share, duration(left));
    } else {
      say("{}: {:.0f} %, about {} left\n", label_, 100 * share, duration(left));
    }
  }
}

} // namespace openltc::cli
