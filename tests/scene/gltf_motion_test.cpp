// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Morph targets, skins, instances and animations. Expected values by hand, from the glTF 2.0
// specification, sections 3.7.2.2, 3.7.3 and 3.11, and EXT_mesh_gpu_instancing.

#include "gltf_builder.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace openltc;
using namespace openltc::test;

namespace {

constexpr double k_half = 0.70710678118654752; // of the root of 2

bool is_near(Vec3f a, Vec3f b, float tolerance = 1e-5f) { return length(a - b) < tolerance; }

Result<scene::Scene> load_at(const GltfBuilder& file, const scene::PoseOptions& pose) {
  const std::string text = file.to_text();
  return scene::load_gltf_memory({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()},
                                 "test.gltf", {}, {}, {false, pose});
}

// --- morph targets -----------------------------------------------------------------------------

// The unit square, whose only target tilts it about the y axis by 45 degrees and moves it by 3.
json tilting_square(GltfBuilder& file) {
  json primitive = file.square_primitive();
  const int positions = file.add_vec3({0, 0, 3, 0, 0, 4, 0, 0, 4, 0, 0, 3});
  const int normals = file.add_vec3({-1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0});
  primitive["targets"] = json::array({{{"POSITION", positions}, {"NORMAL", normals}}});
  return primitive;
}

void check_tilted(const scene::Mesh& mesh) {
  CHECK(is_near(mesh.positions.at(0), {0, 0, 3}));
  CHECK(is_near(mesh.positions.at(2), {1, 1, 4}));
  for (const Vec3f n : mesh.normals)
    CHECK(is_near(n, {float(-k_half), 0, float(k_half)}));
}

TEST_CASE("default_weights_of_morph_targets_are_applied") {
  GltfBuilder file;
  file.add_mesh_node(tilting_square(file));
  CHECK(is_near(file.load()->meshes.at(0).positions.at(2), {1, 1, 0})); // no weights: 0
  file.root["meshes"][0]["weights"] = {1};
  check_tilted(file.load()->meshes.at(0));
  file.root["nodes"][0]["weights"] = {0.5}; // the node's come first
  const auto half = file.load();
  REQUIRE(half.ok());
  CHECK(half->warnings.empty());
  CHECK(is_near(half->meshes.at(0).positions.at(2), {1, 1, 2}));
  const float l = std::sqrt(1.25f);
  CHECK(is_near(half->meshes.at(0).normals.at(2), {-0.5f / l, 0, 1 / l}));
}

TEST_CASE("nodes_that_share_a_mesh_may_have_weights_of_their_own") {
  GltfBuilder file;
  file.add_mesh_node(tilting_square(file), {{"weights", {1}}});
  file.root["nodes"].push_back({{"mesh", 0}});
  file.root["scenes"][0]["nodes"].push_back(1);
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  REQUIRE(loaded->meshes.size() == 2);
  check_tilted(loaded->meshes[0]);
  CHECK(is_near(loaded->meshes[1].positions.at(2), {1, 1, 0}));
}

TEST_CASE("a_sparse_target_moves_the_vertices_that_it_names") {
  GltfBuilder file;
  json primitive = file.square_primitive();
  const std::vector<std::uint8_t> indices = {2};
  const std::vector<float> values = {0, 0, 5};
  const int index_view = file.add_view(indices.data(), 1);
  const int value_view = file.add_view(values.data(), 12);
  const int accessor = file.add(
      "accessors", {{"count", 4},
                    {"type", "VEC3"},
                    {"componentType", k_float},
                    {"sparse",
                     {{"count", 1},
                      {"indices", {{"bufferView", index_view}, {"componentType", k_ubyte}}},
                      {"values", {{"bufferView", value_view}}}}}});
  primitive["targets"] = json::array({{{"POSITION", accessor}}});
  file.add_mesh_node(primitive, {{"weights", {1}}});
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  CHECK(is_near(loaded->meshes.at(0).positions.at(1), {1, 0, 0}));
  CHECK(is_near(loaded->meshes.at(0).positions.at(2), {1, 1, 5}));
}

TEST_CASE("a_morphed_mesh_without_normals_gets_those_of_its_shape") {
  GltfBuilder file;
  json primitive = tilting_square(file);
  primitive["attributes"].erase("NORMAL");
  file.add_mesh_node(primitive, {{"weights", {1}}});
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  for (const Vec3f n : loaded->meshes.at(0).normals)
    CHECK(is_near(n, {float(-k_half), 0, float(k_half)}));
}

TEST_CASE("a_morphed_emissive_surface_lights_from_where_it_is") {
  GltfBuilder file;
  file.root["materials"] = json::array({{{"emissiveFactor", {1, 1, 1}}}});
  json primitive = tilting_square(file);
  primitive["material"] = 0;
  file.add_mesh_node(primitive, {{"weights", {1}}});
  const auto loaded = file.load();
  REQUIRE(loaded->lights.polygons.size() == 1);
  CHECK(is_near(loaded->lights.polygons[0].normal, {float(-k_half), 0, float(k_half)}));
}

TEST_CASE("targets_of_another_length_are_refused") {
  GltfBuilder file;
  json primitive = file.square_primitive();
  primitive["targets"] = json::array({{{"POSITION", file.add_vec3({0, 0, 1})}}});
  file.add_mesh_node(primitive, {{"weights", {1}}});
  CHECK(fails_naming(file.load(), "meshes[0].primitives[0].targets[0].POSITION"));
}

// --- skins -------------------------------------------------------------------------------------

// A triangle on two joints: nodes[1] at `at`, nodes[2] 1 m above it and turned to the left by
// `degrees`. The mesh's own node, nodes[0], stands elsewhere.
GltfBuilder skinned_triangle(Vec3d at, double degrees) {
  GltfBuilder file;
  const int positions = file.add_vec3({0, 0, 0, 0, 2, 0, 1, 1.5f, 0});
  const int normals = file.add_vec3({0, 0, 1, 0, 1, 0, 0, 0, 1});
  const std::vector<std::uint8_t> joints = {0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0};
  // The last vertex follows both joints alike; its weights do not add up to 1.
  const std::vector<std::uint8_t> weights = {255, 0, 0, 0, 255, 0, 0, 0, 100, 100, 0, 0};
  const json primitive = {{"attributes",
                           {{"POSITION", positions},
                            {"NORMAL", normals},
                            {"JOINTS_0", file.add_accessor(joints, "VEC4", k_ubyte, 4)},
                            {"WEIGHTS_0", file.add_accessor(weights, "VEC4", k_ubyte, 4, true)}}}};
  file.add_mesh_node(primitive, {{"skin", 0}, {"translation", {100, 7, 3}}, {"scale", {2, 2, 2}}});
  const double half = degrees * std::numbers::pi / 360;
  file.root["nodes"].push_back({{"translation", {at.x, at.y, at.z}}, {"children", {2}}});
  file.root["nodes"].push_back(
      {{"translation", {0, 1, 0}}, {"rotation", {0, 0, std::sin(half), std::cos(half)}}});
  file.root["scenes"][0]["nodes"].push_back(1);
  std::vector<float> matrices = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1};
  file.root["skins"] =
      json::array({{{"joints", {1, 2}},
                    {"inverseBindMatrices", file.add_accessor(matrices, "MAT4", k_float, 16)}}});
  return file;
}

