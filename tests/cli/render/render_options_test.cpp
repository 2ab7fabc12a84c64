// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The options of render that choose what is seen: cameras, lights, extensions, seeds.

#include "openltc/image/file.h"
#include "tests/cli/tool.h"

#include <doctest/doctest.h>

using namespace openltc;
using namespace openltc::test;

namespace {

struct Studio {
  TemporaryFolder folder;
  std::string scene = folder.file("scene.gltf"), exr = folder.file("x.exr");

  Run render(const std::vector<std::string>& more, bool quiet = true) const {
    std::vector<std::string> arguments = {"render", scene,       "--size", "32x24", "--samples",
                                          "4",      "--threads", "1",      "-o",    exr};
    if (quiet) arguments.push_back("--quiet");
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_tool(arguments);
  }
  std::vector<std::uint8_t> bytes(const std::vector<std::string>& more) const {
    REQUIRE(render(more).exit_code == 0);
    return bytes_of(exr);
  }
  double mean() const {
    const image::Image picture = *image::read(exr);
    double sum = 0;
    for (const float v : picture.data)
      sum += double(v);
    return sum / double(picture.data.size());
  }
};

} // namespace

TEST_CASE("the_same_bytes_for_any_number_of_threads_and_other_bytes_for_another_seed") {
  Studio studio;
  studio.scene = demo_scene();
  for (const char* integrator : {"ltc", "reference"}) {
    CAPTURE(integrator);
    const auto one = studio.bytes({"--integrator", integrator});
    // The last one given counts would be a surprise: threads are given once here.
    const Run two =
        run_tool({"render", studio.scene, "--size", "32x24", "--samples", "4", "--threads", "2",
                  "-o", studio.exr, "--quiet", "--integrator", integrator});
    REQUIRE(two.exit_code == 0);
    CHECK(bytes_of(studio.exr) == one);
    CHECK(studio.bytes({"--integrator", integrator, "--seed", "0"}) == one);
    CHECK(studio.bytes({"--integrator", integrator, "--seed", "1"}) != one);
  }
}

TEST_CASE("cameras_are_chosen_by_name_or_number") {
  const Studio studio;
  GltfBuilder scene = lit_floor();
  add_camera(scene, "front", 0.5);
  add_camera(scene, "above", 2.5);
  write_scene(studio.scene, scene);
  const auto front = studio.bytes({"--camera", "front"}),
             above = studio.bytes({"--camera", "above"}),
             frame = studio.bytes({"--camera", "frame"});
  CHECK(front != above);
  CHECK(front != frame);
  CHECK(above != frame);
  CHECK(studio.bytes({"--camera", "0"}) == front);
  CHECK(studio.bytes({"--camera", "1"}) == above);
  CHECK(studio.bytes({}) == front);

  const Run unknown = studio.render({"--camera", "behind"});
  CHECK(fails_naming(unknown, "behind"));
  for (const char* known : {"frame", "0 \"front\"", "1 \"above\""})
    CHECK(contains(unknown.err, known));
  for (const char* number : {"2", "-1", "1x"})
    CHECK(fails_naming(studio.render({std::string("--camera=") + number}), number));
}

TEST_CASE("lights_of_the_scene_of_the_studio_or_both") {
  const Studio studio;
  GltfBuilder scene = lit_floor(100);
  add_camera(scene, "front", 0.5);
  write_scene(studio.scene, scene);
  const auto own = studio.bytes({"--lights", "scene", "--background", "0"});
  const double scene_mean = studio.mean();
  const auto rig = studio.bytes({"--lights", "studio", "--background", "0"});
  const auto both = studio.bytes({"--lights", "both", "--background", "0"});
  CHECK(studio.mean() > scene_mean);
  CHECK(own != rig);
  CHECK(rig != both);
  CHECK(own != both);
  CHECK(studio.bytes({"--background", "0"}) == own);
}

