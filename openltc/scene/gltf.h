// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// glTF 2.0 import (.gltf, .glb).

#pragma once

#include "openltc/base/result.h"
#include "openltc/scene/emissive/emissive.h"
#include "openltc/scene/read_options.h"
#include "openltc/scene/scene.h"

#include <cstdint>
#include <span>
#include <string>

namespace openltc::scene {

/// Reads a glTF file and everything it refers to; `emissive` says how emissive surfaces become
/// lights, `reading` at which moment of an animation it is read, and from where. What cannot be
/// read but can be spared (a texture, a light) costs a warning. The memory that the file asks for
/// is counted in memory_budget().
/// An Error names the file and the field (e.g. "a.gltf: accessors[3].count: ..."). Never throws.
Result<Scene> load_gltf(const std::string& path, const EmissiveOptions& emissive = {},
                        const ReadOptions& reading = {});

/// The same from memory, a .glb or the text of a .gltf; relative references are looked up in
/// `base_dir`, and refused when it is empty. `name` stands for the file in messages.
Result<Scene> load_gltf_memory(std::span<const std::uint8_t> bytes, const std::string& name,
                               const std::string& base_dir = {},
                               const EmissiveOptions& emissive = {},
                               const ReadOptions& reading = {});

} // namespace openltc::scene
