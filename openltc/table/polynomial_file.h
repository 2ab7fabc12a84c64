// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Native files of a lobe polynomial: JSON, which loses nothing, and the C++ source of the built-in.

#pragma once

#include "openltc/base/atomic_file.h"
#include "openltc/base/result.h"
#include "openltc/table/lobe_polynomial.h"

#include <string>

namespace openltc::table {

/// The polynomial as JSON text: metadata, degree and the six coefficients of every term (eleven
/// of two lobes), each number the shortest that reads back as the same float.
std::string to_json(const LobePolynomial& polynomial);

/// The inverse of to_json. `name` stands in for the file in error messages.
/// Refuses: text that is not JSON or is cut off, another format or version, a degree outside 3..6,
/// a wrong number of coefficients, numbers that are not finite in single precision, and polynomials
/// whose lobe has no positive determinant somewhere on a fine grid over their domain.
Result<LobePolynomial> polynomial_from_json(const std::string& text, const std::string& name);

/// Reads a .json polynomial; errors as polynomial_from_json.
Result<LobePolynomial> read_polynomial(const std::string& path);

/// A file by extension: .json; .cpp and .inc for the source of the built-in; .h, .glsl, .hlsl,
/// .wgsl and .js for a function to paste (polynomial_source.h).
Result<FileBytes> polynomial_bytes(const LobePolynomial& polynomial, const std::string& path);

/// Writes the file of polynomial_bytes. Complete or not at all: an existing file stays when writing
/// fails.
Status write_polynomial(const LobePolynomial& polynomial, const std::string& path);

/// Whether write_polynomial knows the extension of `path`; the error says which it knows.
Status check_polynomial_extension(const std::string& path);

/// C++ source that defines builtin_ggx_polynomial(), of two lobes
/// builtin_ggx_two_lobe_polynomial(), with the contents of `polynomial`.
std::string to_builtin_source(const LobePolynomial& polynomial);

} // namespace openltc::table
