// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/parallel.h"

#include <doctest/doctest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace openltc;

TEST_CASE("each_index_is_worked_on_once_for_any_number_of_threads") {
  for (const int threads : {0, 1, 2, 3, 100}) {
    CAPTURE(threads);
    std::vector<std::atomic<int>> visits(10007);
    parallel_for(std::int64_t(visits.size()), threads,
                 [&](std::int64_t i) { ++visits[std::size_t(i)]; });
    bool once = true;
    for (const std::atomic<int>& n : visits)
      once = once && n == 1;
    CHECK(once);
  }
  parallel_for(0, 2, [](std::int64_t) { FAIL("there is nothing to do"); });
}

TEST_CASE("never_more_threads_than_asked_for") {
  for (const int threads : {1, 2}) {
    std::atomic<int> now{0}, most{0};
    parallel_for(200, threads, [&](std::int64_t) {
      const int n = ++now;
      int seen = most;
      while (n > seen && !most.compare_exchange_weak(seen, n)) {
      }
      std::this_thread::sleep_for(std::chrono::microseconds(100));
      --now;
    });
    CHECK(most <= threads);
  }
}

TEST_CASE("a_loop_in_a_loop_keeps_to_the_threads_of_the_outer_one") {
  parallel_for(1, 1, [&](std::int64_t) {
    CHECK(thread_count() == 1);
    const std::thread::id outer = std::this_thread::get_id();
    std::atomic<int> elsewhere{0}, done{0};
    parallel_for(100, 0, [&](std::int64_t) {
      ++done;
      elsewhere += std::this_thread::get_id() != outer;
    });
    CHECK(done == 100);
    CHECK(elsewhere == 0);
  });
}