TEST_CASE("a_skinned_mesh_stands_where_its_joints_are_and_not_where_its_node_is") {
  const auto loaded = skinned_triangle({0, 0, 0}, 90).load();
  REQUIRE(loaded.ok());
  CHECK(loaded->warnings.empty());
  const scene::Mesh& mesh = loaded->meshes.at(0);
  CHECK(is_near(mesh.positions.at(0), {0, 0, 0}));
  CHECK(is_near(mesh.positions.at(1), {-1, 1, 0})); // 1 m above the upper joint, to the left
  // By the lower joint (1, 1.5, 0), by the upper one (-0.5, 2, 0).
  CHECK(is_near(mesh.positions.at(2), {0.25f, 1.75f, 0}));
  CHECK(is_near(mesh.normals.at(1), {-1, 0, 0}));
}

TEST_CASE("a_skinned_mesh_far_away_keeps_its_shape") {
  const Vec3d at(6e6, -5e5, 1e3);
  const auto loaded = skinned_triangle(at, 90).load();
  REQUIRE(loaded.ok());
  const auto place = [&](std::size_t i) {
    return to_float(loaded->origin + to_double(loaded->meshes.at(0).positions.at(i)) - at);
  };
  CHECK(is_near(place(1), {-1, 1, 0}));
  CHECK(is_near(place(2), {0.25f, 1.75f, 0}));
}

