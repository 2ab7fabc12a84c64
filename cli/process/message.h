// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Words for the user on standard error. That it cannot be written (closed, a full disk, nobody at
// the other end of a pipe) is no reason to lose the work: fmt::print(stderr, ...) would throw.

#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace openltc::cli {

/// Writes `text` to standard error as it is. What cannot be written is dropped.
void say_text(std::string_view text) noexcept;

/// The same with fmt's formatting.
template <class... T> void say(fmt::format_string<T...> format, T&&... values) {
  say_text(fmt::format(format, std::forward<T>(values)...));
}

} // namespace openltc::cli
