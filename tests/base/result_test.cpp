// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/result.h"

#include <doctest/doctest.h>

#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace openltc;

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

// What a process says on standard error that aborts by doing this; "" when it does not abort.
template <class Work> std::string last_words_of(const Work& work) {
  std::FILE* words = std::tmpfile();
  REQUIRE(words != nullptr);
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGABRT, SIG_DFL); // doctest has a handler of its own
    const rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    dup2(fileno(words), STDERR_FILENO);
    work();
    _exit(0);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  std::rewind(words);
  std::string text;
  for (int c; (c = std::fgetc(words)) != EOF;)
    text += char(c);
  std::fclose(words);
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT ? text : "";
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
