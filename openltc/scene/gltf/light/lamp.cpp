// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf/light/lamp.h"

#include "openltc/scene/emissive/light_surface.h"

#include <fmt/format.h>

#include <algorithm>

namespace openltc::scene::gltf {

namespace {

void set_surface_deviation(light::Lights& lights, float deviation) {
  const auto set = [&](auto& list) {
    for (auto& light : list)
      light.surface_deviation = deviation;
  };
  set(lights.polygons);
  set(lights.ellipses);
  set(lights.spheres);
  set(lights.tubes);
  set(lights.lines);
}

} // namespace

void attach_mesh(const std::string& label, std::span<Mesh> meshes,
                 const std::vector<Material>& materials, light::Lights& light, Warnings& warnings) {
  // Where some of the mesh's surfaces glow, those are the lamp, and the others its housing.
  const auto glows = [&](const Mesh& mesh) {
    const Vec3f e = materials[std::size_t(mesh.material)].emission;
    return e.x > 0 || e.y > 0 || e.z > 0;
  };
  const bool any_glows = std::any_of(meshes.begin(), meshes.end(), glows);
  for (Mesh& mesh : meshes)
    mesh.emits_light = false;
  if (!light.punctual.empty()) {
    if (light.punctual[0].type != light::PunctualType::directional)
      warnings.add(label + ": the light has no extent, so that the node's mesh shadows "
                           "it; give it the type of the mesh's shape");
    return;
  }
  light.for_each_area_light([&](const auto& area_light) {
    double deviation = 0;
    for (const Mesh& mesh : meshes) {
      if (any_glows && !glows(mesh)) continue;
      for (const Vec3f p : mesh.positions)
        deviation = std::max(deviation, distance_outside(area_light, p));
    }
    if (deviation > reach_of(area_light)) {
      warnings.add(
          fmt::format("{}: its mesh reaches {:.3g} m beyond the light, so that it is not taken "
                      "for the light's surface and may shadow it",
                      label, deviation));
      deviation = 0;
    }
    set_surface_deviation(light, float(deviation));
  });
}

} // namespace openltc::scene::gltf
