// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf.h"

#include "openltc/scene/emissive.h"
#include "openltc/scene/gltf_container.h"
#include "openltc/scene/gltf_document.h"
#include "openltc/scene/gltf_failure.h"
#include "openltc/scene/gltf_material.h"
#include "openltc/scene/gltf_node.h"
#include "openltc/scene/gltf_uri.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <new>

namespace openltc::scene {

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

Scene import(std::span<const std::uint8_t> bytes, const std::string& base_dir) {
  gltf::Document document;
  gltf::read_document(gltf::split_container(bytes), base_dir, document);
  Scene scene;
  gltf::read_materials(document, scene);
  gltf::read_nodes(document, scene);
  if (scene.materials.empty()) scene.materials.push_back({});
  if (document.skin_count != 0)
    document.warnings.add(
        "skinned meshes are shown in the pose in which they were bound; bones do not bend "
        "them yet");
  if (document.animation_count != 0)
    document.warnings.add("animations are not played; the rest pose is shown");
  if (scene.meshes.empty())
    document.warnings.add("there is nothing to see: the file has no triangles");
  scene.bounds = bounds_of(scene.meshes);
  add_emissive_lights(scene, document.warnings);
  scene.warnings = document.warnings.lines();
  return scene;
}

// Runs `load` and turns whatever it throws into one line that begins with `name`.
template <class Load> Result<Scene> guarded(const std::string& name, const Load& load) {
  try {
    return load();
  } catch (const gltf::Failure& failure) {
    return Error{fmt::format("{}: {}", name, failure.message)};
  } catch (const std::bad_alloc&) {
    return Error{fmt::format("{}: not enough memory to load it", name)};
  } catch (const std::exception& e) {
    return Error{fmt::format("{}: cannot be loaded: {}", name, e.what())};
  }
}

} // namespace

Result<Scene> load_gltf(const std::string& path) {
  return guarded(path, [&] {
    const std::vector<std::uint8_t> bytes = gltf::read_file(path, "");
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    return import(bytes, folder.empty() ? "." : folder.string());
  });
}

Result<Scene> load_gltf_memory(std::span<const std::uint8_t> bytes, const std::string& name,
                               const std::string& base_dir) {
  return guarded(name, [&] { return import(bytes, base_dir); });
}

} // namespace openltc::scene
