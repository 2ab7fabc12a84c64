// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/process/fingerprint.h"

#include <doctest/doctest.h>

using namespace openltc::cli;

TEST_CASE("fingerprints_are_those_of_the_fnv_test_vectors") {
  // Fowler, Noll, Vo, Eastlake, "The FNV Non-Cryptographic Hash Algorithm", appendix C.
  const auto of = [](const char* text) {
    Fingerprint fingerprint;
    fingerprint.add_bytes(text);
    return fingerprint.text();
  };
  CHECK(of("") == "cbf29ce484222325");
  CHECK(of("a") == "af63dc4c8601ec8c");
  CHECK(of("foobar") == "85944171f73967e8");
}

TEST_CASE("texts_one_after_the_other_are_told_from_their_sum") {
  Fingerprint one, two;
  one.add("ab");
  one.add("c");
  two.add("a");
  two.add("bc");
  CHECK(one.text() != two.text());
}