TEST_CASE("a_mirrored_skeleton_keeps_the_outside_outside") {
  GltfBuilder file = skinned_triangle({0, 0, 0}, 0);
  const auto winding = [](const scene::Mesh& mesh) {
    const auto& t = mesh.triangles.at(0);
    return cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                 mesh.positions[t[2]] - mesh.positions[t[0]]);
  };
  const Vec3f before = winding(file.load()->meshes.at(0));
  file.root["nodes"][1]["scale"] = {-1, 1, 1};
  const Vec3f after = winding(file.load()->meshes.at(0));
  CHECK(before.z * after.z > 0);
}

TEST_CASE("a_damaged_skin_costs_the_bending_not_the_file") {
  GltfBuilder file = skinned_triangle({0, 0, 0}, 90);
  file.root["skins"][0].erase("joints");
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  CHECK(warns_about(*loaded, "skins[0].joints"));
  CHECK(loaded->meshes.size() == 1);
  GltfBuilder wrong = skinned_triangle({0, 0, 0}, 90);
  wrong.root["skins"][0]["joints"] = {1};
  CHECK(fails_naming(wrong.load(), "JOINTS_0"));
}

// --- instances ---------------------------------------------------------------------------------

TEST_CASE("every_instance_is_shown_and_lights") {
  GltfBuilder file;
  file.use("EXT_mesh_gpu_instancing", true);
  file.root["materials"] = json::array({{{"emissiveFactor", {1, 1, 1}}}});
  json primitive = file.square_primitive();
  primitive["material"] = 0;
  const int translations = file.add_vec3({0, 0, 0, 4, 0, 0, 0, 6, 0});
  // The third is turned by 90 degrees about z.
  const std::int16_t k = 23170; // of 32767
  const std::vector<std::int16_t> turns = {0, 0, 0, 32767, 0, 0, 0, 32767, 0, 0, k, k};
  const int rotations = file.add_accessor(turns, "VEC4", k_short, 4, true);
  const int scales = file.add_vec3({1, 1, 1, 3, 1, 1, 1, 1, 1});
  file.add_mesh_node(
      primitive,
      {{"translation", {0, 0, 10}},
       {"scale", {2, 2, 2}},
       {"extensions",
        {{"EXT_mesh_gpu_instancing",
          {{"attributes",
            {{"TRANSLATION", translations}, {"ROTATION", rotations}, {"SCALE", scales}}}}}}}});
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  CHECK(loaded->warnings.empty());
  REQUIRE(loaded->meshes.size() == 3);
  CHECK(is_near(loaded->meshes[0].positions.at(2), {2, 2, 10}));
  CHECK(is_near(loaded->meshes[1].positions.at(2), {8 + 6, 2, 10}));
  CHECK(is_near(loaded->meshes[2].positions.at(1), {0, 12 + 2, 10}, 1e-3f));
  CHECK(loaded->lights.polygons.size() == 3);
}

