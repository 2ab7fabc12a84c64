// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Whether lobes that come from outside are lobes: M^-1 with a positive determinant everywhere.

#pragma once

#include "openltc/base/result.h"
#include "openltc/table/lobe_polynomial.h"
#include "openltc/table/lobe_table.h"

#include <string>

namespace openltc::table {

/// Refuses a table with a node whose lobe has no positive determinant; the error begins with
/// `name`.
Status check_determinants(const LobeTable& table, const std::string& name);

/// Refuses a polynomial whose lobe has no positive determinant somewhere on a fine grid over its
/// domain; the error begins with `name`.
Status check_determinants(const LobePolynomial& polynomial, const std::string& name);

} // namespace openltc::table
