// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A file of lobes that a fit is compared with.

#pragma once

#include "openltc/base/result.h"
#include "openltc/fit/report/report.h"

#include <string>

namespace openltc::fit {

/// Reads a table of any layout, or a polynomial, as a candidate of a report, which owns it. A bare
/// texture is read as what it most probably is (identify), and `note` says so. The error names
/// the file.
Result<Candidate> read_candidate(const std::string& path, std::string& note);

} // namespace openltc::fit
