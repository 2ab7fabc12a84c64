// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "gltf_builder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace openltc;
using namespace openltc::test;

// The triangles' corner positions, for comparing meshes whatever their indexing.
std::vector<std::vector<float>> soup(const scene::Mesh& mesh) {
  std::vector<std::vector<float>> triangles;
  for (const auto& t : mesh.triangles) {
    // start with the smallest corner, keep the winding
    std::size_t first = 0;
    const auto key = [&](std::size_t c) {
      const Vec3f p = mesh.positions[t[c]];
      return std::vector<float>{p.x, p.y, p.z};
    };
    for (std::size_t c = 1; c < 3; ++c)
      if (key(c) < key(first)) first = c;
    std::vector<float> values;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto k = key((first + c) % 3);
      values.insert(values.end(), k.begin(), k.end());
    }
    triangles.push_back(values);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

const std::vector<float> k_hexagon = {0, 0,  0, 2, 0,  0,     1, 1.7f, 0,     -1, 1.7f,
                                      0, -2, 0, 0, -1, -1.7f, 0, 1,    -1.7f, 0};

bool is_near(Vec3f a, Vec3f b, float tolerance = 1e-5f) { return length(a - b) < tolerance; }

TEST_CASE("text_and_binary_containers_give_the_same_scene") {
  GltfBuilder file;
  file.add_mesh_node(file.square_primitive());
  const auto text = file.load();
  const auto binary = file.load_glb();
  REQUIRE(text.ok());
  REQUIRE(binary.ok());
  CHECK(soup(text->meshes[0]) == soup(binary->meshes[0]));
  CHECK(text->warnings.empty());
  CHECK(text->materials.size() == 1);
  CHECK(is_near(text->bounds.upper, Vec3f(1, 1, 0)));
}

TEST_CASE("strips_and_fans_equal_the_list_of_the_same_triangles") {
  const auto load_mode = [](int mode, const std::vector<std::uint16_t>& corners, bool indexed) {
    GltfBuilder file;
    std::vector<float> positions = k_hexagon;
    if (!indexed) {
      positions.clear();
      for (const std::uint16_t c : corners)
        positions.insert(positions.end(), k_hexagon.begin() + 3 * c, k_hexagon.begin() + 3 * c + 3);
    }
    json primitive = {{"attributes", {{"POSITION", file.add_vec3(positions)}}}, {"mode", mode}};
    if (indexed) primitive["indices"] = file.add_indices(corners);
    file.add_mesh_node(primitive);
    const auto loaded = file.load();
    REQUIRE(loaded.ok());
    return soup(loaded->meshes[0]);
  };
  for (const bool indexed : {true, false}) {
    const auto fan_list = load_mode(4, {0, 1, 2, 0, 2, 3, 0, 3, 4}, indexed);
    CHECK(load_mode(6, {0, 1, 2, 3, 4}, indexed) == fan_list);
    const auto strip_list = load_mode(4, {1, 2, 0, 0, 2, 3, 0, 3, 4}, indexed);
    CHECK(load_mode(5, {1, 2, 0, 3, 4}, indexed) ==
          load_mode(4, {1, 2, 0, 2, 3, 0, 0, 3, 4}, indexed));
    CHECK(strip_list.size() == 3);
    // repeated corners turn a strip around without leaving triangles
    CHECK(load_mode(5, {1, 2, 0, 0, 0, 3, 4}, indexed).size() == 2);
  }
}

TEST_CASE("points_and_lines_are_left_out_with_a_warning") {
  GltfBuilder file;
  json points = file.square_primitive();
  points["mode"] = 0;
  file.add_mesh_node(points);
  file.add_mesh_node(file.square_primitive());
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  CHECK(loaded->meshes.size() == 1);
  CHECK(warns_about(*loaded, "points and lines"));
}

TEST_CASE("matrix_and_translation_rotation_scale_agree_and_nest") {
  GltfBuilder by_trs;
  const float s = std::sqrt(0.5f);
  by_trs.add_mesh_node(
      by_trs.square_primitive(),
      {{"translation", {1, 2, 3}}, {"rotation", {0, 0, s, s}}, {"scale", {2, 3, 4}}});
  GltfBuilder by_matrix;
  // quarter turn about z after scaling: x -> 2y, y -> -3x, z -> 4z
  by_matrix.add_mesh_node(by_matrix.square_primitive(),
                          {{"matrix", {0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 4, 0, 1, 2, 3, 1}}});
  GltfBuilder nested;
  const int child = nested.add_mesh_node(nested.square_primitive(), {{"scale", {2, 3, 4}}});
  const int middle = nested.add("nodes", {{"rotation", {0, 0, s, s}}, {"children", {child}}});
  const int top = nested.add("nodes", {{"translation", {1, 2, 3}}, {"children", {middle}}});
  nested.root["scenes"][0]["nodes"] = {top};
  for (const GltfBuilder* file : {&by_trs, &by_matrix, &nested}) {
    const auto loaded = file->load();
    REQUIRE(loaded.ok());
    const scene::Mesh& mesh = loaded->meshes[0];
    CHECK(is_near(mesh.positions[0], Vec3f(1, 2, 3)));
    CHECK(is_near(mesh.positions[1], Vec3f(1, 4, 3)));
    CHECK(is_near(mesh.positions[3], Vec3f(-2, 2, 3)));
    CHECK(is_near(mesh.normals[0], Vec3f(0, 0, 1)));
  }
}

// Geometric normal of the first triangle.
Vec3f facing(const scene::Mesh& mesh) {
  const auto& t = mesh.triangles[0];
  return normalize(cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                         mesh.positions[t[2]] - mesh.positions[t[0]]));
}

