// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Broken files end in one line that names the file and the field.

#include "gltf_builder.h"

#include <doctest/doctest.h>

#include <functional>
#include <limits>

namespace {

using namespace openltc;
using namespace openltc::test;

std::vector<std::uint8_t> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

// A small file with everything in it that an index can point at.
GltfBuilder complete_file() {
  GltfBuilder file;
  const int texture = file.add_texture(1, 1, {255, 255, 255, 255});
  json primitive = file.square_primitive();
  primitive["material"] = file.add(
      "materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
  file.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}});
  file.root["extensions"]["KHR_lights_punctual"]["lights"] = json::array({{{"type", "point"}}});
  file.add_mesh_node(primitive,
                     {{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  return file;
}

// Loads the complete file with one place of its JSON changed.
Result<scene::Scene> load_with(const char* pointer, const json& value) {
  GltfBuilder file = complete_file();
  file.root["buffers"] = json::array({{{"byteLength", file.buffer.size()}}}); // the binary chunk
  file.root[json::json_pointer(pointer)] = value;
  return file.load_glb();
}

TEST_CASE("the_complete_file_loads") {
  const auto loaded = load_with("/asset/generator", "test");
  if (!loaded.ok()) FAIL(loaded.error().message);
  CHECK(loaded->warnings.empty());
}

TEST_CASE("what_is_no_gltf_file_is_refused") {
  CHECK(fails_naming(load_bytes({}), "empty"));
  CHECK(fails_naming(load_bytes(bytes_of("hello")), "not a glTF file"));
  CHECK(fails_naming(load_bytes(bytes_of("{")), "JSON"));
  CHECK(fails_naming(load_bytes(bytes_of("{}")), "asset"));
  CHECK(fails_naming(load_bytes(bytes_of("{\"asset\":{\"version\":\"1.0\"}}")), "asset.version"));
  CHECK(fails_naming(load_bytes(bytes_of("{\"asset\":{\"version\":\"2.0\"}, \"scene\": 1e999}")),
                     "JSON"));
  CHECK(fails_naming(load_bytes(bytes_of("glTF")), "cut short"));
  CHECK(fails_naming(load_bytes(bytes_of("{\"a\":" + std::string(100000, '['))), "nested"));
  CHECK(fails_naming(load_bytes(bytes_of("{\"asset\":{\"version\":\"2.0\"},\"x\":\"\xff\"}")),
                     "JSON"));
  auto old_version = complete_file().to_glb();
  old_version[4] = 1;
  CHECK(fails_naming(load_bytes(old_version), "version 1"));
}

TEST_CASE("missing_files_and_folders_are_refused") {
  const auto missing = scene::load_gltf("/nonexistent/scene.glb");
  REQUIRE(!missing.ok());
  CHECK(missing.error().message.find("/nonexistent/scene.glb") == 0);
  CHECK(!scene::load_gltf("/").ok());
  CHECK(!scene::load_gltf("").ok());
}

TEST_CASE("a_glb_cut_at_any_length_is_refused") {
  const auto whole = complete_file().to_glb();
  REQUIRE(load_bytes(whole).ok());
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const auto cut = load_bytes({whole.begin(), whole.begin() + std::ptrdiff_t(length)});
    REQUIRE_MESSAGE(!cut.ok(), "length " << length);
  }
}

TEST_CASE("a_text_file_cut_at_any_length_is_refused") {
  const std::string whole = complete_file().to_text();
  for (std::size_t length = 0; length < whole.size(); ++length)
    REQUIRE_MESSAGE(!load_bytes(bytes_of(whole.substr(0, length))).ok(), "length " << length);
}

TEST_CASE("every_index_is_checked_and_named") {
  const struct {
    const char* pointer;
    const char* field;
  } places[] = {
      {"/scene", "scene"},
      {"/scenes/0/nodes/0", "scenes[0].nodes[0]"},
      {"/nodes/0/mesh", "nodes[0].mesh"},
      {"/nodes/0/camera", "nodes[0].camera"},
      {"/nodes/0/skin", "nodes[0].skin"},
      {"/nodes/0/children", "nodes[0].children"},
      {"/nodes/0/extensions/KHR_lights_punctual/light", "nodes[0].extensions.KHR_lights_punctual"},
      {"/meshes/0/primitives/0/attributes/POSITION", "primitives[0].attributes.POSITION"},
      {"/meshes/0/primitives/0/attributes/NORMAL", "primitives[0].attributes.NORMAL"},
      {"/meshes/0/primitives/0/indices", "meshes[0].primitives[0].indices"},
      {"/meshes/0/primitives/0/material", "meshes[0].primitives[0].material"},
      {"/materials/0/pbrMetallicRoughness/baseColorTexture/index", "baseColorTexture.index"},
      {"/textures/0/source", "textures[0].source"},
      {"/textures/0/sampler", "textures[0].sampler"},
      {"/images/0/bufferView", "images[0].bufferView"},
      {"/accessors/0/bufferView", "accessors[0].bufferView"},
      {"/bufferViews/0/buffer", "bufferViews[0].buffer"},
  };
  for (const auto& place : places) {
    CAPTURE(place.pointer);
    for (const json& bad : {json(99), json(-1), json(2147483647), json(4294967296), json(1e300),
                            json(0.5), json("0"), json(nullptr), json(true)}) {
      const bool is_list = std::string(place.pointer).find("children") != std::string::npos;
      CHECK(
          fails_naming(load_with(place.pointer, is_list ? json::array({bad}) : bad), place.field));
    }
  }
}

TEST_CASE("wrong_types_are_named") {
  const struct {
    const char* pointer;
    json value;
    const char* field;
  } places[] = {
      {"/nodes", 3, "nodes"},
      {"/nodes/0", "a", "nodes[0]"},
      {"/nodes/0/matrix", {1, 2, 3}, "nodes[0].matrix"},
      {"/nodes/0/scale", "big", "nodes[0].scale"},
      {"/nodes/0/scale", {1, "2", 3}, "nodes[0].scale[1]"},
      {"/nodes/0/translation", {1e40, 0, 0}, "nodes[0].translation[0]"},
      {"/nodes/0/name", 7, "nodes[0].name"},
      {"/meshes/0/primitives", json::object(), "meshes[0].primitives"},
      {"/meshes/0/primitives/0/attributes", {1}, "primitives[0].attributes"},
      {"/meshes/0/primitives/0/mode", 9, "primitives[0].mode"},
      {"/accessors/0/type", "VEC9", "accessors[0].type"},
      {"/accessors/0/componentType", 5124, "accessors[0].componentType"},
      {"/materials/0/alphaMode", "GLASS", "materials[0].alphaMode"},
      {"/materials/0/doubleSided", 1, "materials[0].doubleSided"},
      {"/bufferViews/0/byteStride", 5, "bufferViews[0].byteStride"},
      {"/extensionsUsed", {3}, "extensionsUsed[0]"},
      {"/cameras/0/type", "fisheye", "cameras[0].type"},
  };
  for (const auto& place : places) {
    CAPTURE(place.pointer);
    CHECK(fails_naming(load_with(place.pointer, place.value), place.field));
  }
}

TEST_CASE("ranges_are_checked_before_anything_is_allocated") {
  for (const json& huge : {json(100), json(1000000), json(4294967296), json(9007199254740992)}) {
    CHECK(fails_naming(load_with("/accessors/0/count", huge), "accessors[0].count"));
    CHECK(fails_naming(load_with("/accessors/0/byteOffset", huge), "accessors[0].count"));
    CHECK(fails_naming(load_with("/bufferViews/0/byteOffset", json(huge.get<double>() + 400)),
                       "bufferViews[0].byte"));
    CHECK(fails_naming(load_with("/bufferViews/0/byteLength", json(huge.get<double>() + 400)),
                       "bufferViews[0].byteLength"));
    CHECK(fails_naming(load_with("/buffers/0/byteLength", json(huge.get<double>() + 400)),
                       "buffers[0].byteLength"));
  }
  CHECK(fails_naming(load_with("/accessors/0/count", 0), "accessors[0].count"));
  CHECK(fails_naming(load_with("/bufferViews/0/byteStride", 4), "bufferViews[0].byteStride"));
  // no data at all
  GltfBuilder file = complete_file();
  file.root["accessors"][0].erase("bufferView");
  file.root["accessors"][0]["count"] = 4000000000u;
  CHECK(fails_naming(file.load(), "accessors[0].count"));
}

TEST_CASE("sparse_accessors_are_checked") {
  const auto load_sparse = [](const json& sparse) {
    GltfBuilder file = complete_file();
    const std::vector<std::uint16_t> where = {0, 60000};
    file.add_view(where.data(), 4);
    file.root["accessors"][0]["sparse"] = sparse;
    return file.load();
  };
  GltfBuilder reference = complete_file();
  const int view = int(reference.root["bufferViews"].size());
  const json indices = {{"bufferView", view}, {"componentType", k_ushort}};
  const json values = {{"bufferView", 0}};
  CHECK(load_sparse({{"count", 1}, {"indices", indices}, {"values", values}}).ok());
  CHECK(fails_naming(load_sparse({{"count", 2}, {"indices", indices}, {"values", values}}),
                     "accessors[0].sparse.indices: element 60000"));
  CHECK(fails_naming(load_sparse({{"count", 3}, {"indices", indices}, {"values", values}}),
                     "accessors[0].sparse.indices"));
  CHECK(fails_naming(load_sparse({{"count", 5}, {"indices", indices}, {"values", values}}),
                     "accessors[0].sparse.count"));
  CHECK(fails_naming(load_sparse({{"count", 1}, {"indices", indices}}),
                     "accessors[0].sparse.values"));
  CHECK(fails_naming(load_sparse({{"count", 1},
                                  {"indices", {{"bufferView", 99}, {"componentType", k_ushort}}},
                                  {"values", values}}),
                     "accessors[0].sparse.indices.bufferView"));
}

TEST_CASE("attributes_must_fit_together") {
  GltfBuilder file = complete_file();
  file.root["accessors"][1]["count"] = 3;
  CHECK(fails_naming(file.load(), "attributes.NORMAL: has 3 vertices but POSITION has 4"));
  GltfBuilder wrong_type = complete_file();
  wrong_type.root["accessors"][0]["type"] = "VEC2";
  CHECK(fails_naming(wrong_type.load(), "attributes.POSITION"));
  GltfBuilder out_of_range = complete_file();
  out_of_range.root["accessors"][0]["count"] = 3;
  out_of_range.root["accessors"][1]["count"] = 3;
  out_of_range.root["accessors"][2]["count"] = 3;
  CHECK(fails_naming(out_of_range.load(), "meshes[0].primitives[0].indices"));
  GltfBuilder float_indices = complete_file();
  float_indices.root["meshes"][0]["primitives"][0]["indices"] = 0;
  CHECK(fails_naming(float_indices.load(), "accessors[0].type"));
}

TEST_CASE("positions_that_are_not_numbers_or_absurd_are_refused") {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f}) {
    GltfBuilder file;
    json primitive = file.square_primitive();
    primitive["attributes"]["POSITION"] = file.add_vec3({0, 0, 0, 1, 0, bad, 1, 1, 0, 0, 1, 0});
    file.add_mesh_node(primitive);
    CHECK(!file.load().ok());
  }
  CHECK(fails_naming(load_with("/nodes/0/scale", {1e30, 1e30, 1e30}), "nodes[0]"));
}

