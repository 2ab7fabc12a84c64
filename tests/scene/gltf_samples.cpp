// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "gltf_samples.h"

#ifdef OPENLTC_HAVE_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include <cmath>

namespace openltc::test {

namespace {

GltfBuilder lights_and_cameras() {
  GltfBuilder file;
  file.use("KHR_lights_punctual");
  file.use("EXT_lights_area");
  file.root["extensions"]["KHR_lights_punctual"]["lights"] =
      json::array({{{"type", "point"}, {"intensity", 10}},
                   {{"type", "spot"},
                    {"range", 5},
                    {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.4}}}},
                   {{"type", "directional"}, {"color", {1, 0.9, 0.8}}}});
  file.root["extensions"]["EXT_lights_area"]["lights"] =
      json::array({{{"type", "rect"}, {"size", 2}, {"rect", {{"aspect", 1.5}}}},
                   {{"type", "disk"}, {"size", 1}, {"intensity", 200}}});
  file.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}});
  file.add("cameras", {{"type", "orthographic"},
                       {"orthographic", {{"xmag", 2}, {"ymag", 1}, {"znear", 0}, {"zfar", 9}}}});
  for (int i = 0; i < 3; ++i) {
    json node = {{"translation", {i, 1, 0}}, {"rotation", {0, 0.6, 0, 0.8}}};
    node["extensions"]["KHR_lights_punctual"]["light"] = i;
    if (i < 2) {
      node["camera"] = i;
      node["extensions"]["EXT_lights_area"]["light"] = i;
    }
    const int index = file.add("nodes", node);
    file.root["scenes"][0]["nodes"].push_back(index);
  }
  return file;
}