TEST_CASE("negative_scale_turns_the_winding_so_that_fronts_stay_fronts") {
  for (const json& scale : {json{-1, 1, 1}, json{1, 1, -1}, json{-2, -3, -1}, json{-1, -1, 1}}) {
    GltfBuilder file;
    file.add_mesh_node(file.square_primitive(), {{"scale", scale}});
    const auto loaded = file.load();
    REQUIRE(loaded.ok());
    const scene::Mesh& mesh = loaded->meshes[0];
    CHECK(dot(facing(mesh), mesh.normals[mesh.triangles[0][0]]) > 0.99f);
    CHECK(mesh.normals[0].z * scale[2].get<float>() > 0);
  }
}

TEST_CASE("normals_follow_the_inverse_transpose") {
  GltfBuilder file;
  // a slope of 45 degrees, stretched by 3 along x: normal (1, 0, 3) / sqrt(10)
  const float s = std::sqrt(0.5f);
  const int positions = file.add_vec3({0, 0, 0, 1, 0, -1, 1, 1, -1});
  const int normals = file.add_vec3({s, 0, s, s, 0, s, s, 0, s});
  file.add_mesh_node({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}},
                     {{"scale", {3, 1, 1}}});
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  CHECK(is_near(loaded->meshes[0].normals[0], normalize(Vec3f(1, 0, 3))));
  CHECK(is_near(loaded->meshes[0].normals[0], facing(loaded->meshes[0])));
}

TEST_CASE("missing_normals_are_flat") {
  GltfBuilder file;
  // two triangles that share an edge at a right angle
  const int positions = file.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  file.add_mesh_node({{"attributes", {{"POSITION", positions}}},
                      {"indices", file.add_indices({0, 1, 2, 0, 3, 1})}});
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  const scene::Mesh& mesh = loaded->meshes[0];
  CHECK(mesh.positions.size() == 6);
  for (const std::uint32_t c : mesh.triangles[0])
    CHECK(is_near(mesh.normals[c], Vec3f(0, 0, 1)));
  for (const std::uint32_t c : mesh.triangles[1])
    CHECK(is_near(mesh.normals[c], Vec3f(0, 1, 0)));
}

