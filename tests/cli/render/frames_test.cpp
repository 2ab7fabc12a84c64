// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// openltc render --frames: frames are the pictures of --time, made where they are missing.

#include "openltc/image/file.h"
#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <filesystem>

using namespace openltc;
using namespace openltc::test;

namespace {

/// Node `node` goes down by `metres` within a second.
void sink(GltfBuilder& scene, int node, float metres) {
  const std::vector<float> times = {0, 1};
  const int input = scene.add_accessor(times, "SCALAR", k_float, 1);
  const int output = scene.add_vec3({0, 0, 0, 0, -metres, 0});
  scene.root["animations"].push_back(
      {{"name", "sink"},
       {"samplers", json::array({{{"input", input}, {"output", output}}})},
       {"channels",
        json::array({{{"sampler", 0}, {"target", {{"node", node}, {"path", "translation"}}}}})}});
}

/// A floor under a lamp that sinks by half a metre.
GltfBuilder sinking_lamp() {
  GltfBuilder scene = lit_floor(100);
  add_camera(scene, "front", 0.5);
  const json roots = scene.root["scenes"][0]["nodes"];
  const int top = scene.add("nodes", {{"children", json::array({roots[1]})}});
  scene.root["scenes"][0]["nodes"] = json::array({roots[0], top, roots[2]});
  sink(scene, top, 0.5f);
  return scene;
}

struct Film {
  TemporaryFolder folder;
  std::string scene = folder.file("scene.gltf");

  Film(const GltfBuilder& builder = sinking_lamp()) { write_scene(scene, builder); }

  Run render(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"render",    scene, "--size",           "16x12",
                                          "--samples", "2",   "--shadow-samples", "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_tool(arguments);
  }
  Run frames(const std::string& frames, std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--frames", frames, "--fps", "10", "-o", folder.file("f.###.exr")});
    return render(more);
  }
  /// What would be made now.
  std::string missing(const std::string& frames, std::vector<std::string> more = {}) const {
    more.push_back("--list-missing");
    const Run run = this->frames(frames, more);
    CHECK(run.exit_code == 0);
    return run.out;
  }
};

} // namespace

TEST_CASE("a_frame_is_the_picture_of_its_time_whoever_makes_it") {
  const Film film;
  REQUIRE(film.frames("0-10x5", {"--threads", "1"}).exit_code == 0);
  const auto middle = bytes_of(film.folder.file("f.005.exr"));
  CHECK(middle != bytes_of(film.folder.file("f.000.exr")));
  const std::string alone = film.folder.file("alone.exr");
  REQUIRE(film.render({"--time", "0.5", "-o", alone, "--quiet"}).exit_code == 0);
  CHECK(bytes_of(alone) == middle);
  std::filesystem::remove(film.folder.file("f.005.exr"));
  REQUIRE(film.frames("5", {"--threads", "2"}).exit_code == 0);
  CHECK(bytes_of(film.folder.file("f.005.exr")) == middle);
}

TEST_CASE("what_is_made_of_the_same_is_not_made_again") {
  const Film film;
  CHECK(film.missing("1-4,1000") == "1-4,1000\n");
  REQUIRE(film.frames("1-4").exit_code == 0);
  CHECK(film.missing("1-4,1000") == "1000\n");
  const auto before = std::filesystem::last_write_time(film.folder.file("f.002.exr"));
  CHECK(contains(film.frames("1-4").err, "0 of 4 frames"));
  CHECK(std::filesystem::last_write_time(film.folder.file("f.002.exr")) == before);
  CHECK(film.missing("1-4", {"--threads", "1", "--quiet"}) == "\n");
  // Other options, another time for the same frame, files that are gone, cut or not its own.
  CHECK(film.missing("1-4", {"--seed", "7"}) == "1-4\n");
  std::filesystem::remove(film.folder.file("f.003.exr"));
  std::filesystem::resize_file(film.folder.file("f.001.exr"), 100);
  CHECK(film.missing("1-4") == "1,3\n");
  REQUIRE(film.frames("1-4").exit_code == 0);
  CHECK(film.missing("1-4") == "\n");
  // The scene's file, or another that it names, changes.
  std::filesystem::rename(film.folder.file("scene.gltf"), film.folder.file("old.gltf"));
  GltfBuilder scene = sinking_lamp();
  scene.add("images", {{"uri", "paint.png"}});
  write_scene(film.scene, scene);
  CHECK(film.missing("1-4") == "1-4\n");
  REQUIRE(film.frames("1-4").exit_code == 0);
  write_text(film.folder.file("paint.png"), "is there now");
  CHECK(film.missing("1-4") == "1-4\n");
  REQUIRE(film.frames("1-4").exit_code == 0);
  write_text(film.folder.file("paint.png"), "is there mow");
  CHECK(film.missing("1-4") == "1-4\n");
}

