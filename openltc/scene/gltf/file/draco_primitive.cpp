// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf/file/draco_primitive.h"

#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/tinygltf.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace openltc::scene::gltf {

namespace {

// Draco does not know which integers glTF means normalised.
void scale_normalized(Floats& floats, const tinygltf::Accessor& accessor) {
  if (!accessor.normalized) return;
  float scale = 1;
  switch (accessor.componentType) {
  case TINYGLTF_COMPONENT_TYPE_BYTE:
    scale = 127;
    break;
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    scale = 255;
    break;
  case TINYGLTF_COMPONENT_TYPE_SHORT:
    scale = 32767;
    break;
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
    scale = 65535;
    break;
  default:
    return;
  }
  // Some encoders mark the Draco attribute as normalised too, and the decoder then divides.
  for (const float value : floats.values)
    if (std::abs(value) > 1) {
      for (float& v : floats.values)
        v = std::max(v / scale, -1.0f);
      return;
    }
}

} // namespace

std::optional<DracoMesh> decode_draco_part(const Document& document,
                                           const tinygltf::Primitive& primitive,
                                           const std::string& field) {
  const auto found = primitive.extensions.find("KHR_draco_mesh_compression");
  if (found == primitive.extensions.end()) return std::nullopt;
  std::map<std::string, int> ids;
  const tinygltf::Value& attributes = found->second.Get("attributes");
  if (attributes.IsObject())
    for (const std::string& key : attributes.Keys())
      ids[key] = attributes.Get(key).GetNumberAsInt();
  const int view = found->second.Get("bufferView").GetNumberAsInt();
  DracoMesh mesh = decode_draco(document.views[std::size_t(view)].bytes, ids,
                                field + ".extensions.KHR_draco_mesh_compression");
  for (auto& [name, floats] : mesh.attributes) {
    const auto attribute = primitive.attributes.find(name);
    if (attribute != primitive.attributes.end())
      scale_normalized(floats, document.model->accessors[std::size_t(attribute->second)]);
  }
  return mesh;
}

} // namespace openltc::scene::gltf
