// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf.h"

#include "openltc/scene/gltf_import.h"
#include "openltc/scene/gltf_uri.h"

#include <filesystem>
#include <vector>

namespace openltc::scene {

Result<Scene> load_gltf(const std::string& path, const EmissiveOptions& emissive,
                        const PoseOptions& pose) {
  return gltf::guarded(path, [&] {
    const std::vector<std::uint8_t> bytes = gltf::read_file(path, "");
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    return gltf::import_gltf(bytes, folder.empty() ? "." : folder.string(), emissive, pose).scene;
  });
}

Result<Scene> load_gltf_memory(std::span<const std::uint8_t> bytes, const std::string& name,
                               const std::string& base_dir, const EmissiveOptions& emissive,
                               const PoseOptions& pose) {
  return gltf::guarded(name,
                       [&] { return gltf::import_gltf(bytes, base_dir, emissive, pose).scene; });
}

} // namespace openltc::scene
