// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf/instances.h"

#include "openltc/scene/gltf/file/accessor.h"
#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/memory.h"
#include "openltc/scene/gltf/file/tinygltf.h"

#include <fmt/format.h>

namespace openltc::scene::gltf {

namespace {

constexpr const char* k_extension = "EXT_mesh_gpu_instancing";

} // namespace

std::vector<Transform> read_instances(Document& document, std::size_t node) {
  const auto& extensions = document.model->nodes[node].extensions;
  const auto found = extensions.find(k_extension);
  if (found == extensions.end()) return {Transform{}};

  const std::string field = fmt::format("nodes[{}].extensions.{}.attributes", node, k_extension);
  const tinygltf::Value& attributes = found->second.Get("attributes");
  std::size_t count = 0;
  std::string first; // attribute, which says how many there are
  const auto read = [&](const char* name, std::size_t components) {
    Floats floats;
    if (!attributes.IsObject() || !attributes.Has(name)) return floats;
    floats = read_floats(document, attributes.Get(name).GetNumberAsInt());
    if (floats.components != components)
      fail(field + "." + name, fmt::format("has {} components instead of {}; export the file again",
                                           floats.components, components));
    if (!first.empty() && floats.count != count)
      fail(field + "." + name,
           fmt::format("is for {} instances but {} for {}; the file is damaged, export it again",
                       floats.count, first, count));
    first = name;
    count = floats.count;
    return floats;
  };
  const Floats translations = read("TRANSLATION", 3);
  const Floats rotations = read("ROTATION", 4);
  const Floats scales = read("SCALE", 3);
  // Attributes of one's own alone, e.g. _COLOR: where the instances stand is not said.
  if (first.empty()) {
    document.warnings.add(field + ": has no TRANSLATION, ROTATION or SCALE; one copy is shown");
    return {Transform{}};
  }

  take_memory(document.memory, saturating_product(count, sizeof(Transform)),
              fmt::format("{}: {} instances", field, count));
  std::vector<Transform> instances(count);
  const auto vector_of = [](const Floats& floats, std::size_t i, double otherwise) {
    if (floats.count == 0) return Vec3d(otherwise, otherwise, otherwise);
    const float* v = floats.values.data() + 3 * i;
    return Vec3d(double(v[0]), double(v[1]), double(v[2]));
  };
  for (std::size_t i = 0; i < count; ++i) {
    std::array<double, 4> rotation{0, 0, 0, 1};
    if (rotations.count != 0)
      for (std::size_t c = 0; c < 4; ++c)
        rotation[c] = double(rotations.values[4 * i + c]);
    bool has_rotation = true;
    instances[i] = transform_of(vector_of(translations, i, 0), rotation, vector_of(scales, i, 1),
                                has_rotation);
    if (!has_rotation)
      document.warnings.add(field + ".ROTATION: some have no length; they are not rotated");
  }
  return instances;
}

} // namespace openltc::scene::gltf