GltfBuilder textured_hierarchy() {
  GltfBuilder file;
  file.use("KHR_texture_transform");
  file.use("KHR_materials_specular");
  const int texture =
      file.add_texture(2, 2, std::vector<std::uint8_t>(16, 200), {{"wrapS", 33071}});
  json info = {{"index", texture}};
  json moved = info;
  moved["extensions"]["KHR_texture_transform"] = {
      {"offset", {0.1, 0.2}}, {"rotation", 0.3}, {"scale", {2, 2}}};
  json primitive = file.square_primitive();
  primitive["material"] = file.add(
      "materials",
      {{"pbrMetallicRoughness", {{"baseColorTexture", moved}, {"metallicRoughnessTexture", info}}},
       {"normalTexture", info},
       {"emissiveTexture", info},
       {"emissiveFactor", {1, 0, 0}},
       {"extensions",
        {{"KHR_materials_specular", {{"specularTexture", info}, {"specularColorTexture", moved}}},
         {"KHR_materials_emissive_strength", {{"emissiveStrength", 3}}},
         {"KHR_materials_ior", {{"ior", 1.4}}}}}});
  primitive["attributes"]["COLOR_0"] =
      file.add_accessor(std::vector<std::uint8_t>(16, 99), "VEC4", k_ubyte, 4, true);
  const int child = file.add_mesh_node(primitive, {{"scale", {1, -2, 1}}});
  const int parent =
      file.add("nodes", {{"children", {child}},
                         {"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}});
  file.root["scenes"][0]["nodes"] = {parent};
  return file;
}

GltfBuilder strips_and_sparse() {
  GltfBuilder file;
  file.use("KHR_mesh_quantization", true);
  const std::vector<std::int16_t> grid = {0, 0, 0, 0, 9, 0, 0, 0,  0, 9,
                                          0, 0, 9, 9, 0, 0, 0, 18, 3, 0};
  const int positions = file.add_accessor(grid, "VEC3", k_short, 3, false, 8);
  const std::vector<std::uint8_t> where = {2, 0, 0, 0};
  const std::vector<std::int16_t> what = {1, 9, 2, 0};
  const int where_view = file.add_view(where.data(), 4);
  const int what_view = file.add_view(what.data(), 8);
  file.root["accessors"][positions]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", where_view}, {"componentType", k_ubyte}}},
      {"values", {{"bufferView", what_view}}}};
  const int material =
      file.add("materials", {{"emissiveFactor", {1, 1, 1}}, {"doubleSided", true}});
  for (const int mode : {5, 6})
    file.add_mesh_node(
        {{"attributes", {{"POSITION", positions}}}, {"mode", mode}, {"material", material}});
  return file;
}

// Lights in extras, in all three forms, and an emissive disk and a square.
GltfBuilder lights_in_extras() {
  GltfBuilder file;
  const json lights[] = {
      {{"type", "sphere"}, {"radius", 0.2}, {"luminance_nits", 4000}, {"color", {1, 0.5, 0}}},
      {{"type", "tube"}, {"radius", 0.2}, {"length", 1}, {"caps", "flat"}, {"flux_lumens", 5}},
      {{"type", "polygon"},
       {"points", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}},
       {"holes", {{{1, 1}, {2, 1}, {2, 2}}}},
       {"intensity_candela", 3},
       {"two_sided", true}},
      {{"type", "spot"}, {"inner_cone_degrees", 10}, {"flux_lumens", 5}},
      {{"type", "ellipse"}, {"radius_x", 1}, {"radius_y", 2}, {"luminance_nits", 5}},
  };
  const int glow = file.add("materials", {{"emissiveFactor", {1, 1, 1}}});
  json square = file.square_primitive();
  square["material"] = glow;
  for (const json& light : lights) {
    file.add_mesh_node(square, {{"extras", {{"openltc_light", light}}}, {"scale", {2, 2, 2}}});
    file.add_mesh_node(square, {{"extras", {{"openltc_light", light.dump()}}}});
  }
  file.add_mesh_node(square, {{"extras", {{"openltc_emits_light", 0}}}});
  std::vector<float> points = {0, 0, 0};
  std::vector<std::uint16_t> indices;
  for (std::uint16_t i = 0; i < 24; ++i) {
    points.insert(points.end(),
                  {std::cos(float(i) * 0.2617994f), std::sin(float(i) * 0.2617994f), 0});
    indices.insert(indices.end(), {0, std::uint16_t(1 + i), std::uint16_t(1 + (i + 1) % 24)});
  }
  file.add_mesh_node({{"attributes", {{"POSITION", file.add_vec3(points)}}},
                      {"indices", file.add_indices(indices)},
                      {"material", glow}},
                     {{"extras", {{"openltc_surface_deviation", 0.1}}}});
  return file;
}

#ifdef OPENLTC_HAVE_MESHOPTIMIZER
GltfBuilder compressed() {
  GltfBuilder file;
  file.use("EXT_meshopt_compression", true);
  const float square[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  meshopt_encodeVertexVersion(0);
  std::vector<std::uint8_t> packed(meshopt_encodeVertexBufferBound(4, 12));
  packed.resize(meshopt_encodeVertexBuffer(packed.data(), packed.size(), square, 4, 12));
  const int view = file.add_view(packed.data(), packed.size());
  json& v = file.root["bufferViews"][view];
  v["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                {"byteOffset", v["byteOffset"]},
                                                {"byteLength", packed.size()},
                                                {"byteStride", 12},
                                                {"count", 4},
                                                {"mode", "ATTRIBUTES"},
                                                {"filter", "NONE"}};
  v["byteLength"] = 48;
  const int positions = file.add_accessor_over(view, 4, "VEC3", k_float);
  file.add_mesh_node({{"attributes", {{"POSITION", positions}}}, {"mode", 5}});
  return file;
}
#endif

} // namespace

std::vector<GltfBuilder> make_samples() {
  std::vector<GltfBuilder> samples = {lights_and_cameras(), textured_hierarchy(),
                                      strips_and_sparse(), lights_in_extras()};
#ifdef OPENLTC_HAVE_MESHOPTIMIZER
  samples.push_back(compressed());
#endif
  return samples;
}

} // namespace openltc::test