TEST_CASE("cycles_and_nodes_with_two_parents_are_refused") {
  const auto load_nodes = [](const json& nodes, const json& roots) {
    GltfBuilder file;
    file.root["nodes"] = nodes;
    file.root["scenes"][0]["nodes"] = roots;
    return file.load();
  };
  CHECK(fails_naming(load_nodes({{{"children", {0}}}}, {0}), "nodes[0].children"));
  CHECK(
      fails_naming(load_nodes({{{"children", {1}}}, {{"children", {2}}}, {{"children", {0}}}}, {0}),
                   "].children"));
  CHECK(fails_naming(load_nodes({{{"children", {2}}}, {{"children", {2}}}, json::object()}, {0, 1}),
                     "nodes[1].children"));
  CHECK(
      fails_naming(load_nodes({{{"children", {1, 1}}}, json::object()}, {0}), "nodes[0].children"));
  CHECK(fails_naming(load_nodes({json::object()}, {0, 0}), "nodes[0]"));
  // a long chain is refused instead of exhausting anything
  json chain = json::array();
  for (int i = 0; i < 10000; ++i)
    chain.push_back({{"children", {i + 1}}});
  chain.push_back(json::object());
  CHECK(fails_naming(load_nodes(chain, {0}), "nested deeper"));
}