TEST_CASE("bad_normals_are_computed_and_long_ones_are_shortened") {
  GltfBuilder file;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  json primitive = file.square_primitive();
  primitive["attributes"]["NORMAL"] = file.add_vec3({0, 0, 0, nan, 0, 1, 0, 0, 25, 0, 0, 1});
  file.add_mesh_node(primitive);
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  CHECK(warns_about(*loaded, "normals"));
  for (const Vec3f n : loaded->meshes[0].normals)
    CHECK(is_near(n, Vec3f(0, 0, 1)));
}

TEST_CASE("triangles_without_area_are_dropped_with_a_warning_and_a_file_of_them_is_refused") {
  GltfBuilder file;
  json primitive = file.square_primitive();
  primitive["indices"] = file.add_indices({0, 1, 2, 0, 0, 1, 1, 1, 1, 0, 2, 3});
  file.add_mesh_node(primitive);
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  CHECK(loaded->meshes[0].triangles.size() == 2);
  CHECK(warns_about(*loaded, "without area"));

  GltfBuilder empty;
  empty.add_mesh_node(
      {{"attributes", {{"POSITION", empty.add_vec3({0, 0, 0, 1, 1, 1, 2, 2, 2})}}}});
  CHECK(fails_naming(empty.load(), "meshes[0].primitives[0]"));
}

TEST_CASE("sparse_values_replace_those_of_the_accessor") {
  GltfBuilder file;
  json primitive = file.square_primitive();
  const std::vector<std::uint16_t> where = {1, 2};
  const std::vector<float> what = {5, 0, 0, 5, 1, 0};
  const int where_view = file.add_view(where.data(), 4);
  const int what_view = file.add_view(what.data(), 24);
  const json sparse = {{"count", 2},
                       {"indices", {{"bufferView", where_view}, {"componentType", k_ushort}}},
                       {"values", {{"bufferView", what_view}}}};
  file.root["accessors"][primitive["attributes"]["POSITION"].get<int>()]["sparse"] = sparse;
  file.add_mesh_node(primitive);
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  CHECK(is_near(loaded->meshes[0].positions[0], Vec3f(0, 0, 0)));
  CHECK(is_near(loaded->meshes[0].positions[1], Vec3f(5, 0, 0)));
  CHECK(area_of(loaded->meshes[0]) == doctest::Approx(5.0));

  // without a buffer view the rest is zero
  GltfBuilder zeros;
  const int wv = zeros.add_view(where.data(), 4), vv = zeros.add_view(what.data(), 24);
  json accessor = {{"count", 3}, {"type", "VEC3"}, {"componentType", k_float}, {"sparse", sparse}};
  accessor["sparse"]["indices"]["bufferView"] = wv;
  accessor["sparse"]["values"]["bufferView"] = vv;
  zeros.add_mesh_node({{"attributes", {{"POSITION", zeros.add("accessors", accessor)}}}});
  const auto from_zeros = zeros.load();
  REQUIRE(from_zeros.ok());
  CHECK(area_of(from_zeros->meshes[0]) == doctest::Approx(2.5));
}

