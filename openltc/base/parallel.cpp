// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <thread>

namespace openltc {

void parallel_for(std::int64_t count, int threads, const std::function<void(std::int64_t)>& body) {
  const auto work = [&] {
    tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, count, 1),
                      [&](const tbb::blocked_range<std::int64_t>& range) {
                        for (std::int64_t i = range.begin(); i != range.end(); ++i)
                          body(i);
                      });
  };
  if (threads <= 0) return work();
  // More threads than cores would only be refused, with a warning, by oneTBB.
  const int cores = std::max(int(std::thread::hardware_concurrency()), 1);
  tbb::task_arena arena(std::min(threads, cores));
  arena.execute(work);
}

int thread_count() { return tbb::this_task_arena::max_concurrency(); }

} // namespace openltc
