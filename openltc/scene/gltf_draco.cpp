// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf_draco.h"

#include "openltc/scene/gltf_failure.h"

#include <draco/compression/decode.h>
#include <draco/mesh/mesh.h>
#include <fmt/format.h>

#include <memory>

namespace openltc::scene::gltf {

namespace {

Floats read_attribute(const draco::Mesh& mesh, const draco::PointAttribute& attribute,
                      const std::string& field) {
  Floats result;
  result.components = std::size_t(attribute.num_components());
  result.count = mesh.num_points();
  if (result.components < 1 || result.components > 4)
    fail(field, fmt::format("a Draco attribute has {} components; export the file again",
                            result.components));
  result.values.resize(result.count * result.components);
  for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
    const draco::AttributeValueIndex value = attribute.mapped_index(point);
    float* out = result.values.data() + std::size_t(point.value()) * result.components;
    if (value.value() >= attribute.size() ||
        !attribute.ConvertValue<float>(value, std::int8_t(result.components), out))
      fail(field, "the Draco data is damaged; export the file again");
  }
  return result;
}

} // namespace

DracoMesh decode_draco(std::span<const std::uint8_t> bytes, const std::map<std::string, int>& ids,
                       const std::string& field) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok() || !decoded.value())
    fail(field, fmt::format("the Draco data cannot be decoded ({}); export the file again",
                            decoded.status().error_msg_string()));
  const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();

  DracoMesh result;
  result.triangles.reserve(mesh->num_faces());
  for (draco::FaceIndex f(0); f < mesh->num_faces(); ++f) {
    const draco::Mesh::Face& face = mesh->face(f);
    for (const draco::PointIndex& corner : face)
      if (corner.value() >= mesh->num_points())
        fail(field, "the Draco data is damaged; export the file again");
    result.triangles.push_back({face[0].value(), face[1].value(), face[2].value()});
  }
  for (const auto& [name, id] : ids) {
    const draco::PointAttribute* attribute = mesh->GetAttributeByUniqueId(std::uint32_t(id));
    if (!attribute)
      fail(field + ".attributes." + name,
           fmt::format("the Draco data has no attribute with id {}; export the file again", id));
    result.attributes[name] = read_attribute(*mesh, *attribute, field);
  }
  return result;
}

} // namespace openltc::scene::gltf