TEST_CASE("references_that_cannot_be_followed_are_named") {
  const auto load_buffer = [](const json& uri) {
    GltfBuilder file = complete_file();
    file.root["buffers"] = json::array({{{"byteLength", file.buffer.size()}, {"uri", uri}}});
    return file.load();
  };
  CHECK(fails_naming(load_buffer("https://example.com/a.bin"), "buffers[0].uri: https://"));
  CHECK(fails_naming(load_buffer("file:///etc/passwd"), "buffers[0].uri"));
  CHECK(fails_naming(load_buffer("/etc/passwd"), "buffers[0].uri: the file /etc/passwd"));
  CHECK(fails_naming(load_buffer("missing.bin"), "buffers[0].uri: the file missing.bin"));
  CHECK(fails_naming(load_buffer("data:application/octet-stream;base64,!!!"), "buffers[0].uri"));
  CHECK(fails_naming(load_buffer("data:application/octet-stream;base64,AAAA"),
                     "buffers[0].byteLength"));
  CHECK(fails_naming(load_buffer("data:nonsense"), "buffers[0].uri"));
  CHECK(fails_naming(load_buffer(""), "buffers[0].uri"));
  CHECK(fails_naming(load_buffer(17), "buffers[0].uri"));
  // relative ones need a folder, and are looked for there
  GltfBuilder file = complete_file();
  file.root["buffers"] = json::array({{{"byteLength", 4}, {"uri", "a%20missing.bin"}}});
  const std::string text = file.to_text();
  const auto loaded = scene::load_gltf_memory(bytes_of(text), "test.gltf", "/tmp");
  CHECK(fails_naming(loaded, "/tmp/a missing.bin is missing"));
}

TEST_CASE("missing_and_damaged_pictures_are_named_and_spared") {
  const auto warns = [](const json& image, const char* field) {
    GltfBuilder file = complete_file();
    file.root["images"][0] = image;
    const auto loaded = file.load();
    return loaded.ok() && loaded->textures.empty() && warns_about(*loaded, field);
  };
  CHECK(warns({{"uri", "missing.png"}}, "images[0].uri"));
  CHECK(warns({{"uri", "data:image/png;base64,AAAA"}}, "images[0]"));
  CHECK(warns({{"bufferView", 0}}, "images[0]"));
  CHECK(warns(json::object(), "images[0]"));
  // a picture that claims to be huge is refused before it is decoded
  auto png = make_png(1, 1, {0, 0, 0, 0});
  png[16] = 0x7F;
  CHECK(warns({{"uri", "data:image/png;base64," + base64(png)}}, "images[0]"));
}

} // namespace
