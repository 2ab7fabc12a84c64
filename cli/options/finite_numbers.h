// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Numbers on the command line are numbers.

#pragma once

#include <CLI/CLI.hpp>

namespace openltc::cli {

/// Makes every option of this command and of its sub-commands that takes numbers refuse NaN,
/// infinity and what is too large for one: CLI11's own ranges let NaN pass. To be called when all
/// options are there.
void require_finite_numbers(CLI::App& app);

} // namespace openltc::cli
