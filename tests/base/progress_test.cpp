// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/parallel.h"
#include "openltc/base/progress.h"

#include <doctest/doctest.h>

#include <vector>

using namespace openltc;

TEST_CASE("progress_rises_to_one_from_many_threads") {
  std::vector<double> shares;
  ProgressCount count(1000, [&](double share) {
    shares.push_back(share); // one call at a time
    return true;
  });
  parallel_for(1000, 2, [&](std::int64_t) { count.add(1); });
  REQUIRE(shares.size() == 1000);
  for (std::size_t i = 0; i < shares.size(); ++i)
    CHECK(shares[i] == double(i + 1) / 1000);
  CHECK_FALSE(count.is_cancelled());
}

TEST_CASE("a_job_that_is_asked_to_stop_stops_and_is_not_asked_again") {
  int calls = 0;
  ProgressCount count(10, [&](double share) {
    ++calls;
    return share < 0.25;
  });
  int done = 0;
  for (; done < 10 && !count.is_cancelled(); ++done)
    count.add(1);
  CHECK(done == 3);
  count.add(1);
  CHECK(calls == 3);
}

TEST_CASE("progress_of_parts_covers_the_whole") {
  std::vector<double> shares;
  const Progress whole = [&](double share) {
    shares.push_back(share);
    return share < 1.0;
  };
  ProgressCount first(2, part_of(whole, 0.0, 0.5)), second(1, part_of(whole, 0.5, 1.0));
  first.add(1);
  first.add(1);
  second.add(1);
  CHECK(shares == std::vector<double>{0.25, 0.5, 1.0});
  CHECK_FALSE(first.is_cancelled());
  CHECK(second.is_cancelled());
}

TEST_CASE("progress_that_nobody_asks_for_and_of_nothing_is_fine") {
  ProgressCount silent(3, part_of({}, 0.0, 0.5));
  silent.add(3);
  CHECK_FALSE(silent.is_cancelled());
  double last = -1;
  ProgressCount nothing(0, [&](double share) {
    last = share;
    return true;
  });
  nothing.add(0);
  CHECK(last == 0);
}
