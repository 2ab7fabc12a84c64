// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf.h"

#include "openltc/scene/gltf/file/uri.h"
#include "openltc/scene/gltf/import.h"

#include <vector>

namespace openltc::scene {

Result<Scene> load_gltf(const std::string& path, const EmissiveOptions& emissive,
                        const ReadOptions& reading) {
  return gltf::guarded(path, [&] {
    MemoryShare memory;
    const std::vector<std::uint8_t> bytes = gltf::read_scene_file(path, memory);
    return gltf::import_gltf(bytes, gltf::folder_of(path, reading.allow_outside), emissive,
                             reading.pose)
        .scene;
  });
}

Result<Scene> load_gltf_memory(std::span<const std::uint8_t> bytes, const std::string& name,
                               const std::string& base_dir, const EmissiveOptions& emissive,
                               const ReadOptions& reading) {
  return gltf::guarded(name, [&] {
    return gltf::import_gltf(bytes, {base_dir, reading.allow_outside}, emissive, reading.pose)
        .scene;
  });
}

} // namespace openltc::scene
