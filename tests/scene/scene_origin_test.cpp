// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "gltf_builder.h"
#include "openltc/scene/scene_origin.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace openltc;
using namespace openltc::test;

namespace {

bool is_zero(Vec3d v) { return v.x == 0 && v.y == 0 && v.z == 0; }

TEST_CASE("scenes_about_the_origin_stay_where_they_are") {
  scene::OriginFinder room;
  room.add({-1, 0, 3}, {9, 4, 12}, 100);
  CHECK(is_zero(room.origin()));
  CHECK(is_zero(scene::OriginFinder().origin()));
}

TEST_CASE("the_origin_follows_most_of_the_scene_not_a_stray_object") {
  scene::OriginFinder finder;
  for (int i = 0; i < 5; ++i)
    finder.add({5e5 + i, 0, -6e6}, {5e5 + i + 1, 3, -6e6 + 4}, 10);
  finder.add({-1, -1, -1}, {1, 1, 1}, 12); // left at the origin by mistake
  const Vec3d origin = finder.origin();
  CHECK(std::abs(origin.x - 5e5) < 64);
  CHECK(origin.y == 0);
  CHECK(std::abs(origin.z + 6e6) < 64);
}

// A square of 1 m, an emissive one of 0.2 m, a camera and three lights, all under one node.
GltfBuilder room_at(Vec3d at) {
  GltfBuilder file;
  file.use("KHR_lights_punctual");
  file.use("EXT_lights_area");
  file.root["extensions"]["KHR_lights_punctual"]["lights"] = json::array({{{"type", "point"}}});
  file.root["extensions"]["EXT_lights_area"]["lights"] =
      json::array({{{"type", "disk"}, {"size", 0.5}}});
  file.root["cameras"] =
      json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}});
  file.root["materials"] = json::array({{{"emissiveFactor", {1, 1, 1}}}});
  file.add_mesh_node(file.square_primitive());
  json lamp = file.square_primitive();
  lamp["material"] = 0;
  file.add_mesh_node(lamp, {{"scale", {0.2, 0.2, 0.2}}, {"translation", {0.1, 0.3, 0.5}}});
  json& nodes = file.root["nodes"];
  nodes.push_back({{"camera", 0}, {"translation", {0.5, 0.5, 3.25}}});
  nodes.push_back(
      {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}, {"translation", {0.25, 2, 0}}});
  nodes.push_back(
      {{"extensions", {{"EXT_lights_area", {{"light", 0}}}}}, {"translation", {0, 1, 1}}});
  nodes.push_back(
      {{"extras",
        {{"openltc_light", {{"type", "sphere"}, {"radius", 0.125}, {"luminance_nits", 10}}}}},
       {"translation", {1, 0, 1}}});
  // Large translations that cancel but for `at`.
  nodes.push_back({{"children", {0, 1, 2, 3, 4, 5}}, {"translation", {-9e6, 4e6, 7e6}}});
  nodes.push_back({{"children", {6}}, {"translation", {at.x + 9e6, at.y - 4e6, at.z - 7e6}}});
  file.root["scenes"][0]["nodes"] = json::array({7});
  return file;
}

TEST_CASE("a_scene_far_away_has_the_coordinates_of_the_same_scene_at_the_origin") {
  const auto home = room_at({0, 0, 0}).load();
  REQUIRE(home.ok());
  CHECK(is_zero(home->origin));
  for (const Vec3d at : {Vec3d(5e3, 0, 0), Vec3d(5e5, -320, 64), Vec3d(-6e6, 6e6, 3200)}) {
    const auto far = room_at(at).load();
    REQUIRE(far.ok());
    REQUIRE(far->meshes.size() == 2);
    REQUIRE(far->lights.polygons.size() == 1);
    const auto same = [&](Vec3f a, Vec3f b) {
      // 6000 km is known to 1e-9 m in double.
      const Vec3d difference = far->origin + to_double(a) - at - to_double(b);
      return length(difference) < 2e-6;
    };
    for (std::size_t m = 0; m < 2; ++m)
      for (std::size_t i = 0; i < home->meshes[m].positions.size(); ++i)
        CHECK(same(far->meshes[m].positions[i], home->meshes[m].positions[i]));
    CHECK(same(far->cameras.at(0).position, home->cameras[0].position));
    CHECK(same(far->lights.punctual.at(0).position, home->lights.punctual[0].position));
    CHECK(same(far->lights.ellipses.at(0).center, home->lights.ellipses[0].center));
    CHECK(same(far->lights.spheres.at(0).center, home->lights.spheres[0].center));
    for (std::size_t i = 0; i < 4; ++i)
      CHECK(same(far->lights.polygons[0].vertices[i], home->lights.polygons[0].vertices[i]));
    CHECK(same(far->bounds.lower, home->bounds.lower));
  }
}

