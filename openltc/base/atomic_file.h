// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Writing a file so that it is either complete or not there.

#pragma once

#include "openltc/base/result.h"

#include <functional>
#include <string>

namespace openltc {

/// Calls `write` with a temporary path in the same folder as `path` and the same extension, then
/// renames it to `path`. When `write` fails, throws or the process is interrupted through the
/// handlers of this module, the temporary file is removed and an existing `path` is left as it was.
/// The error names `path`.
Status write_atomically(const std::string& path,
                        const std::function<Status(const std::string& temporary)>& write);

/// Removes the temporary files that are being written at this moment. Safe to call from a signal
/// handler.
void remove_temporary_files() noexcept;

} // namespace openltc
