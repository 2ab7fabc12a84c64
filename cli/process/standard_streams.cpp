// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/process/standard_streams.h"

#include "cli/process/ending.h"
#include "cli/process/exit_code.h"
#include "cli/process/message.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace openltc::cli {

namespace {

bool g_lost = false;
int g_reason = 0; // why something was lost first; 0: nobody noted it

void remember_loss() {
  if (!g_lost) g_reason = errno;
  g_lost = true;
}

} // namespace

void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    // The lowest free descriptor is this one, as those below it are taken. Open the other way
    // round, so that what is lost is noticed.
    const int opened = ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    if (opened >= 0 && opened != stream) ::close(opened);
  }
}

void put_text(std::string_view text) noexcept {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) remember_loss();
}

int finish_standard_output(int exit_code) {
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) remember_loss();
  // Some file systems say only now that the disk is full.
  if (std::fclose(stdout) != 0) remember_loss();
  if (!g_lost) return exit_code;
  if (g_reason == EPIPE && ends_by_broken_pipes()) end_by(SIGPIPE);
  say("openltc: cannot write to standard output{}{}\n", g_reason != 0 ? ": " : "",
      g_reason != 0 ? std::strerror(g_reason) : "");
  return exit_code == k_exit_ok ? k_exit_failed : exit_code;
}

} // namespace openltc::cli
