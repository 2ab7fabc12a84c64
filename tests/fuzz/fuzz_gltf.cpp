// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Any bytes as a glTF file: loading ends in a scene that keeps the promises of scene.h or in one
// line that begins with the file's name.

#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/line.h"
#include "openltc/light/polygon.h"
#include "openltc/light/punctual.h"
#include "openltc/scene/gltf.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace {

void require(bool promise) {
  if (!promise) std::abort();
}

bool is_finite(openltc::Vec3f v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_mesh(const openltc::scene::Mesh& mesh, const openltc::scene::Scene& scene) {
  const std::size_t n = mesh.positions.size();
  require(mesh.material >= 0 && std::size_t(mesh.material) < scene.materials.size());
  require(mesh.normals.size() == n);
  for (const std::size_t size :
       {mesh.tangents.size(), mesh.tex_coord_0.size(), mesh.tex_coord_1.size(), mesh.colors.size()})
    require(size == 0 || size == n);
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle)
      require(corner < n);
  for (std::size_t i = 0; i < n; ++i) {
    require(is_finite(mesh.positions[i]));
    require(std::abs(length(mesh.normals[i]) - 1) < 1e-3f);
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto loaded = openltc::scene::load_gltf_memory({data, size}, "fuzz");
  if (!loaded.ok()) {
    require(loaded.error().message.rfind("fuzz: ", 0) == 0);
    require(loaded.error().message.find('\n') == std::string::npos);
    return 0;
  }
  for (const auto& mesh : loaded->meshes)
    check_mesh(mesh, *loaded);
  loaded->lights.for_each_area_light(
      [](const auto& light) { require(openltc::light::validate(light).ok()); });
  for (const auto& light : loaded->lights.punctual)
    require(openltc::light::validate(light).ok());
  return 0;
}
