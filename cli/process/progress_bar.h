// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Progress of a long job on stderr.

#pragma once

#include "openltc/base/progress.h"

#include <chrono>
#include <string>

namespace openltc::cli {

/// A bar with an estimate of the time left when stderr is a terminal; otherwise a line for each
/// quarter of the work. Silent when `quiet`.
class ProgressBar {
public:
  ProgressBar(std::string label, bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// For the job; refers to this object. It never asks to stop.
  Progress progress();

private:
  void show(double share);
  void print(double share, bool last);

  std::string label_;
  bool quiet_;
  bool terminal_;
  std::chrono::steady_clock::time_point start_, last_print_;
  double share_ = 0.0;
  int quarter_ = 0;
};

} // namespace openltc::cli
