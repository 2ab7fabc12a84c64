// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/process/ending.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <mutex>
#include <unistd.h>
#include <vector>

namespace openltc::cli {

namespace {

struct Ending {
  int signal;
  const char* name;
  bool is_crash; ///< the instruction would fail again: it cannot wait
};
constexpr Ending k_endings[] = {
    {SIGINT, "SIGINT", false},       {SIGTERM, "SIGTERM", false}, {SIGHUP, "SIGHUP", false},
    {SIGQUIT, "SIGQUIT", false},     {SIGXCPU, "SIGXCPU", false}, {SIGALRM, "SIGALRM", false},
    {SIGVTALRM, "SIGVTALRM", false}, {SIGPROF, "SIGPROF", false}, {SIGUSR1, "SIGUSR1", false},
    {SIGUSR2, "SIGUSR2", false},     {SIGABRT, "SIGABRT", true},  {SIGSEGV, "SIGSEGV", true},
    {SIGBUS, "SIGBUS", true},        {SIGFPE, "SIGFPE", true},    {SIGILL, "SIGILL", true},
    {SIGTRAP, "SIGTRAP", true},      {SIGSYS, "SIGSYS", true},
};

// A handler and the threads that are undivided see each other: each first says what it does and
// then looks at the other. At least one of the two notices, and the later one ends the process.
std::atomic<int> g_ending{0};    // the signal that ends the process
std::atomic<int> g_undivided{0}; // threads that must not be cut in two
std::atomic<bool> g_written{false};
std::atomic<bool> g_pipe_was_default{false};
thread_local int t_depth = 0;

std::mutex& unfinished_mutex() {
  static std::mutex& mutex = *new std::mutex; // a signal may come while the process exits
  return mutex;
}

// Changed by undivided threads only, so that a handler may read it.
std::vector<std::string>& unfinished() {
  static std::vector<std::string>& paths = *new std::vector<std::string>;
  return paths;
}

// One write, so that no other line comes between. No formatting: a handler may interrupt that.
void say_last_words(int signal) {
  char line[128];
  std::size_t length = 0;
  const auto add = [&](const char* words) {
    for (; *words != 0 && length < sizeof line; ++words)
      line[length++] = *words;
  };
  if (isatty(STDERR_FILENO) != 0) add("\r\033[K"); // over a line of progress
  add(signal == SIGINT ? "openltc: interrupted" : "openltc: ended by ");
  for (const Ending& ending : k_endings)
    if (ending.signal == signal && signal != SIGINT) add(ending.name);
  add(g_written.load() ? "\n" : "; nothing was written\n");
  if (::write(STDERR_FILENO, line, length) < 0) return; // nobody is left to tell
}

[[noreturn]] void end_now(int signal) noexcept {
  for (const std::string& path : unfinished())
    ::unlink(path.c_str());
  say_last_words(signal);
  end_by(signal);
}

void on_ending(int signal) {
  int none = 0;
  const bool is_first = g_ending.compare_exchange_strong(none, signal);
  for (const Ending& ending : k_endings)
    if (ending.signal == signal && ending.is_crash) end_now(signal);
  if (is_first && g_undivided.load() == 0) end_now(signal);
}

struct Held {
  Held() noexcept { hold_ending(); }
  ~Held() { release_ending(); }
};

} // namespace

void end_cleanly_on_signals() {
  unfinished(); // made now, not in a handler
  struct sigaction action = {}, old = {};
  action.sa_handler = on_ending;
  action.sa_flags = SA_RESTART;
  sigfillset(&action.sa_mask);
  for (const Ending& ending : k_endings) {
    // Neither what the parent wants ignored nor a debugging tool's own handler.
    if (sigaction(ending.signal, nullptr, &old) == 0 && old.sa_handler == SIG_DFL)
      sigaction(ending.signal, &action, nullptr);
  }
  struct sigaction ignore = {};
  ignore.sa_handler = SIG_IGN;
  if (sigaction(SIGPIPE, &ignore, &old) == 0) g_pipe_was_default.store(old.sa_handler == SIG_DFL);
  sigaction(SIGXFSZ, &ignore, nullptr);
}

bool ends_by_broken_pipes() noexcept { return g_pipe_was_default.load(); }

void end_by(int signal) noexcept {
  struct sigaction standard = {};
  standard.sa_handler = SIG_DFL;
  sigaction(signal, &standard, nullptr);
  sigset_t only;
  sigemptyset(&only);
  sigaddset(&only, signal);
  pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
  ::kill(::getpid(), signal);
  for (int i = 0; i < 100; ++i) // another thread may be the one that it reaches
    ::usleep(10000);
  ::_exit(128 + signal);
}

void hold_ending() noexcept {
  if (t_depth++ > 0) return;
  g_undivided.fetch_add(1);
  const int signal = g_ending.load();
  if (signal == 0) return;
  // The process is ending: by this thread, or by the last one that is undivided.
  if (g_undivided.fetch_sub(1) == 1) end_now(signal);
  for (;;)
    ::pause();
}

void release_ending() noexcept {
  if (--t_depth > 0) return;
  const bool is_last = g_undivided.fetch_sub(1) == 1;
  const int signal = g_ending.load();
  if (signal != 0 && is_last) end_now(signal);
}

void remember_unfinished(const std::string& path) {
  const Held held;
  const std::lock_guard lock(unfinished_mutex());
  unfinished().push_back(path);
}

void forget_unfinished(const std::string& path) noexcept {
  const Held held;
  const std::lock_guard lock(unfinished_mutex());
  auto& paths = unfinished();
  paths.erase(std::remove(paths.begin(), paths.end(), path), paths.end());
}

void note_written() noexcept { g_written.store(true); }

} // namespace openltc::cli
