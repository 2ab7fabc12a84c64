// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// KHR_draco_mesh_compression and EXT_meshopt_compression.

#include "gltf_builder.h"

#ifdef OPENLTC_HAVE_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

namespace {

using namespace openltc;
using namespace openltc::test;

std::vector<std::uint8_t> shared_file(const char* name) {
  const std::string path = std::string(OPENLTC_SHARED_DIR) + "/scenes/" + name;
  std::ifstream file(path, std::ios::binary);
  if (!file) MESSAGE("skipped: " << path << " is not there");
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST_CASE("draco_meshes_are_decoded") {
  const struct {
    const char* name;
    std::size_t triangles;
  } files[] = {{"bunny.glb", 5648}, {"suzi.glb", 14842}};
  for (const auto& [name, triangles] : files) {
    const auto bytes = shared_file(name);
    if (bytes.empty()) continue;
    const auto loaded = load_bytes(bytes);
    REQUIRE(loaded.ok());
    REQUIRE(loaded->meshes.size() == 1);
    const scene::Mesh& mesh = loaded->meshes[0];
    CHECK(mesh.triangles.size() == triangles);
    // the file's own normals agree with the triangles, and the surface is as large as a model of
    // about two metres can be
    double agreement = 0;
    for (const auto& t : mesh.triangles) {
      const Vec3f n = cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                            mesh.positions[t[2]] - mesh.positions[t[0]]);
      agreement += double(dot(n, mesh.normals[t[0]])) / double(length(n));
    }
    CHECK(agreement / double(triangles) > 0.9);
    CHECK(area_of(mesh) > 1);
    CHECK(area_of(mesh) < 30);
  }
}

TEST_CASE("damaged_draco_data_is_refused_and_never_crashes") {
  const auto whole = shared_file("bunny.glb");
  if (whole.empty()) return;
  const std::size_t json_size = std::size_t(whole[12]) | std::size_t(whole[13]) << 8;
  const std::size_t data = 20 + json_size + 8;
  for (std::size_t i = data; i < whole.size(); i += 97) {
    auto damaged = whole;
    damaged[i] = std::uint8_t(~damaged[i]);
    const auto loaded = load_bytes(damaged);
    if (!loaded.ok()) CHECK(loaded.error().message.find("test.gltf: ") == 0);
  }
  auto header = whole;
  header[data] = 'X';
  CHECK(fails_naming(load_bytes(header),
                     "meshes[0].primitives[0].extensions.KHR_draco_mesh_compression"));
}

#ifdef OPENLTC_HAVE_MESHOPTIMIZER

using Bytes = std::vector<std::uint8_t>;

// Turns a plain view into a compressed one, without a copy that is not compressed.
void compress_view(GltfBuilder& file, int view, const Bytes& packed, std::size_t count,
                   std::size_t stride, const char* mode, const char* filter = nullptr) {
  while (file.buffer.size() % 4 != 0)
    file.buffer.push_back(0);
  json& v = file.root["bufferViews"][view];
  v["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                {"byteOffset", file.buffer.size()},
                                                {"byteLength", packed.size()},
                                                {"byteStride", stride},
                                                {"count", count},
                                                {"mode", mode}};
  if (filter) v["extensions"]["EXT_meshopt_compression"]["filter"] = filter;
  v["buffer"] = 1;
  v["byteOffset"] = 0;
  v["byteLength"] = count * stride;
  file.buffer.insert(file.buffer.end(), packed.begin(), packed.end());
}

Bytes pack_vertices(const void* data, std::size_t count, std::size_t stride) {
  meshopt_encodeVertexVersion(0);
  Bytes packed(meshopt_encodeVertexBufferBound(count, stride));
  packed.resize(meshopt_encodeVertexBuffer(packed.data(), packed.size(), data, count, stride));
  return packed;
}

Result<scene::Scene> load_with_fallback_buffer(GltfBuilder& file) {
  const json fallback = {{"EXT_meshopt_compression", {{"fallback", true}}}};
  file.root["buffers"] = json::array(
      {{{"byteLength", file.buffer.size()}}, {{"byteLength", 4096}, {"extensions", fallback}}});
  return file.load_glb();
}

constexpr std::size_t k_grid = 9;

// A grid of squares over the xy plane: positions, triangle list.
void make_grid(std::vector<float>& positions, std::vector<std::uint32_t>& corners) {
  for (std::size_t y = 0; y < k_grid; ++y)
    for (std::size_t x = 0; x < k_grid; ++x)
      positions.insert(positions.end(), {float(x), float(y), 0.0f});
  for (std::uint32_t y = 0; y + 1 < k_grid; ++y)
    for (std::uint32_t x = 0; x + 1 < k_grid; ++x) {
      const std::uint32_t a = y * k_grid + x, b = a + 1, c = a + k_grid, d = c + 1;
      corners.insert(corners.end(), {a, b, d, a, d, c});
    }
}

TEST_CASE("meshopt_attributes_and_indices_of_both_modes_are_decoded") {
  for (const char* mode : {"TRIANGLES", "INDICES"}) {
    for (const std::size_t index_size : {2, 4}) {
      GltfBuilder file;
      file.use("EXT_meshopt_compression", true);
      std::vector<float> positions;
      std::vector<std::uint32_t> corners;
      make_grid(positions, corners);
      const std::size_t vertices = positions.size() / 3;
      const int position_accessor = file.add_vec3(positions);
      const int index_view = file.add_view(corners.data(), corners.size() * index_size);
      const int index_accessor = file.add_accessor_over(index_view, corners.size(), "SCALAR",
                                                        index_size == 2 ? k_ushort : k_uint);
      file.add_mesh_node(
          {{"attributes", {{"POSITION", position_accessor}}}, {"indices", index_accessor}});
      file.buffer.clear(); // nothing uncompressed is left
      compress_view(file, 0, pack_vertices(positions.data(), vertices, 12), vertices, 12,
                    "ATTRIBUTES");
      Bytes packed;
      if (std::string(mode) == "TRIANGLES") {
        meshopt_encodeIndexVersion(1);
        packed.resize(meshopt_encodeIndexBufferBound(corners.size(), vertices));
        packed.resize(meshopt_encodeIndexBuffer(packed.data(), packed.size(), corners.data(),
                                                corners.size()));
      } else {
        packed.resize(meshopt_encodeIndexSequenceBound(corners.size(), vertices));
        packed.resize(meshopt_encodeIndexSequence(packed.data(), packed.size(), corners.data(),
                                                  corners.size()));
      }
      compress_view(file, index_view, packed, corners.size(), index_size, mode);
      const auto loaded = load_with_fallback_buffer(file);
      if (!loaded.ok()) FAIL(loaded.error().message);
      CHECK(loaded->meshes.at(0).triangles.size() == corners.size() / 3);
      CHECK(area_of(loaded->meshes[0]) == doctest::Approx(64.0));
      CHECK(loaded->meshes[0].normals[0].z == doctest::Approx(1.0f));
    }
  }
}

// The filter's definition, EXT_meshopt_compression, "EXPONENTIAL": 24 bits of mantissa m and 8 of
// exponent e, both signed, stand for m 2^e. (meshopt_encodeFilterExp changed its arguments in
// 0.19.)
void put_exponential(float value, std::uint8_t* four_bytes) {
  int exponent = 0;
  const float fraction = std::frexp(value, &exponent); // below 1
  const std::int32_t mantissa = std::int32_t(std::lround(std::ldexp(fraction, 19)));
  const std::uint32_t high = std::uint32_t(exponent - 19) << 24;
  const std::uint32_t bits = high | (std::uint32_t(mantissa) & 0xFFFFFFu);
  std::memcpy(four_bytes, &bits, 4);
}

TEST_CASE("meshopt_filters_are_undone") {
  const std::size_t count = 4;
  const auto load_filtered = [&](const char* filter, const void* encoded, std::size_t stride,
                                 const char* attribute, const char* type, int component_type,
                                 bool normalized) {
    GltfBuilder file;
    file.use("EXT_meshopt_compression", true);
    json primitive = file.square_primitive();
    const int view = file.add_view(encoded, count * stride, stride);
    primitive["attributes"][attribute] =
        file.add_accessor_over(view, count, type, component_type, normalized);
    const int texture = file.add_texture(1, 1, {128, 128, 255, 255});
    primitive["material"] = file.add("materials", {{"normalTexture", {{"index", texture}}}});
    file.add_mesh_node(primitive);
    compress_view(file, view, pack_vertices(encoded, count, stride), count, stride, "ATTRIBUTES",
                  filter);
    auto loaded = load_with_fallback_buffer(file);
    if (!loaded.ok()) FAIL(loaded.error().message);
    return loaded->meshes.at(0);
  };
  SUBCASE("octahedral") {
    const float directions[16] = {0, 0,     1,    1,  0.6f,  0,    0.8f,  1,
                                  0, -0.6f, 0.8f, -1, 0.48f, 0.6f, 0.64f, 1};
    for (const std::size_t stride : {4, 8}) {
      Bytes encoded(count * stride);
      meshopt_encodeFilterOct(encoded.data(), count, stride, stride == 4 ? 8 : 16, directions);
      const scene::Mesh mesh = load_filtered("OCTAHEDRAL", encoded.data(), stride, "NORMAL", "VEC3",
                                             stride == 4 ? k_byte : k_short, true);
      for (std::size_t i = 0; i < count; ++i)
        CHECK(length(mesh.normals[i] -
                     Vec3f(directions[4 * i], directions[4 * i + 1], directions[4 * i + 2])) <
              (stride == 4 ? 0.02f : 2e-4f));
    }
  }
  SUBCASE("quaternion") {
    // Read as tangents, to be seen at all: x y z become a direction across the normal.
    const float s = std::sqrt(0.5f);
    const float rotations[16] = {s, 0, 0, s, 0, s, 0, s, 0.6f, 0, 0, 0.8f, 0, 0.6f, 0, 0.8f};
    Bytes encoded(count * 8);
    meshopt_encodeFilterQuat(encoded.data(), count, 8, 16, rotations);
    const scene::Mesh mesh =
        load_filtered("QUATERNION", encoded.data(), 8, "TANGENT", "VEC4", k_short, true);
    CHECK(length(Vec3f(mesh.tangents[0].x, mesh.tangents[0].y, mesh.tangents[0].z) -
                 Vec3f(1, 0, 0)) < 1e-3f);
    CHECK(length(Vec3f(mesh.tangents[3].x, mesh.tangents[3].y, mesh.tangents[3].z) -
                 Vec3f(0, 1, 0)) < 1e-3f);
  }
  SUBCASE("exponential") {
    const float positions[12] = {0, 0, 0, 3.5f, 0, 0, 3.5f, 1024.25f, 0, 0, 1024.25f, 0};
    Bytes encoded(count * 12);
    for (std::size_t i = 0; i < std::size(positions); ++i)
      put_exponential(positions[i], encoded.data() + 4 * i);
    const scene::Mesh mesh =
        load_filtered("EXPONENTIAL", encoded.data(), 12, "POSITION", "VEC3", k_float, false);
    CHECK(mesh.positions[2].x == doctest::Approx(3.5f).epsilon(0.001));
    CHECK(mesh.positions[2].y == doctest::Approx(1024.25f).epsilon(0.001));
  }
}

TEST_CASE("damaged_meshopt_data_is_refused_by_field") {
  const auto load_changed = [](const std::function<void(GltfBuilder&, json&)>& change) {
    GltfBuilder file;
    std::vector<float> positions;
    std::vector<std::uint32_t> corners;
    make_grid(positions, corners);
    std::vector<std::uint16_t> indices(corners.begin(), corners.end());
    const int position_accessor = file.add_vec3(positions);
    file.add_mesh_node({{"attributes", {{"POSITION", position_accessor}}},
                        {"indices", file.add_indices(indices)}});
    compress_view(file, 0, pack_vertices(positions.data(), 81, 12), 81, 12, "ATTRIBUTES");
    change(file, file.root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]);
    return load_with_fallback_buffer(file);
  };
  const char* field = "bufferViews[0].extensions.EXT_meshopt_compression";
  CHECK(load_changed([](GltfBuilder&, json&) {}).ok());
  CHECK(fails_naming(load_changed([](GltfBuilder&, json& e) { e["byteLength"] = 20; }), field));
  CHECK(
      fails_naming(load_changed([](GltfBuilder&, json& e) { e["byteLength"] = 1 << 30; }), field));
  CHECK(fails_naming(load_changed([](GltfBuilder&, json& e) { e["byteStride"] = 7; }), field));
  CHECK(fails_naming(load_changed([](GltfBuilder&, json& e) { e["byteStride"] = 1024; }), field));
  CHECK(fails_naming(load_changed([](GltfBuilder&, json& e) { e["count"] = 2000000000; }), field));
  CHECK(fails_naming(load_changed([](GltfBuilder&, json& e) { e["count"] = 0; }), field));
  // By the stream's size this many elements might be, but not elements as long as that.
  CHECK(fails_naming(load_changed([](GltfBuilder&, json& e) {
                       e["byteStride"] = 256;
                       e["count"] = e["byteLength"].get<std::size_t>() * 1024;
                     }),
                     "cannot come from"));
  CHECK(fails_naming(load_changed([](GltfBuilder&, json& e) { e["mode"] = "TRIANGLES"; }), field));
  CHECK(
      fails_naming(load_changed([](GltfBuilder&, json& e) { e["filter"] = "QUATERNION"; }), field));
  CHECK(fails_naming(load_changed([](GltfBuilder&, json& e) { e["buffer"] = 5; }), field));
  CHECK(fails_naming(load_changed([](GltfBuilder& f, json& e) {
                       f.buffer[e["byteOffset"].get<std::size_t>()] = 0;
                     }),
                     field));
}

#endif

} // namespace
