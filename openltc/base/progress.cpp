// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/progress.h"

#include <algorithm>
#include <mutex>
#include <utility>

namespace openltc {

Error cancelled() { return Error{"cancelled"}; }

Progress part_of(Progress whole, double begin, double end) {
  if (!whole) return {};
  return [whole = std::move(whole), begin, end](double share) {
    return whole(share < 1.0 ? begin + share * (end - begin) : end);
  };
}

ProgressCount::ProgressCount(std::int64_t steps, Progress progress)
    : progress_(std::move(progress)), steps_(std::max<std::int64_t>(steps, 1)) {}

void ProgressCount::add(std::int64_t steps) {
  if (!progress_) return;
  const std::lock_guard lock(mutex_);
  done_ += steps;
  const double share = std::min(double(done_) / double(steps_), 1.0);
  if (!is_cancelled() && !progress_(share)) cancelled_.store(true, std::memory_order_relaxed);
}

} // namespace openltc
