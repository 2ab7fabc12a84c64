// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A file of lobes that a fit is compared with.

#pragma once

#include "openltc/fit/report.h"

#include <string>

namespace openltc::cli {

/// Reads a table of any layout, or a polynomial, as a candidate of a report, which owns it. A bare
/// texture is read as what it most probably is (fit::identify), and `note` says so.
Result<fit::Candidate> read_candidate(const std::string& path, std::string& note);

} // namespace openltc::cli
