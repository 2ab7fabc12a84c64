// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Native files of a lobe table: JSON, which loses nothing, and the C++ source of the built-in.

#pragma once

#include "openltc/base/result.h"
#include "openltc/table/layout.h"
#include "openltc/table/lobe_table.h"

#include <string>

namespace openltc::table {

/// The table as JSON text: metadata, axes and the six channels A B C D n1 n5 of every texel, of two
/// lobes the eleven A B C D n1 n5 weight A2 B2 C2 D2, each number the shortest that reads back as
/// the same float. One lobe is version 2 of the format, two are version 3.
std::string to_json(const LobeTable& table);

/// The inverse of to_json; version 1, which had no columns and rows, is read too. `name` stands in
/// for the file in error messages.
/// Refuses: text that is not JSON or is cut off, another format or version, a size beyond 512,
/// a wrong number of texels, numbers that are not finite in single precision, texels whose lobe
/// has no positive determinant, and weights outside 0..1.
Result<LobeTable> from_json(const std::string& text, const std::string& name);

/// A table of any layout on the native angle axis, ready for shading. The error begins with `name`.
Result<LobeTable> shading_table(const PackedTable& packed, const std::string& name);

/// Reads a table of any layout that says itself what it is (packed_file.h) as a shading_table.
Result<LobeTable> read_table(const std::string& path);

/// Writes by extension: .json, or .cpp and .inc for the source of the built-in. Complete or not at
/// all: an existing file stays when writing fails.
Status write_table(const LobeTable& table, const std::string& path);

/// Whether write_table knows the extension of `path`; the error says which it knows.
Status check_writable_extension(const std::string& path);

/// C++ source that defines the constants k_ggx_table, its size and its metadata, of the built-in
/// table (openltc/api/ggx_table.inc), with the contents of `table`; of two lobes k_ggx_two_lobes
/// and k_ggx_two_lobes_second (openltc/api/ggx_two_lobes.inc).
std::string to_builtin_source(const LobeTable& table);

} // namespace openltc::table
