// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/process/file_watch.h"
#include "cli/process/input_files.h"
#include "openltc/base/file_observer.h"
#include "openltc/base/regular_file.h"
#include "tests/base/folder.h"

#include <doctest/doctest.h>

using namespace openltc;
using namespace openltc::cli;
using openltc::test::Folder;
using openltc::test::put_text;

TEST_CASE("what_was_read_is_remembered_once_the_tool_watches") {
  const Folder folder;
  put_text(folder.file("before"), "x");
  put_text(folder.file("after"), "x");
  REQUIRE(read_regular_text(folder.file("before")).ok());
  CHECK_FALSE(is_input(place_of(folder.file("before"))));
  watch_files();
  REQUIRE(read_regular_text(folder.file("after")).ok());
  CHECK(is_input(place_of(folder.file("./after"))));
  CHECK_FALSE(is_input(place_of(folder.file("before"))));
  file_observer().reads(folder.file("named only"));
  CHECK(is_input(place_of(folder.file("named only"))));
  observe_files(nullptr);
}
