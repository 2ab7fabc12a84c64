// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What a packed table says about itself, as keys and values that every container can hold.

#pragma once

#include "openltc/base/result.h"
#include "openltc/table/layout.h"

#include <string>

namespace openltc::table {

/// Keys: format version layout precision columns rows roughness_axis angle_axis width normalisation
/// texture_1 texture_2 (channels by name) read_by brdf variant objective horizon command
/// tool_version mean_tv max_tv.
KeyValues describe(const PackedTable& packed);

/// Takes layout, angle axis, width and metadata from a description, whose columns and rows, if
/// there, must be those of the textures. The error begins with `name`.
Status apply_description(const KeyValues& description, const std::string& name,
                         PackedTable& packed);

/// The description as a JSON object, and back. from_json skips members that are neither text nor
/// number; it refuses text that is not a JSON object of our format.
std::string description_to_json(const KeyValues& description);
Result<KeyValues> description_from_json(const std::string& text, const std::string& name);

/// The whole table as JSON: the description with a member `textures`, and back. Numbers are the
/// shortest that read back the same.
std::string packed_to_json(const PackedTable& packed);
Result<PackedTable> packed_from_json(const std::string& text, const std::string& name);

/// Text as JSON; bytes that are not UTF-8 are replaced.
std::string json_quoted(const std::string& text);

/// A float as a JSON number, the shortest that reads back as the same float; -0 keeps its sign.
std::string json_number(float value);

} // namespace openltc::table
