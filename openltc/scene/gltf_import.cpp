// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf_import.h"

#include "openltc/scene/gltf_animation.h"
#include "openltc/scene/gltf_container.h"
#include "openltc/scene/gltf_document.h"
#include "openltc/scene/gltf_material.h"
#include "openltc/scene/gltf_node.h"

#include <algorithm>

namespace openltc::scene::gltf {

namespace {

Bounds bounds_of(const std::vector<Mesh>& meshes) {
  Bounds bounds;
  bool is_first = true;
  for (const Mesh& mesh : meshes) {
    for (const Vec3f p : mesh.positions) {
      if (is_first) bounds = {p, p};
      is_first = false;
      bounds.lower = Vec3f(std::min(bounds.lower.x, p.x), std::min(bounds.lower.y, p.y),
                           std::min(bounds.lower.z, p.z));
      bounds.upper = Vec3f(std::max(bounds.upper.x, p.x), std::max(bounds.upper.y, p.y),
                           std::max(bounds.upper.z, p.z));
    }
  }
  return bounds;
}

// Whether a material says expressly how strongly it shines.
bool is_strong(const Document& document, std::size_t material) {
  return material < document.strong_materials.size() && document.strong_materials[material];
}

} // namespace

Imported import_gltf(std::span<const std::uint8_t> bytes, const Folder& folder,
                     const EmissiveOptions& emissive, const PoseOptions& pose) {
  Document document;
  read_document(split_container(bytes), folder, document);
  Imported imported;
  Scene& scene = imported.scene;
  scene.memory = document.scene_memory;
  read_materials(document, scene);
  read_nodes(document, read_pose(document, pose, scene.animations), imported);
  if (scene.materials.empty()) scene.materials.push_back({});
  if (scene.meshes.empty())
    document.warnings.add("there is nothing to see: the file has no triangles");
  for (const Mesh& mesh : scene.meshes)
    scene.describes_lights = scene.describes_lights ||
                             (mesh.emits_light && is_strong(document, std::size_t(mesh.material)));
  scene.bounds = bounds_of(scene.meshes);
  imported.mesh_lights = find_emissive_lights(scene, emissive, document.warnings);
  for (const light::Lights& lights : imported.mesh_lights)
    append_lights(lights, scene.lights);
  scene.warnings = document.warnings.lines();
  return imported;
}

} // namespace openltc::scene::gltf
