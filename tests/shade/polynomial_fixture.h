// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A polynomial of any degree to test with: least squares to the nodes of a table.

#pragma once

#include "openltc/table/lobe_polynomial.h"

namespace openltc::testing {

/// Fits every channel by itself. Close to the table's lobes, though a joint fit to the BRDF is
/// closer to that.
table::LobePolynomial polynomial_of_table(const table::LobeTable& table, int degree);

} // namespace openltc::testing
