// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/result.h"

#include <cstdio>
#include <cstdlib>

namespace openltc::result {

// As assert: what is left to say before the end of a program that has a mistake.
void end_without_value(const char* message) noexcept {
  std::fprintf(stderr,
               "openltc: value() of a Result that holds an error, which the program did not test: "
               "%s\n",
               message);
  std::abort();
}

void end_without_error() noexcept {
  std::fputs("openltc: error() of a Result that holds a value\n", stderr);
  std::abort();
}

} // namespace openltc::result
