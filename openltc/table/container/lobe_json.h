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

// The parts of a built-in's C++ source (openltc/api/*.inc): constants of the namespace openltc.

/// Licence, origin, what a line of the numbers holds, includes and the namespace's beginning.
std::string builtin_head(const TableMetadata& metadata, const std::string& line);
/// The metadata as a constant of type LobeMetadata.
std::string builtin_metadata(const std::string& constant, const TableMetadata& metadata);
/// Texels or terms of LobeTable::k_channels floats as a constant array, one of them a line, with
/// all channels; then the namespace's end.
std::string builtin_numbers(const std::string& constant, const std::vector<float>& values);
/// The two parts of builtin_numbers, for any number of channels.
std::string builtin_array(const std::string& constant, const std::vector<float>& values,
                          int channels);
std::string builtin_end();

/// The first `stored` channels of texels or terms of `stride` floats, one of them a line, each
/// number the shortest that reads back as the same float.
std::string number_rows(const std::vector<float>& values, int stride,
                        int stored = k_stored_channels);

} // namespace openltc::table
