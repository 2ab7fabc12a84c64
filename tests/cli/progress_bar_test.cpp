// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/process/progress_bar.h"
#include "openltc/base/parallel.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <unistd.h>

using namespace openltc;
using namespace openltc::cli;

namespace {

// What is written to stderr while `work` runs; stderr is then no terminal.
template <class Work> std::string written_to_stderr(const Work& work) {
  std::FILE* file = std::tmpfile();
  REQUIRE(file != nullptr);
  std::fflush(stderr);
  const int saved = dup(2);
  dup2(fileno(file), 2);
  work();
  std::fflush(stderr);
  dup2(saved, 2);
  close(saved);
  std::rewind(file);
  std::string text;
  for (int c; (c = std::fgetc(file)) != EOF;)
    text += char(c);
  std::fclose(file);
  return text;
}

void work_of(std::int64_t total, std::int64_t done, bool quiet) {
  ProgressBar bar("baking", quiet);
  ProgressCount count(total, bar.progress());
  parallel_for(done, 2, [&](std::int64_t) { count.add(1); });
}

} // namespace

TEST_CASE("quiet_progress_prints_nothing") {
  CHECK(written_to_stderr([] { work_of(1000, 1000, true); }).empty());
  CHECK(written_to_stderr([] { work_of(0, 0, true); }).empty());
}

TEST_CASE("progress_is_a_few_plain_lines_where_there_is_no_terminal") {
  const std::string text = written_to_stderr([] { work_of(100000, 100000, false); });
  const auto lines = std::count(text.begin(), text.end(), '\n');
  CHECK(lines >= 1);
  CHECK(lines <= 4);
  CHECK(text.find('\r') == std::string::npos);
  CHECK(text.find('\033') == std::string::npos);
  CHECK(text.find("baking: done in ") != std::string::npos);
}

TEST_CASE("progress_that_ends_early_says_so") {
  const std::string text = written_to_stderr([] { work_of(1000, 300, false); });
  CHECK(text.find("baking: stopped") != std::string::npos);
  CHECK(text.find("done") == std::string::npos);
}

TEST_CASE("progress_of_nothing_is_no_reason_to_divide_by_zero") {
  CHECK(written_to_stderr([] { work_of(0, 0, false); }).find("nan") == std::string::npos);
}
