// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf/import.h"

#include "openltc/light/light_list.h"
#include "openltc/scene/gltf/animation.h"
#include "openltc/scene/gltf/file/container.h"
#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/memory.h"
#include "openltc/scene/gltf/material.h"
#include "openltc/scene/gltf/node.h"

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

// A light of its own with what shading keeps of it, twice: by its mesh and in the scene. What a
// triangle takes while the lights of its mesh are made: as a welded one, in planes, in outlines.
constexpr std::uint64_t k_light_bytes = 1024, k_emissive_triangle_bytes = 256;

// Meshes are looked at one after the other.
std::uint64_t memory_to_make_lights(const Scene& scene) {
  std::uint64_t triangles = 0;
  for (const Mesh& mesh : scene.meshes) {
    const Vec3f emission = scene.materials[std::size_t(mesh.material)].emission;
    if (mesh.emits_light && (emission.x > 0 || emission.y > 0 || emission.z > 0))
      triangles = std::max<std::uint64_t>(triangles, mesh.triangles.size());
  }
  return triangles * k_emissive_triangle_bytes;
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
  MemoryShare making_lights;
  take_memory(making_lights, memory_to_make_lights(scene), "emissive triangles");
  imported.mesh_lights = find_emissive_lights(scene, emissive, document.warnings);
  std::uint64_t light_bytes = 0;
  for (const light::Lights& lights : imported.mesh_lights)
    light_bytes += lights.area_light_count() * k_light_bytes;
  take_memory(*scene.memory, light_bytes, "lights of emissive triangles");
  for (const light::Lights& lights : imported.mesh_lights)
    light::append_lights(lights, scene.lights);
  scene.warnings = document.warnings.lines();
  return imported;
}

} // namespace openltc::scene::gltf
