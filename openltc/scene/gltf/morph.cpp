// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf/morph.h"

#include "openltc/scene/gltf/file/accessor.h"
#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/failure.h"

#include <fmt/format.h>

#include <algorithm>

namespace openltc::scene::gltf {

namespace {

float moved(float value, float difference, double weight) {
  return float(double(value) + weight * double(difference));
}

void add_to(Vec2f& to, const float* v, std::size_t, double weight) {
  to = Vec2f(moved(to.x, v[0], weight), moved(to.y, v[1], weight));
}
void add_to(Vec3f& to, const float* v, std::size_t, double weight) {
  to = Vec3f(moved(to.x, v[0], weight), moved(to.y, v[1], weight), moved(to.z, v[2], weight));
}
void add_to(Vec4f& to, const float* v, std::size_t components, double weight) {
  to = Vec4f(moved(to.x, v[0], weight), moved(to.y, v[1], weight), moved(to.z, v[2], weight),
             components == 4 ? moved(to.w, v[3], weight) : to.w);
}

} // namespace

void add_targets(const Document& document, std::span<const std::map<std::string, int>> targets,
                 const std::string& primitive, std::span<const double> weights, Mesh& mesh) {
  const std::size_t count = std::min(weights.size(), targets.size());
  for (std::size_t i = 0; i < count; ++i) {
    const double weight = weights[i];
    if (weight == 0) continue;
    const auto& target = targets[i];
    const auto add = [&](const char* name, auto& values, std::size_t at_least,
                         std::size_t at_most) {
      const auto attribute = target.find(name);
      if (attribute == target.end() || values.empty()) return;
      const std::string field = fmt::format("{}.targets[{}].{}", primitive, i, name);
      const Floats floats = read_floats(document, attribute->second);
      if (floats.components < at_least || floats.components > at_most)
        fail(field,
             fmt::format("has {} components per vertex; export the file again", floats.components));
      if (floats.count != values.size())
        fail(field, fmt::format("has {} vertices but {} has {}; the file is damaged, export it "
                                "again",
                                floats.count, name, values.size()));
      for (std::size_t v = 0; v < floats.count; ++v)
        add_to(values[v], floats.values.data() + floats.components * v, floats.components, weight);
    };
    add("POSITION", mesh.positions, 3, 3);
    add("NORMAL", mesh.normals, 3, 4);
    add("TANGENT", mesh.tangents, 3, 3);
    add("TEXCOORD_0", mesh.tex_coord_0, 2, 2);
    add("TEXCOORD_1", mesh.tex_coord_1, 2, 2);
    add("COLOR_0", mesh.colors, 3, 4);
  }
}

} // namespace openltc::scene::gltf
