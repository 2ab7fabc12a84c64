// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// All of the library's parallelism. Results never depend on the number of threads: each index is
// worked on alone, and what it writes belongs to it.

#pragma once

#include <cstdint>
#include <functional>

namespace openltc {

/// Calls body(i) once for each i in [0, count), in any order, on at most `threads` threads
/// (0 = all cores).
void parallel_for(std::int64_t count, int threads, const std::function<void(std::int64_t)>& body);

} // namespace openltc
