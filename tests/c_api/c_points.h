// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Random points of surfaces, as an array of structs, and as the C++ API takes them.

#pragma once

#include "openltc/openltc.h"
#include "openltc/openltc_c.h"

#include <cstddef>
#include <random>
#include <vector>

namespace openltc::testing {

/// A point with something else in between, as in an engine's own struct.
struct Vertex {
  float position[3];
  int id = 0;
  float normal[3], view[3];
  openltc_material material;
  float geometric[3];
  float error;
};

inline std::vector<Vertex> random_vertices(std::size_t count) {
  std::mt19937 random(7);
  const auto in = [&](float from, float to) {
    return from + (to - from) * float(random() >> 8) * 0x1p-24f;
  };
  std::vector<Vertex> vertices(count);
  for (Vertex& v : vertices) {
    const float position[3] = {in(-1, 1), in(-0.2f, 0.2f), in(-1, 1)};
    const float normal[3] = {in(-0.5f, 0.5f), 1, in(-0.5f, 0.5f)};
    const float view[3] = {in(-2, 2), in(0, 2), in(-2, 2)};
    const float geometric[3] = {in(-0.3f, 0.3f), in(0, 1) < 0.8f ? 1.0f : -1.0f, in(-0.3f, 0.3f)};
    for (int i = 0; i < 3; ++i) {
      v.position[i] = position[i];
      v.normal[i] = normal[i];
      v.view[i] = view[i];
      v.geometric[i] = geometric[i];
    }
    v.error = in(0, 1) < 0.5f ? 0.0f : in(0, 0.01f);
    v.material = {{in(0, 1), in(0, 1), in(0, 1)}, in(0, 1), in(0, 1), in(0, 1),
                  {in(0, 1), in(0, 1), in(0, 1)}, in(1, 2)};
  }
  return vertices;
}

inline openltc_points points_of(const std::vector<Vertex>& vertices) {
  const Vertex& v = vertices.front();
  openltc_points points{};
  points.count = vertices.size();
  points.positions = {v.position, sizeof(Vertex)};
  points.normals = {v.normal, sizeof(Vertex)};
  points.views = {v.view, sizeof(Vertex)};
  points.materials = {&v.material, sizeof(Vertex)};
  points.geometric_normals = {v.geometric, sizeof(Vertex)};
  points.position_errors = {&v.error, sizeof(Vertex)};
  return points;
}

inline Vec3f vector_of(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

inline Surface surface_of(const Vertex& v, const Lobes& lobes) {
  Material material;
  material.base_color = vector_of(v.material.base_color);
  material.metallic = v.material.metallic;
  material.roughness = v.material.roughness;
  material.specular = v.material.specular;
  material.specular_color = vector_of(v.material.specular_color);
  material.ior = v.material.ior;
  Surface surface = make_surface(vector_of(v.position), vector_of(v.normal), vector_of(v.view),
                                 material, lobes, vector_of(v.geometric));
  set_position_error(surface, v.error);
  return surface;
}

} // namespace openltc::testing