TEST_CASE("instances_of_different_numbers_are_refused") {
  GltfBuilder file;
  const int two = file.add_vec3({0, 0, 0, 4, 0, 0}), one = file.add_vec3({1, 1, 1});
  file.add_mesh_node(
      file.square_primitive(),
      {{"extensions",
        {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", two}, {"SCALE", one}}}}}}}});
  CHECK(fails_naming(file.load(), "EXT_mesh_gpu_instancing.attributes.SCALE"));
}

TEST_CASE("an_instance_beyond_the_usable_range_is_refused") {
  GltfBuilder file;
  const int translations = file.add_vec3({0, 0, 0, 1e10f, 0, 0});
  file.add_mesh_node(
      file.square_primitive(),
      {{"extensions",
        {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", translations}}}}}}}});
  CHECK(fails_naming(file.load(), "nodes[0]"));
}

// --- animations --------------------------------------------------------------------------------

int add_scalars(GltfBuilder& file, const std::vector<float>& values) {
  return file.add_accessor(values, "SCALAR", k_float, 1);
}

json channel(int sampler, int node, const char* path) {
  return {{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}};
}

json sampler(int input, int output, const char* interpolation = "LINEAR") {
  return {{"input", input}, {"output", output}, {"interpolation", interpolation}};
}

json animation(const char* name, const std::vector<json>& samplers,
               const std::vector<json>& channels) {
  return {{"name", name}, {"samplers", samplers}, {"channels", channels}};
}

// The square, moved by "Walk" along x from 0 to 8 within 2 s and turned, in "Turn", by a quarter
// about z within 1 s.
GltfBuilder moving_square() {
  GltfBuilder file;
  file.add_mesh_node(file.square_primitive());
  const int two_seconds = add_scalars(file, {0, 2}), one_second = add_scalars(file, {0, 1});
  const int way = file.add_vec3({0, 0, 0, 8, 0, 0});
  const std::vector<float> turn = {0, 0, 0, 1, 0, 0, float(k_half), float(k_half)};
  const int turns = file.add_accessor(turn, "VEC4", k_float, 4);
  file.root["animations"].push_back(
      animation("Walk", {sampler(two_seconds, way)}, {channel(0, 0, "translation")}));
  file.root["animations"].push_back(
      animation("Turn", {sampler(one_second, turns)}, {channel(0, 0, "rotation")}));
  return file;
}

TEST_CASE("animations_are_listed_and_the_rest_pose_is_shown") {
  const auto loaded = moving_square().load();
  REQUIRE(loaded.ok());
  REQUIRE(loaded->animations.size() == 2);
  CHECK(loaded->animations[0].name == "Walk");
  CHECK(loaded->animations[0].duration_seconds == 2);
  CHECK(loaded->animations[1].duration_seconds == 1);
  CHECK(warns_about(*loaded, "--time"));
  CHECK(is_near(loaded->meshes.at(0).positions.at(0), {0, 0, 0}));
}

TEST_CASE("a_time_poses_the_file") {
  const GltfBuilder file = moving_square();
  const auto corner = [&](const scene::PoseOptions& pose, std::size_t i) {
    const auto loaded = load_at(file, pose);
    REQUIRE(loaded.ok());
    CHECK(loaded->warnings.empty());
    return to_float(loaded->origin + to_double(loaded->meshes.at(0).positions.at(i)));
  };
  CHECK(is_near(corner({0.5, ""}, 0), {2, 0, 0}));
  CHECK(is_near(corner({2.0, "Walk"}, 0), {8, 0, 0}));
  CHECK(is_near(corner({1e6, "Walk"}, 0), {8, 0, 0}));
  CHECK(is_near(corner({-3.0, "Walk"}, 0), {0, 0, 0}));
  CHECK(is_near(corner({0.5, "Turn"}, 1), {float(k_half), float(k_half), 0})); // 45 degrees
  CHECK(is_near(corner({1.0, "1"}, 1), {0, 1, 0}));
  CHECK(is_near(corner({{}, "Turn"}, 1), {1, 0, 0}));
}

TEST_CASE("an_animation_that_is_not_there_is_an_error_and_one_without_any_a_warning") {
  CHECK(fails_naming(load_at(moving_square(), {1.0, "Run"}), "\"Walk\" of 2 s"));
  GltfBuilder still;
  still.add_mesh_node(still.square_primitive());
  const auto loaded = load_at(still, {1.0, ""});
  REQUIRE(loaded.ok());
  CHECK(warns_about(*loaded, "no animations"));
}

TEST_CASE("steps_splines_weights_and_scales_are_played") {
  GltfBuilder file;
  file.add_mesh_node(tilting_square(file));
  const int times = add_scalars(file, {1, 3});
  // value 0 leaving with slope 2, value 1 arriving with slope 0
  const int spline = file.add_vec3({0, 0, 0, 1, 1, 1, 2, 0, 0, 0, 0, 0, 2, 1, 1, 0, 0, 0});
  const std::vector<std::uint8_t> weights = {0, 255};
  const int on = file.add_accessor(weights, "SCALAR", k_ubyte, 1, true);
  const int way = file.add_vec3({0, 0, 0, 10, 0, 0});
  file.root["animations"].push_back(animation(
      "all",
      {sampler(times, spline, "CUBICSPLINE"), sampler(times, on, "STEP"), sampler(times, way)},
      {channel(0, 0, "scale"), channel(1, 0, "weights"), channel(2, 0, "translation")}));
  const auto at_two = load_at(file, {2.0, ""});
  REQUIRE(at_two.ok());
  CHECK(at_two->warnings.empty());
  // Half way: (1 + 2) / 2 + t_d (1/8) (slope out) - t_d (1/8) (slope in) = 1.5 + 2 / 8 * 2 = 2.
  CHECK(is_near(at_two->meshes.at(0).positions.at(2), {5 + 2, 1, 0}));
  const auto at_three = load_at(file, {3.0, ""});
  CHECK(is_near(at_three->meshes.at(0).positions.at(2), {10 + 2, 1, 4}));
}

TEST_CASE("a_damaged_animation_costs_no_picture") {
  GltfBuilder file = moving_square();
  file.root["animations"][0]["samplers"][0]["input"] = add_scalars(file, {1, 1}); // do not ascend
  file.root["animations"].push_back({{"name", "Empty"}});
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  CHECK(loaded->animations.size() == 1);
  CHECK(warns_about(*loaded, "animations[0] cannot be played"));
  CHECK(warns_about(*loaded, "animations[2].channels"));
  CHECK(load_at(file, {1.0, "Turn"}).ok());
  CHECK(fails_naming(load_at(file, {1.0, "Walk"}), "Walk"));
  // A channel that cannot be used leaves the others.
  GltfBuilder short_output = moving_square();
  short_output.root["animations"][0]["samplers"][0]["output"] = short_output.add_vec3({0, 0, 0});
  const auto rest = load_at(short_output, {1.0, "Walk"});
  REQUIRE(rest.ok());
  CHECK(warns_about(*rest, "this channel is left out"));
}

TEST_CASE("joints_move_a_skinned_mesh_with_time") {
  GltfBuilder file = skinned_triangle({0, 0, 0}, 0);
  const std::vector<float> turn = {0, 0, 0, 1, 0, 0, 1, 0}; // by 180 degrees
  const int turns = file.add_accessor(turn, "VEC4", k_float, 4);
  file.root["animations"].push_back(
      animation("bend", {sampler(add_scalars(file, {0, 1}), turns)}, {channel(0, 2, "rotation")}));
  const auto loaded = load_at(file, {0.5, ""});
  REQUIRE(loaded.ok());
  CHECK(is_near(loaded->meshes.at(0).positions.at(1), {-1, 1, 0}));
}

} // namespace
