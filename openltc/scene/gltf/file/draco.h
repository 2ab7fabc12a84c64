// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// KHR_draco_mesh_compression.

#pragma once

#include "openltc/scene/gltf/file/accessor.h"

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace openltc::scene::gltf {

/// What a compressed primitive holds: always a triangle list.
struct DracoMesh {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::map<std::string, Floats> attributes; ///< by glTF name
  MemoryShare memory;                       ///< what the triangles take
};

/// Decodes `bytes`. `ids` gives the Draco id of each glTF attribute. Throws Failure that names
/// `field`, also when what it says it holds is more than memory_budget() has room for.
DracoMesh decode_draco(std::span<const std::uint8_t> bytes, const std::map<std::string, int>& ids,
                       const std::string& field);

} // namespace openltc::scene::gltf
