// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Options that take a number. CLI11 by itself reads '' as 0 and 010 as eight, and lets a NaN
// through every range.

#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>

namespace openltc::cli {

/// For Option::transform: a whole number in decimal digits, from `least` to `most`.
CLI::Validator whole_number(std::int64_t least, std::int64_t most);

/// For Option::check: a finite number, such as 0.5 or 1e-3, from `least` to `most`.
CLI::Validator number(double least, double most);

} // namespace openltc::cli