TEST_CASE("a_small_lamp_in_a_large_scene_has_an_area") {
  // A lamp of 2 mm, 3 km from the middle of a plain: single precision knows its corners to 0.2 mm.
  GltfBuilder file;
  file.root["materials"] = json::array({{{"emissiveFactor", {1, 1, 1}}}});
  file.add_mesh_node(file.square_primitive(),
                     {{"scale", {8e3, 8e3, 1}}, {"translation", {-4e3, -4e3, 0}}});
  json lamp = file.square_primitive();
  lamp["material"] = 0;
  file.add_mesh_node(lamp, {{"scale", {2e-3, 2e-3, 1}}, {"translation", {3e3, 0, 0}}});
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  CHECK(loaded->lights.polygons.size() == 1);
}

TEST_CASE("what_lies_beyond_the_usable_range_is_refused_in_one_line") {
  const auto with = [](std::size_t node, const char* key, const json& value) {
    GltfBuilder file = room_at({0, 0, 0});
    file.root["nodes"][node][key] = value;
    return file.load();
  };
  const json far = {0, 2e8, 0};
  CHECK(with(0, "translation", {0, 5e7, 0}).ok());
  CHECK(fails_naming(with(0, "translation", far), "nodes[0]"));
  CHECK(fails_naming(with(0, "scale", {1e9, 1, 1}), "nodes[0]"));
  CHECK(fails_naming(with(2, "translation", far), "nodes[2]: its camera"));
  CHECK(fails_naming(with(3, "translation", far), "nodes[3]: its light"));
  CHECK(fails_naming(with(4, "translation", far), "nodes[4]: its light"));
  const auto sphere = with(5, "translation", far);
  REQUIRE(sphere.ok());
  CHECK(warns_about(*sphere, "nodes[5]: its light"));
  const auto large = with(5, "scale", {1e10, 1e10, 1e10});
  REQUIRE(large.ok());
  CHECK(large->lights.spheres.empty());
  CHECK(warns_about(*large, "nodes[5].extras.openltc_light.radius"));

  GltfBuilder disk = room_at({0, 0, 0});
  disk.root["extensions"]["EXT_lights_area"]["lights"][0]["size"] = 1e20;
  const auto without_disk = disk.load();
  REQUIRE(without_disk.ok());
  CHECK(warns_about(*without_disk, "EXT_lights_area.lights[0].size"));

  const auto camera = [](const json& orthographic) {
    GltfBuilder file = room_at({0, 0, 0});
    file.root["cameras"][0] = {{"type", "orthographic"}, {"orthographic", orthographic}};
    return file.load();
  };
  CHECK(camera({{"xmag", 1}, {"ymag", 1}, {"znear", 0}, {"zfar", 1e30}}).ok());
  CHECK(fails_naming(camera({{"xmag", 1}, {"ymag", 1e19}, {"znear", 0}, {"zfar", 10}}),
                     "cameras[0].orthographic.ymag"));
  CHECK(fails_naming(camera({{"xmag", 1e-30}, {"ymag", 1}, {"znear", 0}, {"zfar", 10}}),
                     "cameras[0].orthographic.xmag"));
  CHECK(fails_naming(camera({{"xmag", 1}, {"ymag", 1}, {"znear", 1e20}, {"zfar", 1e30}}),
                     "cameras[0].orthographic.znear"));
}

TEST_CASE("a_sun_may_stand_anywhere") {
  GltfBuilder file = room_at({0, 0, 0});
  file.root["extensions"]["KHR_lights_punctual"]["lights"][0]["type"] = "directional";
  file.root["nodes"][3]["translation"] = {0, 1.5e11, 0};
  CHECK(file.load().ok());
}

} // namespace
