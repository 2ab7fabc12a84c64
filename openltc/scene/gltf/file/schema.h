// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The shape of a glTF file: which fields there are, of what type, pointing where.

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace openltc::scene::gltf {

/// Checks every field that the importer reads: its type, its range, and that an index points at
/// something. Throws Failure with the field's path, e.g. "meshes[0].primitives[1].material".
///
/// Whole numbers written as 3.0 become integers, as what reads `root` later expects.
void check_schema(nlohmann::json& root);

/// The same for one object of the file, which messages call `path`; `type` is one of the schema's
/// own names, e.g. "light_area", "animation", "skin": what check_schema passes over, so that the
/// file is not lost with it. Indices are looked up in `root`.
void check_member(nlohmann::json& root, nlohmann::json& value, const std::string& path,
                  const char* type);

} // namespace openltc::scene::gltf
