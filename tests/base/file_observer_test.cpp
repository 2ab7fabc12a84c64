// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/atomic_file.h"
#include "openltc/base/file_observer.h"
#include "openltc/base/regular_file.h"
#include "openltc/base/temporary_file.h"
#include "tests/base/folder.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace openltc;
using openltc::test::Folder;
using openltc::test::put_text;

namespace {

struct Notes : FileObserver {
  std::multiset<std::string> read, unfinished;
  int depth = 0, deepest = 0, made = 0, written = 0;
  bool divided = false; // something changed outside of begins and ends

  void reads(const std::string& path) override { read.insert(path); }
  void begins_undivided() noexcept override { deepest = std::max(deepest, ++depth); }
  void ends_undivided() noexcept override { --depth; }
  void makes_unfinished(const std::string& path) override {
    divided = divided || depth == 0;
    unfinished.insert(path);
    ++made;
  }
  void ends_unfinished(const std::string& path) noexcept override {
    divided = divided || depth == 0;
    unfinished.erase(path);
  }
  void has_written() noexcept override { ++written; }
};

struct Observed {
  Notes notes;
  Observed() { observe_files(&notes); }
  ~Observed() { observe_files(nullptr); }
};

} // namespace

TEST_CASE("an_observer_is_told_what_is_read") {
  const Folder folder;
  put_text(folder.file("before"), "x");
  put_text(folder.file("after"), "x");
  REQUIRE(read_regular_text(folder.file("before")).ok());
  {
    const Observed observed;
    REQUIRE(read_regular_text(folder.file("after")).ok());
    CHECK_FALSE(read_regular_text(folder.file("missing")).ok());
    CHECK(observed.notes.read == std::multiset<std::string>{folder.file("after")});
  }
  REQUIRE(read_regular_text(folder.file("before")).ok()); // nobody observes any more
}

TEST_CASE("an_observer_can_remove_every_unfinished_file_at_any_time") {
  for (const bool fails : {false, true}) {
    const Folder folder;
    put_text(folder.file("x"), "old");
    const Observed observed;
    assume_plain_file_system(true); // where the unfinished file has a name
    const Status status =
        write_atomically(folder.file("x"), [&](const std::string& temporary) -> Status {
          CHECK(observed.notes.unfinished == std::multiset<std::string>{temporary});
          put_text(temporary, "new");
          if (fails) return Error{"no"};
          return Success{};
        });
    assume_plain_file_system(false);
    CHECK(status.ok() == !fails);
    CHECK(observed.notes.made >= 1);
    CHECK(observed.notes.unfinished.empty());
    CHECK_FALSE(observed.notes.divided);
    CHECK(observed.notes.depth == 0);
    CHECK(observed.notes.deepest >= 1);
    CHECK(observed.notes.written == (fails ? 0 : 1));
    CHECK(folder.file_count() == 1);
  }
}
