// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#pragma once

namespace openltc::cli {

/// Exit codes of the tool.
enum ExitCode { k_exit_ok = 0, k_exit_failed = 1, k_exit_usage = 2 };

} // namespace openltc::cli
