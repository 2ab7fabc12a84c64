// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// openltc convert of a photometric file.

#pragma once

#include "openltc/base/result.h"

#include <string>

namespace openltc::cli {

/// Writes the photometric file `input`, .ies or .ldt, to `output`, an .ies of LM-63-2002, and says
/// on stderr, unless `quiet`, what was put right.
Status convert_photometry(const std::string& input, const std::string& output, bool quiet);

} // namespace openltc::cli
