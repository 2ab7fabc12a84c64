// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc/base/parallel.h where there are no threads, instead of parallel.cpp.

#include "openltc/base/parallel.h"

namespace openltc {

void parallel_for(std::int64_t count, int, const std::function<void(std::int64_t)>& body) {
  for (std::int64_t i = 0; i < count; ++i)
    body(i);
}

int thread_count() { return 1; }

} // namespace openltc
