// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// For tests of what must end a program.

#pragma once

#include <doctest/doctest.h>

#include <csignal>
#include <cstdio>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace openltc::test {

/// What a process says on standard error that aborts by doing this; "" when it does not abort.
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

} // namespace openltc::test
