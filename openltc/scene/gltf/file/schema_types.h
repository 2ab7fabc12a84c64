// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The types of objects of a glTF file, and the fields of each: what schema.h checks.
//
// They follow the JSON schemas of the glTF 2.0 specification and of the extensions that are read.
// Fields that are not listed are not read and may hold anything.

#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace openltc::scene::gltf {

enum class FieldKind {
  text,
  flag,
  number,
  numbers,    // `size` of them, 0 = any
  count,      // a whole number >= 0
  index,      // into the array at JSON pointer `detail`
  indices,    // an array of those
  index_map,  // an object whose values are those
  index_maps, // an array of index_map
  object,     // of the type `detail`
  objects,    // an array of those
  texts,
  choice,      // a text, one of `detail`, separated by |
  count_choice // a whole number, one of `detail`
};

struct SchemaField {
  const char* name;
  FieldKind kind;
  const char* detail = ""; ///< what its kind says
  bool required = false;
  std::size_t size = 0;
};

/// The fields of a type, by the schema's own names, e.g. "node", "light_area"; "root" is the file.
/// There must be such a type.
const std::vector<SchemaField>& schema_type(std::string_view name);

} // namespace openltc::scene::gltf
