// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// All of the library's parallelism: no other file starts a thread or includes oneTBB. Results never
// depend on the number of threads: each index is worked on alone, and what it writes belongs to it.

#pragma once

#include <cstdint>
#include <functional>
#include <mutex>

namespace openltc {

/// Calls body(i) once for each i in [0, count), in any order, on at most `threads` threads; 0 = all
/// that the caller may use: the cores, or fewer within the body of another parallel_for or an arena
/// of oneTBB. An exception of the body is thrown here, when no other index is worked on any more.
void parallel_for(std::int64_t count, int threads, const std::function<void(std::int64_t)>& body);

/// The number of threads that parallel_for with 0 uses, the calling one included.
int thread_count();

/// For std::lock_guard. Where there is one thread alone, as in WebAssembly, the standard library
/// may have no mutex, and nothing is to be kept apart.
#ifdef OPENLTC_ONE_THREAD
struct Mutex {
  void lock() {}
  void unlock() {}
};
#else
using Mutex = std::mutex;
#endif

} // namespace openltc
