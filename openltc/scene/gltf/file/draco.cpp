// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf/file/draco.h"

#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/memory.h"

#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/mesh/mesh.h>
#include <draco/metadata/metadata_decoder.h>
#include <fmt/format.h>

#include <memory>

namespace openltc::scene::gltf {

namespace {

// What Draco's own structures take while it decodes: for a triangle its corners, their opposites
// and what they stand for, for each kind of attribute; for a vertex its values, as integers and as
// they come out, and its places in tables. Estimates.
constexpr std::uint64_t k_triangle_bytes = 128, k_vertex_bytes = 64, k_value_bytes = 48;

struct Sizes {
  std::uint64_t triangles = 0, vertices = 0;
};

template <class Int> std::uint64_t read_count(draco::DecoderBuffer& buffer, bool& is_whole) {
  Int count = 0;
  is_whole = is_whole && draco::DecodeVarint(&count, &buffer);
  return count;
}

// What the stream says of itself before the first triangle: Draco Bitstream Specification 2.2,
// sections 2.2 (header), 2.4 (connectivity), 2.5 and 2.6. Older streams, and broken ones, say
// nothing here.
Sizes sizes_of(std::span<const std::uint8_t> bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok()) return {};
  const int version = header.version_major * 256 + header.version_minor;
  if (version < 2 * 256 + 2 || header.encoder_type != draco::TRIANGULAR_MESH) return {};
  buffer.set_bitstream_version(std::uint16_t(version));
  draco::GeometryMetadata metadata;
  if ((header.flags & METADATA_FLAG_MASK) &&
      !draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata))
    return {};
  bool is_whole = true;
  Sizes sizes;
  if (header.encoder_method == draco::MESH_SEQUENTIAL_ENCODING) {
    sizes.triangles = read_count<std::uint32_t>(buffer, is_whole);
    sizes.vertices = read_count<std::uint32_t>(buffer, is_whole);
  } else {
    std::uint8_t traversal = 0;
    is_whole = buffer.Decode(&traversal);
    // Seams of texture coordinates and normals split vertices, up to one for each corner; that
    // many is what a stranger can make of it.
    sizes.vertices = read_count<std::uint32_t>(buffer, is_whole);
    sizes.triangles = read_count<std::uint32_t>(buffer, is_whole);
  }
  return is_whole ? sizes : Sizes{};
}

Floats read_attribute(const draco::Mesh& mesh, const draco::PointAttribute& attribute,
                      const std::string& field) {
  Floats result;
  result.components = std::size_t(attribute.num_components());
  result.count = mesh.num_points();
  if (result.components < 1 || result.components > 4)
    fail(field, fmt::format("a Draco attribute has {} components; export the file again",
                            result.components));
  take_memory(result.memory, result.count * result.components * sizeof(float), field);
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
  const Sizes sizes = sizes_of(bytes);
  MemoryShare decoding;
  take_memory(decoding,
              sizes.triangles * k_triangle_bytes +
                  sizes.vertices * (k_vertex_bytes + k_value_bytes * ids.size()),
              fmt::format("{}: {} compressed triangles", field, sizes.triangles));
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok() || !decoded.value())
    fail(field, fmt::format("the Draco data cannot be decoded ({}); export the file again",
                            decoded.status().error_msg_string()));
  const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();

  DracoMesh result;
  take_memory(result.memory, std::uint64_t(mesh->num_faces()) * sizeof(result.triangles[0]), field);
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