TEST_CASE("a_scene_without_camera_and_lights_is_framed_and_lit") {
  const Studio studio;
  GltfBuilder scene;
  scene.add_mesh_node(scene.square_primitive());
  write_scene(studio.scene, scene);
  const Run run = studio.render({"--background", "0"}, false);
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.err, "studio"));
  CHECK(studio.mean() > 0.01);
  // Asked for the scene's own lights, there are none.
  const Run dark = studio.render({"--background", "0", "--lights", "scene"}, false);
  REQUIRE(dark.exit_code == 0);
  CHECK(contains(dark.err, "no light"));
  CHECK(studio.mean() == 0);
}

TEST_CASE("the_background_is_what_is_seen_beside_the_scene") {
  const Studio studio;
  GltfBuilder scene = lit_floor();
  add_camera(scene, "front", 0.5);
  write_scene(studio.scene, scene);
  REQUIRE(studio.render({"--background", "1,2,3"}).exit_code == 0);
  const Vec3f corner = image::read(studio.exr)->rgb(0, 0);
  CHECK(corner.x == doctest::Approx(1));
  CHECK(corner.y == doctest::Approx(2));
  CHECK(corner.z == doctest::Approx(3));
}

TEST_CASE("unsupported_extensions_are_an_error_when_required_and_a_warning_otherwise") {
  const Studio studio;
  GltfBuilder optional = lit_floor(), required = lit_floor();
  optional.use("VENDOR_paint");
  required.use("VENDOR_paint", true);
  write_scene(studio.scene, optional);
  const Run warned = studio.render({}, false);
  CHECK(warned.exit_code == 0);
  CHECK(contains(warned.err, "warning: "));
  CHECK(contains(warned.err, "VENDOR_paint"));
  CHECK(studio.render({}).err.empty());
  write_scene(studio.scene, required);
  CHECK(fails_naming(studio.render({}), "VENDOR_paint"));
}

TEST_CASE("point_lights_by_the_exact_brdf_or_by_the_lobe_differ_a_little") {
  const Studio studio;
  GltfBuilder scene = lit_floor(0);
  add_camera(scene, "front", 0.5);
  scene.use("KHR_lights_punctual");
  scene.root["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"intensity", 100}}};
  const int node = scene.add("nodes", {{"translation", {0, 2, 0}},
                                       {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  scene.root["scenes"][0]["nodes"].push_back(node);
  write_scene(studio.scene, scene);
  const auto exact = studio.bytes({"--point-lights", "exact"});
  const double exact_mean = studio.mean();
  const auto lobe = studio.bytes({"--point-lights", "ltc"});
  CHECK(exact != lobe);
  CHECK(exact_mean > 0);
  CHECK(studio.mean() == doctest::Approx(exact_mean).epsilon(0.2));
}

TEST_CASE("a_time_shows_what_an_animation_has_moved_by_then") {
  const Studio studio;
  GltfBuilder scene = lit_floor(100);
  add_camera(scene, "front", 0.5);
  // Everything but the camera sinks out of sight within a second.
  const json roots = scene.root["scenes"][0]["nodes"];
  const json seen = json::array({roots[0], roots[1]});
  const int top = scene.add("nodes", {{"children", seen}});
  scene.root["scenes"][0]["nodes"] = json::array({top, roots[2]});
  const std::vector<float> times = {0, 1};
  const int input = scene.add_accessor(times, "SCALAR", k_float, 1);
  const int output = scene.add_vec3({0, 0, 0, 0, -1000, 0});
  scene.root["animations"].push_back(
      {{"name", "sink"},
       {"samplers", json::array({{{"input", input}, {"output", output}}})},
       {"channels",
        json::array({{{"sampler", 0}, {"target", {{"node", top}, {"path", "translation"}}}}})}});
  write_scene(studio.scene, scene);
  const auto at_rest = studio.bytes({});
  CHECK(studio.mean() > 0);
  CHECK(studio.bytes({"--time", "0"}) == at_rest);
  CHECK(studio.bytes({"--animation", "sink"}) == at_rest);
  studio.bytes({"--time", "5"});
  CHECK(studio.mean() == 0);
}
