// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Memory that a glTF file asks for, asked of the budget before it is taken.

#pragma once

#include "openltc/base/memory_budget.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/scene.h"

#include <cstdint>
#include <string>

namespace openltc::scene::gltf {

/// Counts `bytes` in `share`, or throws Failure that names `field`, the limit and --memory.
inline void take_memory(MemoryShare& share, std::uint64_t bytes, const std::string& field) {
  if (const Status status = share.take(bytes, field); !status)
    throw Failure{status.error().message};
}

/// a * b, or the largest number when that is beyond 64 bits.
inline std::uint64_t saturating_product(std::uint64_t a, std::uint64_t b) {
  return b != 0 && a > ~std::uint64_t(0) / b ? ~std::uint64_t(0) : a * b;
}

/// What a mesh takes: its arrays, and the ray tracer's tree over it, about 128 bytes a triangle and
/// a kilobyte.
/// For instances, ask for mesh_memory times their number before the copies are made.
std::uint64_t mesh_memory(const Mesh& mesh);

} // namespace openltc::scene::gltf