TEST_CASE("quantised_attributes_are_read_at_their_scale") {
  const auto load_with = [](auto values, int type, bool normalized, std::size_t stride) {
    GltfBuilder file;
    file.use("KHR_mesh_quantization", true);
    json primitive = file.square_primitive();
    primitive["attributes"]["POSITION"] =
        file.add_accessor(values, "VEC3", type, 3, normalized, stride);
    primitive["attributes"]["NORMAL"] = file.add_accessor(
        std::vector<std::int8_t>{0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0}, "VEC3",
        k_byte, 3, true, 4);
    file.add_mesh_node(primitive);
    const auto loaded = file.load();
    REQUIRE(loaded.ok());
    CHECK(is_near(loaded->meshes[0].normals[2], Vec3f(0, 0, 1)));
    return loaded->meshes[0].positions[2];
  };
  using Bytes = std::vector<std::int8_t>;
  using UBytes = std::vector<std::uint8_t>;
  using Shorts = std::vector<std::int16_t>;
  using UShorts = std::vector<std::uint16_t>;
  CHECK(is_near(
      load_with(Bytes{0, 0, 0, 0, 127, 0, 0, 0, 127, -128, 0, 0, 0, -127, 0, 0}, k_byte, true, 4),
      Vec3f(1, -1, 0)));
  CHECK(is_near(
      load_with(UBytes{0, 0, 0, 0, 255, 0, 0, 0, 255, 51, 0, 0, 0, 51, 0, 0}, k_ubyte, true, 4),
      Vec3f(1, 0.2f, 0)));
  CHECK(is_near(load_with(Shorts{0, 0, 0, 0, 300, 0, 0, 0, 300, -200, 0, 0, 0, -200, 0, 0}, k_short,
                          false, 8),
                Vec3f(300, -200, 0)));
  CHECK(is_near(load_with(UShorts{0, 0, 0, 0, 65535, 0, 0, 0, 65535, 13107, 0, 0, 0, 13107, 0, 0},
                          k_ushort, true, 8),
                Vec3f(1, 0.2f, 0)));
}

TEST_CASE("vertex_colours_of_every_kind_are_linear_rgba") {
  const auto first_color = [](GltfBuilder& file, int accessor) {
    json primitive = file.square_primitive();
    primitive["attributes"]["COLOR_0"] = accessor;
    file.add_mesh_node(primitive);
    const auto loaded = file.load();
    REQUIRE(loaded.ok());
    return loaded->meshes[0].colors.at(0);
  };
  GltfBuilder floats, bytes, shorts;
  const Vec4f a = first_color(floats, floats.add_vec3(std::vector<float>(12, 0.25f)));
  CHECK(a.x == doctest::Approx(0.25f));
  CHECK(a.w == 1.0f);
  const Vec4f b = first_color(
      bytes, bytes.add_accessor(std::vector<std::uint8_t>(16, 51), "VEC4", k_ubyte, 4, true));
  CHECK(b.x == doctest::Approx(0.2f));
  CHECK(b.w == doctest::Approx(0.2f));
  const Vec4f c = first_color(shorts, shorts.add_accessor(std::vector<std::uint16_t>(16, 13107),
                                                          "VEC3", k_ushort, 3, true, 8));
  CHECK(c.y == doctest::Approx(0.2f));
  CHECK(c.w == 1.0f);
}

TEST_CASE("instances_are_copies_and_every_index_width_works") {
  GltfBuilder file;
  json primitive = file.square_primitive();
  primitive["indices"] =
      file.add_accessor(std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3}, "SCALAR", k_ubyte, 1);
  file.add_mesh_node(primitive);
  const int second =
      file.add("nodes", {{"mesh", 0}, {"translation", {10, 0, 0}}, {"name", "copy"}});
  file.root["scenes"][0]["nodes"].push_back(second);
  json wide = file.square_primitive();
  wide["indices"] =
      file.add_accessor(std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}, "SCALAR", k_uint, 1);
  file.add_mesh_node(wide);
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  REQUIRE(loaded->meshes.size() == 3);
  CHECK(is_near(loaded->meshes[1].positions[0], Vec3f(10, 0, 0)));
  CHECK(loaded->meshes[1].name == "copy");
  for (const auto& mesh : loaded->meshes)
    CHECK(area_of(mesh) == doctest::Approx(1.0));
}

