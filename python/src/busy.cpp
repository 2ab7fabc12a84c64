// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "python/src/busy.h"

#include <atomic>
#include <chrono>
#include <pthread.h>

namespace openltc::python {

namespace nb = nanobind;

namespace {

// A function of the caller's may be in the middle of something that never ends.
constexpr auto k_longest_wait = std::chrono::seconds(10);

std::atomic<int> at_work{0};
std::atomic<bool> ending{false};
std::thread::id ended_by; // written before `ending`

// What runs at exit: others are in the middle of something, and have to get the lock to end it.
void wait_for_all() {
  ended_by = std::this_thread::get_id();
  ending = true;
  const nb::gil_scoped_release others_may_run;
  const auto until = std::chrono::steady_clock::now() + k_longest_wait;
  while (at_work > 0 && std::chrono::steady_clock::now() < until)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

} // namespace

Busy::Busy() : thread_(std::this_thread::get_id()) {
  if (must_stop()) {
    PyErr_SetNone(PyExc_SystemExit);
    throw nb::python_error();
  }
  ++at_work;
}

Busy::~Busy() { --at_work; }

bool Busy::must_stop() const { return ending && thread_ != ended_by; }

void wait_at_exit() {
  nb::module_::import_("atexit").attr("register")(nb::cpp_function(&wait_for_all));
  // A child by fork() has the thread that called it alone.
  pthread_atfork(nullptr, nullptr, [] { at_work = 0; });
}

} // namespace openltc::python
