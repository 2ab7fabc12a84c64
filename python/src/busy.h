// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Work of the library for a thread of Python, and the end of the interpreter. A thread that asks
// for the interpreter's lock when there is no interpreter any more is ended where it stands, which
// C++ does not survive. So the end waits for such work, which is stopped as by Ctrl-C.

#pragma once

#include <nanobind/nanobind.h>
#include <thread>

namespace openltc::python {

/// As long as it exists a thread of Python is at work here.
class Busy {
public:
  /// Called with the interpreter's lock. Throws SystemExit when the interpreter is about to end.
  Busy();
  ~Busy();
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

  /// Whether the interpreter is about to end, by another thread than the one at work. From any
  /// thread.
  bool must_stop() const;

private:
  std::thread::id thread_;
};

/// The same without the interpreter's lock, so that other threads go on.
class Outside {
  Busy busy_; // still so when the lock is asked for again
  nanobind::gil_scoped_release others_may_run_;
};

/// Has the interpreter wait at its end.
void wait_at_exit();

} // namespace openltc::python