TEST_CASE("the_default_scene_is_shown_else_the_first_else_all_roots") {
  GltfBuilder file;
  const int a = file.add_mesh_node(file.square_primitive(), {{"name", "a"}});
  const int b = file.add_mesh_node(file.square_primitive(), {{"name", "b"}});
  file.root["scenes"] = json::array({{{"nodes", {a}}}, {{"nodes", {b}}}});
  file.root["scene"] = 1;
  CHECK(file.load()->meshes.at(0).name == "b");
  file.root.erase("scene");
  CHECK(file.load()->meshes.at(0).name == "a");
  file.root.erase("scenes");
  CHECK(file.load()->meshes.size() == 2);
}

// A normal-mapped square whose texture runs along the given directions.
Result<scene::Scene> load_normal_mapped(const std::vector<float>& uv) {
  GltfBuilder file;
  json primitive = file.square_primitive();
  primitive["attributes"]["TEXCOORD_0"] = file.add_vec2(uv);
  const int texture = file.add_texture(1, 1, {128, 128, 255, 255});
  primitive["material"] = file.add("materials", {{"normalTexture", {{"index", texture}}}});
  file.add_mesh_node(primitive);
  return file.load();
}

TEST_CASE("computed_tangents_follow_u_and_tell_mirrored_textures") {
  // glTF: v points down the picture, the bitangent cross(n, t) w points up it, against v
  const auto upright = load_normal_mapped({0, 1, 1, 1, 1, 0, 0, 0});
  REQUIRE(upright.ok());
  const Vec4f t = upright->meshes[0].tangents.at(0);
  CHECK(is_near(Vec3f(t.x, t.y, t.z), Vec3f(1, 0, 0)));
  const auto mirrored = load_normal_mapped({1, 1, 0, 1, 0, 0, 1, 0});
  REQUIRE(mirrored.ok());
  const Vec4f m = mirrored->meshes[0].tangents.at(0);
  CHECK(is_near(Vec3f(m.x, m.y, m.z), Vec3f(-1, 0, 0)));
  CHECK(t.w == 1.0f);
  CHECK(m.w == -1.0f);
}

TEST_CASE("vertices_on_a_mirror_seam_are_doubled") {
  // two squares side by side, the texture mirrored at the shared edge
  GltfBuilder file;
  const int positions = file.add_vec3({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0});
  const int normals = file.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  const int uv = file.add_vec2({0, 1, 1, 1, 1, 0, 0, 0, 0, 1, 0, 0});
  const int texture = file.add_texture(1, 1, {128, 128, 255, 255});
  const int material = file.add("materials", {{"normalTexture", {{"index", texture}}}});
  file.add_mesh_node(
      {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uv}}},
       {"indices", file.add_indices({0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2})},
       {"material", material}});
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  const scene::Mesh& mesh = loaded->meshes[0];
  CHECK(mesh.positions.size() == 8);
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t c : triangle) {
      const bool is_left = mesh.positions[triangle[0]].x + mesh.positions[triangle[1]].x +
                               mesh.positions[triangle[2]].x <
                           3;
      CHECK(mesh.tangents[c].x == doctest::Approx(is_left ? 1.0f : -1.0f));
    }
}

TEST_CASE("given_tangents_are_kept_and_mirrored_with_the_node") {
  GltfBuilder file;
  json primitive = file.square_primitive();
  primitive["attributes"]["TANGENT"] = file.add_accessor(
      std::vector<float>{0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1}, "VEC4", k_float, 4);
  const int texture = file.add_texture(1, 1, {128, 128, 255, 255});
  primitive["material"] = file.add("materials", {{"normalTexture", {{"index", texture}}}});
  file.add_mesh_node(primitive, {{"scale", {-2, 1, 1}}});
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  const Vec4f t = loaded->meshes[0].tangents.at(0);
  CHECK(is_near(Vec3f(t.x, t.y, t.z), Vec3f(0, 1, 0)));
  CHECK(t.w == -1.0f);
}

TEST_CASE("meshes_without_a_normal_map_carry_no_tangents") {
  GltfBuilder file;
  file.add_mesh_node(file.square_primitive());
  CHECK(file.load()->meshes[0].tangents.empty());
}

} // namespace
