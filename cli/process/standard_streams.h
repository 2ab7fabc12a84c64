// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Standard output and the three descriptors that a process starts with, whatever they are.

#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace openltc::cli {

/// Gives the descriptors 0, 1 and 2 a place, where the parent has closed them: the next file that
/// is opened would take theirs, and messages would go into it. To be called first of all. Reading
/// and writing them still fails.
void open_standard_streams();

/// Writes to standard output. What fails is remembered for finish_standard_output.
void put_text(std::string_view text) noexcept;

/// The same with fmt's formatting.
template <class... T> void put(fmt::format_string<T...> format, T&&... values) {
  put_text(fmt::format(format, std::forward<T>(values)...));
}

/// The exit code of a command that ended with `exit_code`: a failure where any of its standard
/// output was lost, and then one line says so. Where nobody reads the pipe any more the process
/// ends by SIGPIPE, as other tools do. To be called last of all.
int finish_standard_output(int exit_code);

} // namespace openltc::cli
