// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Tables in the files that engines themselves ship, to be put in their place.

#pragma once

#include "openltc/base/result.h"
#include "openltc/table/layout.h"
#include "openltc/table/texture.h"

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace openltc::table {

/// An engine, and what its own source expects of a table. Sources: engine_files.cpp.
struct Engine {
  const char* name;  ///< on the command line
  const char* title; ///< as its makers write it
  Layout layout;
  int size; ///< nodes per axis
  Precision precision;
  std::vector<const char*> files; ///< their names, without folder
  const char* place;              ///< where they go in the engine's source or project
  const char* slip; ///< what its look-up does otherwise than its table means; empty: nothing known
};

/// All engines, in the order in which they are listed.
std::span<const Engine> all_engines();

/// nullptr when there is none of that name.
const Engine* find_engine(std::string_view name);

/// The files of a table for an engine, name and bytes, in the order of Engine::files. They say
/// nothing about themselves, since they are what the engine reads; a description is written beside
/// them by write_engine_files. Numbers that are written as text have six significant digits, as in
/// the files that they replace. Fails when the table's layout, precision or size is another.
Result<std::vector<std::pair<std::string, Bytes>>> engine_files(const PackedTable& packed,
                                                                const Engine& engine);

/// The paths that write_engine_files writes: those of the engine and k_engine_description.
std::vector<std::string> engine_paths(const Engine& engine, const std::string& folder);
inline constexpr const char* k_engine_description = "ltc_table.json";

/// Writes the files of a table, all or none, into a folder that exists. Returns their paths.
Result<std::vector<std::string>> write_engine_files(const PackedTable& packed, const Engine& engine,
                                                    const std::string& folder);

} // namespace openltc::table
