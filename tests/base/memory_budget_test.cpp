// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/memory_budget.h"

#include <doctest/doctest.h>

using namespace openltc;

TEST_CASE("what_is_taken_counts_until_its_owner_ends") {
  MemoryBudget budget(1000);
  {
    MemoryShare first(budget);
    CHECK(first.take(600, "a").ok());
    CHECK(budget.in_use() == 600);
    MemoryShare second(budget);
    CHECK(!second.take(401, "b").ok());
    CHECK(budget.in_use() == 600);
    CHECK(second.take(400, "b").ok());
    CHECK(budget.left() == 0);
    const MemoryShare moved = std::move(second);
    CHECK(moved.bytes() == 400);
    CHECK(budget.in_use() == 1000);
  }
  CHECK(budget.in_use() == 0);
  CHECK(budget.check(1000, "c").ok());
  CHECK(budget.in_use() == 0);
}

TEST_CASE("sums_beyond_64_bits_do_not_fit") {
  MemoryBudget budget(1000);
  MemoryShare share(budget);
  CHECK(share.take(10, "a").ok());
  CHECK(!share.take(std::uint64_t(-1), "b").ok());
  CHECK(!share.take(std::uint64_t(-5), "b").ok());
  budget.set_limit(5); // below what is in use
  CHECK(budget.left() == 0);
  CHECK(!share.take(1, "c").ok());
  CHECK(share.take(0, "d").ok() == false);
}

TEST_CASE("a_refusal_says_who_asks_for_how_much_the_limit_and_the_option") {
  MemoryBudget budget(std::uint64_t(3) << 30);
  MemoryShare share(budget);
  CHECK(share.take(std::uint64_t(1) << 30, "a").ok());
  const Status status = share.take(std::uint64_t(10) << 30, "x.glb: images[0]");
  REQUIRE(!status.ok());
  CHECK(status.error().message ==
        "x.glb: images[0]: asks for 10 GiB of memory, beside 1 GiB in use; the limit for what "
        "files ask is 3 GiB, reduce the file or raise it with --memory");
}

TEST_CASE("the_default_is_no_more_than_half_of_the_machine") {
  CHECK(default_memory_limit() > 0);
  CHECK(default_memory_limit() < std::uint64_t(1) << 60);
}

TEST_CASE("sizes_are_read_as_people_write_them") {
  const auto bytes = [](const char* text) {
    const Result<std::uint64_t> size = parse_memory_size(text);
    return size ? *size : 0;
  };
  CHECK(bytes("100000") == 100000);
  CHECK(bytes("64K") == 65536);
  CHECK(bytes("4G") == std::uint64_t(4) << 30);
  CHECK(bytes("1.5 GiB") == std::uint64_t(3) << 29);
  CHECK(bytes("2gB") == std::uint64_t(2) << 30);
  CHECK(bytes("1T") == std::uint64_t(1) << 40);
  for (const char* wrong : {"", "G", "-1G", "0", "nan", "inf", "4X", "4GG", "1e30", "4 G B"}) {
    CAPTURE(wrong);
    CHECK(bytes(wrong) == 0);
  }
}
