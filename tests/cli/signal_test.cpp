// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What POSIX signals leave behind, in processes of their own.

#include "cli/process/ending.h"
#include "cli/process/file_watch.h"
#include "openltc/base/atomic_file.h"
#include "openltc/base/file_observer.h"
#include "openltc/base/temporary_file.h"
#include "tests/base/folder.h"

#include <doctest/doctest.h>

#include <csignal>
#include <functional>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace openltc;
using namespace openltc::cli;
using openltc::test::Folder;
using openltc::test::put_text;
using openltc::test::text_of;

namespace {

// How a process ended that did this: -signal or its exit code.
int end_of(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGINT})
      std::signal(signal, SIG_DFL); // doctest has handlers of its own
    const rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    if (freopen("/dev/null", "w", stderr) == nullptr) _exit(126);
    work();
    _exit(0);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

} // namespace

TEST_CASE("every_signal_that_ends_the_process_removes_what_is_unfinished_and_ends_it") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGALRM, SIGUSR1, SIGUSR2,
                           SIGABRT, SIGSEGV, SIGBUS}) {
    CAPTURE(signal);
    const Folder folder;
    const std::string path = folder.file("x");
    put_text(path, "old");
    const int end = end_of([&] {
      end_cleanly_on_signals();
      watch_files();
      assume_plain_file_system(true); // where the unfinished file has a name
      (void)write_atomically(path, [&](const std::string& temporary) -> Status {
        put_text(temporary, "half");
        if (folder.file_count() != 2) _exit(125);
        ::raise(signal);
        return Success{};
      });
    });
    CHECK(end == -signal);
    CHECK(text_of(path) == "old");
    CHECK(folder.file_count() == 1);
  }
}

TEST_CASE("even_sigkill_leaves_nothing_where_files_need_no_name") {
  const Folder folder;
  const int end = end_of([&] {
    (void)write_atomically(folder.file("x"), [&](const std::string& temporary) -> Status {
      put_text(temporary, "half");
      if (folder.file_count() != 0) _exit(125); // this file system must name its files
      ::raise(SIGKILL);
      return Success{};
    });
  });
  if (end == 125) {
    MESSAGE("skipped: the file system has no files without a name");
    return;
  }
  CHECK(end == -SIGKILL);
  CHECK(folder.file_count() == 0);
}

TEST_CASE("a_signal_waits_for_what_is_undivided") {
  const Folder folder;
  const int end = end_of([&] {
    end_cleanly_on_signals();
    watch_files();
    {
      const Undivided undivided;
      ::raise(SIGTERM);
      ::raise(SIGINT);
      put_text(folder.file("first"), "1");
      { const Undivided nested; }
      put_text(folder.file("second"), "2");
    }
    put_text(folder.file("third"), "3");
  });
  CHECK(end == -SIGTERM); // the first one
  CHECK(folder.file_count() == 2);
}

TEST_CASE("signals_that_the_parent_ignores_stay_ignored") {
  CHECK(end_of([] {
          std::signal(SIGHUP, SIG_IGN); // nohup
          end_cleanly_on_signals();
          watch_files();
          ::raise(SIGHUP);
        }) == 0);
}

TEST_CASE("the_limit_of_file_size_and_a_broken_pipe_are_errors_of_the_write") {
  const Folder folder;
  put_text(folder.file("x"), "old");
  const int end = end_of([&] {
    end_cleanly_on_signals();
    watch_files();
    const rlimit limit = {1000, 1000};
    setrlimit(RLIMIT_FSIZE, &limit);
    const Status status = write_atomically(folder.file("x"), [](const std::string& temporary) {
      std::ofstream file(temporary, std::ios::binary);
      file << std::string(5000, 'x');
      file.close();
      return file ? Status(Success{}) : Status(Error{"too large"});
    });
    int pipe_ends[2];
    if (status.ok() || ::pipe(pipe_ends) != 0) _exit(1);
    ::close(pipe_ends[0]);
    _exit(::write(pipe_ends[1], "x", 1) < 0 && errno == EPIPE ? 42 : 2);
  });
  CHECK(end == 42);
  CHECK(text_of(folder.file("x")) == "old");
  CHECK(folder.file_count() == 1);
}
