// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/result.h"
#include "tests/base/last_words.h"

#include <doctest/doctest.h>

#include <memory>
#include <string>

using namespace openltc;
using openltc::test::last_words_of;

namespace {

Result<std::unique_ptr<int>> make(int value) {
  if (value < 0) return Error{"value: must not be negative"};
  return std::make_unique<int>(value);
}

Status check(int value) {
  const Result<std::unique_ptr<int>> made = make(value);
  if (!made) return made.error();
  return Success{};
}

} // namespace

TEST_CASE("a_result_is_a_value_or_an_error") {
  Result<std::unique_ptr<int>> good = make(3);
  REQUIRE(good);
  CHECK(good.ok());
  CHECK(**good == 3);
  CHECK(*good->get() == 3);
  const std::unique_ptr<int> moved = std::move(*good); // values that cannot be copied
  CHECK(*moved == 3);
  const Result<std::unique_ptr<int>> bad = make(-1);
  CHECK_FALSE(bad);
  CHECK(bad.error().message == "value: must not be negative");
}

TEST_CASE("errors_pass_on_unchanged") {
  CHECK(check(1).ok());
  CHECK(check(-1).error().message == "value: must not be negative");
}

TEST_CASE("a_result_of_text_tells_its_value_from_its_error") {
  const Result<std::string> value = std::string("text"), error = Error{"text"};
  CHECK(value.ok());
  CHECK_FALSE(error.ok());
}

TEST_CASE("to_take_what_a_result_has_not_ends_the_program_with_a_message") {
  const std::string of_value = last_words_of([] { (void)make(-1).value(); });
  CHECK(of_value.find("value: must not be negative\n") != std::string::npos);
  CHECK(last_words_of([] { (void)*make(-1); }) == of_value);
  CHECK_FALSE(last_words_of([] { (void)make(1).error(); }).empty());
  CHECK(last_words_of([] { (void)make(1).value(); }).empty());
}
