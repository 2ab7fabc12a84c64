// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// How a long job says how far it is, and is asked to stop.

#pragma once

#include "openltc/base/parallel.h"
#include "openltc/base/result.h"

#include <atomic>
#include <cstdint>
#include <functional>

namespace openltc {

/// Called with the share of a job that is done, rising from 0 to 1, from any thread, one call at a
/// time; false asks the job to stop, which then fails with cancelled(). Empty: nobody asks. It must
/// not throw.
using Progress = std::function<bool(double share)>;

/// The error of a job that was asked to stop.
Error cancelled();

/// For a part of a job, from the share `begin` to `end` of the whole.
Progress part_of(Progress whole, double begin, double end);

/// Counts the steps of one job, whose threads all have it, and tells its Progress of them.
class ProgressCount {
public:
  /// `steps` make the whole job.
  ProgressCount(std::int64_t steps, Progress progress);

  /// `steps` more are done. From any thread.
  void add(std::int64_t steps);
  /// Whether the job was asked to stop: what is left to do may be left out. From any thread.
  bool is_cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

private:
  Progress progress_;
  std::int64_t steps_, done_ = 0;
  std::atomic<bool> cancelled_{false};
  Mutex mutex_;
};

} // namespace openltc
