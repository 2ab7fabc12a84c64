// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// EXT_meshopt_compression: buffer views compressed by meshoptimizer.

#pragma once

#include "openltc/base/memory_budget.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace openltc::scene::gltf {

/// The fields of the extension.
struct MeshoptStream {
  std::span<const std::uint8_t> bytes;
  std::size_t count = 0;
  std::size_t stride = 0;
  std::string mode;   ///< ATTRIBUTES, TRIANGLES or INDICES
  std::string filter; ///< NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL
};

/// Whether this build has the library.
bool has_meshopt_decoder();

/// count * stride bytes, which are counted in `memory` before they are taken. Throws Failure that
/// names `field` when the stream or its description is broken or the build has no decoder.
std::vector<std::uint8_t> decode_meshopt(const MeshoptStream& stream, const std::string& field,
                                         MemoryShare& memory);

} // namespace openltc::scene::gltf
