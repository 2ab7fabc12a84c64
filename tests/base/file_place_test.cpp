// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/file_place.h"
#include "tests/base/folder.h"

#include <doctest/doctest.h>

#include <filesystem>

using namespace openltc;
using openltc::test::Folder;
using openltc::test::put_text;
namespace fs = std::filesystem;

TEST_CASE("a_place_is_the_same_however_it_is_spelled") {
  const Folder folder;
  fs::create_directory(folder.file("deep"));
  fs::create_directory_symlink("deep", folder.file("link"));
  put_text(folder.file("deep/x"), "x");
  fs::create_hard_link(folder.file("deep/x"), folder.file("hard"));
  fs::create_symlink("deep/x", folder.file("soft"));
  fs::create_symlink("deep/new", folder.file("dangling"));
  const FilePlace there = place_of(folder.file("deep/x")),
                  to_be = place_of(folder.file("deep/new"));
  for (const char* name : {"link/x", "deep/../deep/./x", "hard", "soft", "deep//x"}) {
    CAPTURE(name);
    CHECK(place_of(folder.file(name)) == there);
  }
  for (const char* name : {"link/new", "deep/../deep/./new", "dangling"}) {
    CAPTURE(name);
    CHECK(place_of(folder.file(name)) == to_be);
  }
  CHECK(there != to_be);
  CHECK(to_be != place_of(folder.file("new")));
  CHECK(to_be != place_of(folder.file("deep/newer")));

  const fs::path before = fs::current_path();
  fs::current_path(folder.file("deep"));
  CHECK(place_of("x") == there);
  CHECK(place_of("./new") == to_be);
  fs::current_path(before);
}
