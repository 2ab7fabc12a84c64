// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Reading the typed arrays of a glTF file.

#pragma once

#include "openltc/base/memory_budget.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace openltc::scene::gltf {

struct Document;

/// An accessor's values as floats, element after element. Normalised integers are scaled to
/// [0, 1] or [-1, 1], others are taken as they are (KHR_mesh_quantization); sparse values are put
/// in.
struct Floats {
  std::vector<float> values;
  std::size_t components = 0; ///< per element
  std::size_t count = 0;      ///< elements
  MemoryShare memory;         ///< what the values take
};

/// Reads accessors[index]. Throws Failure when its data does not lie within its buffer view or
/// memory_budget() has no room; checks that before it allocates.
Floats read_floats(const Document& document, int index);

/// Elements `first` to `first + count` - 1 of accessors[index] alone, which must lie within it.
Floats read_floats(const Document& document, int index, std::size_t first, std::size_t count);

/// accessors[index].count. Throws Failure when its view does not hold so many.
std::size_t accessor_count(const Document& document, int index);

/// Reads accessors[index], MAT4 of floats, 16 numbers each, column by column. Throws Failure as
/// read_floats does, and when it is of another type.
std::vector<std::array<float, 16>> read_matrices(const Document& document, int index);

/// Reads accessors[index] as whole numbers, for triangle indices. Throws Failure as read_floats
/// does, and when its type is not an unsigned SCALAR.
std::vector<std::uint32_t> read_indices(const Document& document, int index);

/// "accessors[index]", for messages.
std::string accessor_field(int index);

} // namespace openltc::scene::gltf
