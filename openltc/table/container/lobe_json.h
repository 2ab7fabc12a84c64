// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the native files of tables and of polynomials have in common. Private to this folder.

#pragma once

#include "openltc/base/result.h"
#include "openltc/table/lobe_table.h"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace openltc::table {

/// Channels that files hold of each texel or term; the other two are padding.
inline constexpr int k_stored_channels = 6;

/// The member of that name; empty, or 0, when there is none of that type.
std::string text_of(const nlohmann::json& object, const char* key);
double number_of(const nlohmann::json& object, const char* key);

/// The member "metadata" with all fields, its comma and line end included.
std::string metadata_json(const TableMetadata& metadata);

/// The inverse, from the file's root. Fails when there is none.
Status read_metadata(const nlohmann::json& root, const std::string& name, TableMetadata& metadata);

/// C++ statements that assign all fields to `variable`.metadata, one a line.
std::string metadata_assignments(const TableMetadata& metadata, const std::string& variable);

/// The stored channels of texels or terms of `stride` floats, one of them a line, each number the
/// shortest that reads back as the same float.
std::string number_rows(const std::vector<float>& values, int stride);

} // namespace openltc::table
