// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Files of lobes: tables and polynomials, told apart by what they say, not by their name.

#pragma once

#include "openltc/base/result.h"
#include "openltc/table/lobe_polynomial.h"
#include "openltc/table/lobe_table.h"

#include <string>
#include <variant>
#include <vector>

namespace openltc::table {

/// What lobes are kept in: a table or polynomials, of one lobe or of two.
enum class LobeForm { table, polynomial, two_lobe, two_lobe_polynomial };

constexpr bool is_polynomial(LobeForm form) {
  return form == LobeForm::polynomial || form == LobeForm::two_lobe_polynomial;
}

/// Whether a file says that it holds a lobe polynomial. It may be broken all the same.
bool is_polynomial_file(const std::string& path);

/// Lobes to shade with.
using ShadingLobes = std::variant<LobeTable, LobePolynomial>;

/// Reads a table of any layout, or a polynomial, to shade with. Errors as read_table and
/// read_polynomial; refuses lobes that the shading kernels would misread: they factor alpha out of
/// the width and interpolate over roughness, so width "one" and a single column are not for them.
/// `notes` gets a line for each thing that the picture's reader should know about them.
Result<ShadingLobes> read_shading_lobes(const std::string& path, std::vector<std::string>& notes);

} // namespace openltc::table
