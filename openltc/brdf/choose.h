// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// From what a user types to a BRDF.

#pragma once

#include "openltc/base/result.h"
#include "openltc/brdf/brdf.h"

#include <string>

namespace openltc::brdf {

/// A built-in BRDF by its name, or a measured one by the path of a MERL file, which ends in
/// .binary. The error lists the names; errors of a file are those of read_merl.
Result<Brdf> choose_brdf(const std::string& name_or_path);

} // namespace openltc::brdf
