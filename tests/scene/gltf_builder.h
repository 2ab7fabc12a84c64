// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Small glTF files made in memory, so that each test shows all of the file that it is about.

#pragma once

#include "openltc/scene/gltf.h"

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace openltc::test {

using nlohmann::json;

constexpr int k_byte = 5120, k_ubyte = 5121, k_short = 5122, k_ushort = 5123, k_uint = 5125,
              k_float = 5126;

/// The JSON of a glTF file, and the binary buffer that it refers to as buffers[0].
class GltfBuilder {
public:
  GltfBuilder();

  json root;
  std::vector<std::uint8_t> buffer;

  /// Appends bytes to the buffer, 4-aligned, as a new buffer view; returns its index.
  int add_view(const void* data, std::size_t size, std::size_t stride = 0);

  /// A view and an accessor over it; returns the accessor's index.
  template <class T>
  int add_accessor(const std::vector<T>& values, const char* type, int component_type,
                   std::size_t components, bool normalized = false, std::size_t stride = 0) {
    const int view = add_view(values.data(), values.size() * sizeof(T), stride);
    const std::size_t element = stride != 0 ? stride / sizeof(T) : components;
    return add_accessor_over(view, values.size() / element, type, component_type, normalized);
  }
  int add_accessor_over(int view, std::size_t count, const char* type, int component_type,
                        bool normalized = false);

  int add_vec3(const std::vector<float>& values) {
    return add_accessor(values, "VEC3", k_float, 3);
  }
  int add_vec2(const std::vector<float>& values) {
    return add_accessor(values, "VEC2", k_float, 2);
  }
  int add_indices(const std::vector<std::uint16_t>& values) {
    return add_accessor(values, "SCALAR", k_ushort, 1);
  }

  /// Adds an object to a top-level array; returns its index.
  int add(const char* array, const json& object);

  /// Adds an extension's name to extensionsUsed and, if asked for, to extensionsRequired.
  void use(const char* extension, bool is_required = false);

  /// Adds a mesh of one primitive and a node that shows it in scene 0; returns the node's index.
  int add_mesh_node(const json& primitive, const json& node = json::object());

  /// A unit square in the xy plane, facing +z, with normals and texture coordinates.
  json square_primitive();

  /// Adds a data URI picture of 8-bit RGBA pixels as image and texture; returns the texture's
  /// index.
  int add_texture(int width, int height, const std::vector<std::uint8_t>& rgba,
                  const json& sampler = json::object());

  std::string to_text() const; ///< the buffer as a data URI
  std::vector<std::uint8_t> to_glb() const;
  Result<scene::Scene> load() const;     ///< through load_gltf_memory, as text
  Result<scene::Scene> load_glb() const; ///< the same as .glb
};

std::string base64(const std::vector<std::uint8_t>& bytes);

/// An uncompressed PNG.
std::vector<std::uint8_t> make_png(int width, int height, const std::vector<std::uint8_t>& rgba);

/// Loads bytes under the name "test.gltf".
Result<scene::Scene> load_bytes(const std::vector<std::uint8_t>& bytes);

/// Whether loading fails with a message that begins with "test.gltf: " and contains `part`, on one
/// line.
bool fails_naming(const Result<scene::Scene>& result, const std::string& part);

/// Whether one warning contains `part`.
bool warns_about(const scene::Scene& scene, const std::string& part);

double area_of(const scene::Mesh& mesh);

} // namespace openltc::test