TEST_CASE("frames_that_fail_are_named_and_the_others_done") {
  const Film film;
  for (const char* in_the_way : {"f.002.exr", "f.003.exr"})
    std::filesystem::create_directory(film.folder.file(in_the_way));
  const Run run = film.frames("1-4", {"--quiet"});
  CHECK(run.exit_code == 1);
  CHECK(contains(run.err, "frame 3: "));
  CHECK(contains(run.err, "f.003.exr: is a directory"));
  CHECK(contains(run.err, "2 of 4 frames failed: 2-3"));
  CHECK(line_count(run.err) == 3);
  CHECK(film.missing("1-4") == "2-3\n");
}

TEST_CASE("a_view_that_was_framed_and_the_studio_rig_stand_still") {
  GltfBuilder scene = lit_floor(0);
  const json roots = scene.root["scenes"][0]["nodes"];
  const int top = scene.add("nodes", {{"children", json::array({roots[1]})}});
  scene.root["scenes"][0]["nodes"] = json::array({roots[0], top});
  sink(scene, top, 100); // out of sight: the scene's bounds are others then
  const Film film(scene);
  REQUIRE(film.frames("0,10").exit_code == 0);
  const image::Image a = *image::read(film.folder.file("f.000.exr")),
                     b = *image::read(film.folder.file("f.010.exr"));
  CHECK(a.data != b.data);
  // The floor, at the lower edge, far from what went through it.
  for (int x : {0, 15})
    for (int c = 0; c < 3; ++c)
      CHECK(a.pixel(x, 11)[c] == doctest::Approx(b.pixel(x, 11)[c]).epsilon(0.02));
}

TEST_CASE("frames_that_make_no_sense_are_refused") {
  const Film film;
  const std::vector<std::pair<std::string, std::string>> wrong = {{"4-1", "no frame"},
                                                                  {"1-", "write frames as"},
                                                                  {"x", "write frames as"},
                                                                  {"-1", "write frames as"},
                                                                  {"1,", "write frames as"},
                                                                  {"1-4x0", "x1 or more"},
                                                                  {"0-9999999", "1000000 frames"},
                                                                  {"123456789", "99999999"}};
  for (const std::pair<std::string, std::string>& w : wrong) {
    CAPTURE(w.first);
    CHECK(refuses_usage(film.frames(w.first), w.second));
  }
  CHECK(refuses_usage(film.render({"--frames", "1", "-o", "x.exr"}), "####"));
  CHECK(refuses_usage(film.render({"--frames", "1", "-o", "#/x.exr"}), "####"));
  CHECK(refuses_usage(film.render({"--frames", "1", "-o", "x.#.png"}), "EV100"));
  CHECK(refuses_usage(film.render({"--frames", "1", "--fps", "0"}), "--fps"));
  CHECK(refuses_usage(film.render({"--fps", "24"}), "--frames"));
  CHECK(refuses_usage(film.render({"--frames", "1", "--time", "1"}), "--time"));
  CHECK(refuses_usage(film.render({"--frames", "1", "--scheduler", "tcp://a:1"}),
                      "openltc[cluster]"));
  CHECK(fails_naming(film.render({"--frames", "1", "-o", "not/there.#.exr"}), "not"));
  const Film still(lit_floor(100));
  CHECK(fails_naming(still.frames("1-3"), "no animation"));
}
