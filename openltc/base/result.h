// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What a function returns that can fail: its value, or one line for the user.

#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace openltc {

/// One clear line for the user: which file, which field, what to do.
struct Error {
  std::string message;
};

/// Either a value or an Error. Test it, then take value() or error().
template <class T> class [[nodiscard]] Result {
public:
  Result(T value) : state_(std::move(value)) {}
  Result(Error error) : state_(std::move(error)) {}

  explicit operator bool() const { return state_.index() == 0; }
  bool ok() const { return state_.index() == 0; }

  T& value() {
    assert(ok());
    return std::get<0>(state_);
  }
  const T& value() const {
    assert(ok());
    return std::get<0>(state_);
  }
  T& operator*() { return value(); }
  const T& operator*() const { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Error& error() const {
    assert(!ok());
    return std::get<1>(state_);
  }

private:
  std::variant<T, Error> state_;
};

/// The result of an action without a value: Success{} or an Error.
struct Success {};
using Status = Result<Success>;

} // namespace openltc
