// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What a function returns that can fail: its value, or one line for the user.

#pragma once

#include <string>
#include <utility>
#include <variant>

namespace openltc {

/// One clear line for the user: which file, which field, what to do.
struct Error {
  std::string message;
};

namespace result {

/// What a program that takes what a Result has not comes to, in every build: one line on standard
/// error, and an abort.
[[noreturn]] void end_without_value(const char* message) noexcept;
[[noreturn]] void end_without_error() noexcept;

} // namespace result

/// Either a value or an Error. Test it, then take value() or error(); to take the one that is not
/// there ends the program with a message.
template <class T> class [[nodiscard]] Result {
public:
  Result(T value) : state_(std::move(value)) {}
  Result(Error error) : state_(std::move(error)) {}

  explicit operator bool() const { return state_.index() == 0; }
  bool ok() const { return state_.index() == 0; }

  T& value() {
    if (!ok()) result::end_without_value(error().message.c_str());
    return *std::get_if<0>(&state_);
  }
  const T& value() const {
    if (!ok()) result::end_without_value(error().message.c_str());
    return *std::get_if<0>(&state_);
  }
  T& operator*() { return value(); }
  const T& operator*() const { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Error& error() const {
    if (ok()) result::end_without_error();
    return *std::get_if<1>(&state_);
  }

private:
  std::variant<T, Error> state_;
};

/// The result of an action without a value: Success{} or an Error.
struct Success {};
using Status = Result<Success>;

} // namespace openltc
