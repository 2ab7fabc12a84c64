// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "python/src/job.h"

#include <chrono>
#include <exception>
#include <thread>

namespace openltc::python {

namespace nb = nanobind;

namespace {

// How soon Ctrl-C is noticed, and how often progress is told.
constexpr auto k_look_around = std::chrono::milliseconds(50);

} // namespace

Job::Job(nb::object progress) : report_(std::move(progress)) {}

Progress Job::progress() {
  return [this](double share) {
    share_ = share;
    return !is_stopped();
  };
}

void Job::stop_here() const {
  if (is_stopped()) throw std::runtime_error("the job was stopped");
}

bool Job::call(const std::function<void()>& task) {
  Request request{&task};
  std::unique_lock lock(mutex_);
  if (is_stopped()) return false;
  requests_.push_back(&request);
  wanted_.notify_one();
  answered_.wait(lock, [&] { return request.finished; });
  return request.done;
}

// Of the error that was raised first.
void Job::keep_error() {
  stopped_ = true;
  nb::python_error error;
  if (!error_) error_.emplace(std::move(error));
}

void Job::look_around() {
  if (PyErr_CheckSignals() != 0) return keep_error();
  const double share = share_;
  if (report_.is_none() || share == reported_ || stopped_) return;
  reported_ = share;
  try {
    report_(share);
  } catch (nb::python_error& e) {
    e.restore();
    keep_error();
  }
}

// With the interpreter and the lock: does what was asked for.
void Job::serve(std::unique_lock<std::mutex>& lock) {
  while (!requests_.empty()) {
    Request* request = requests_.front();
    requests_.pop_front();
    if (!stopped_) {
      lock.unlock();
      try {
        (*request->task)();
        request->done = true;
      } catch (nb::python_error& e) {
        e.restore();
        keep_error();
      } catch (const std::exception& e) { // e.g. an array of another type
        PyErr_SetString(PyExc_TypeError, e.what());
        keep_error();
      }
      lock.lock();
    }
    request->finished = true;
    answered_.notify_all();
  }
}

void Job::run(const std::function<void()>& work) {
  std::exception_ptr failure;
  std::thread worker([&] {
    try {
      work();
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    ended_ = true;
    wanted_.notify_one();
  });
  auto looked = std::chrono::steady_clock::now();
  for (bool ended = false; !ended;) {
    {
      const nb::gil_scoped_release without_interpreter;
      std::unique_lock lock(mutex_);
      wanted_.wait_for(lock, k_look_around, [&] { return ended_ || !requests_.empty(); });
      ended = ended_;
    }
    {
      std::unique_lock lock(mutex_);
      serve(lock);
    }
    const auto now = std::chrono::steady_clock::now();
    if (now - looked >= k_look_around || ended) {
      look_around();
      looked = now;
    }
  }
  worker.join();
  if (error_) throw *std::exchange(error_, std::nullopt);
  if (failure && busy_.must_stop()) { // it is our doing
    PyErr_SetNone(PyExc_SystemExit);
    throw nb::python_error();
  }
  if (failure) std::rethrow_exception(failure);
}

} // namespace openltc::python
