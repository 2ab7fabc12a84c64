// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Long work beside the interpreter. The work runs on a thread of its own, and on those that it
// takes from the library's pool, while the calling thread waits without the interpreter's lock, so
// that the caller's other threads go on. All that needs the interpreter happens in the calling
// thread: the caller's own function, the progress, and Ctrl-C, which is looked for all the while.

#pragma once

#include "openltc/base/progress.h"
#include "openltc/base/result.h"
#include "python/src/busy.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <nanobind/nanobind.h>
#include <optional>
#include <stdexcept>
#include <utility>

namespace openltc::python {

/// openltc.Error: what the tool would have said.
class ToolError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Takes a value out of a Result, or throws its error.
template <class T> T take(Result<T>&& result) {
  if (!result) throw ToolError(result.error().message);
  return std::move(*result);
}

/// One piece of long work.
class Job {
public:
  /// `progress` is None or a function of the share that is done, 0..1. Throws as Busy does.
  explicit Job(nanobind::object progress);

  /// Calls `work` on another thread and returns when it has ended. The calling thread has the
  /// interpreter's lock. Throws what the interpreter raised in the meantime, or what `work` threw.
  void run(const std::function<void()>& work);

  /// The library's view of this job. From any thread.
  Progress progress();

  /// Throws std::runtime_error when the job is being stopped, for work that is not asked. From any
  /// thread.
  void stop_here() const;

  /// Has `task`, which may use the interpreter, done by the calling thread of run(). From `work`
  /// and its threads. False, and not done, when the job is being stopped, or stops because of it.
  bool call(const std::function<void()>& task);

private:
  struct Request {
    const std::function<void()>* task;
    bool finished = false, done = false;
  };

  void serve(std::unique_lock<std::mutex>& lock);
  void keep_error();
  void look_around();
  bool is_stopped() const { return stopped_ || busy_.must_stop(); }

  Busy busy_;
  nanobind::object report_;
  double reported_ = -1;
  std::atomic<double> share_{0};
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;
  std::condition_variable wanted_, answered_;
  std::deque<Request*> requests_;
  bool ended_ = false;
  std::optional<nanobind::python_error> error_;
};

} // namespace openltc::python
