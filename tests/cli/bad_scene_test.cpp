// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Bad scenes: a picture, or one line that names file and field and exit code 1; never a crash, a
// hang or a damaged older picture.

#include "openltc/image/file.h"
#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <limits>
#include <random>

using namespace openltc;
using namespace openltc::test;
namespace fs = std::filesystem;

namespace {

const std::string k_older = "an older picture";

// Renders `scene` over an older file. Returns the run, after checking all that is promised whatever
// the scene.
Run render_over_older_picture(const std::string& scene) {
  const TemporaryFolder folder;
  const std::string png = folder.file("x.png");
  write_text(png, k_older);
  const Run run =
      run_tool({"render", scene, "--quiet", "--size", "24x16", "--samples", "2", "-o", png});
  CHECK(run.ended_by == 0);
  CHECK(folder.file_count() == 1);
  CHECK(run.out.empty());
  if (run.exit_code == 0) {
    CHECK(run.err.empty());
    CHECK(image::read(png).ok());
  } else {
    CHECK(fails_naming(run, scene));
    const auto kept = bytes_of(png);
    CHECK(std::string(kept.begin(), kept.end()) == k_older);
  }
  return run;
}

} // namespace

TEST_CASE("malformed_scenes_give_a_picture_or_one_line") {
  const fs::path shared = fs::path(OPENLTC_SHARED_DIR) / "malformed";
  if (!fs::is_directory(shared)) {
    MESSAGE("skipped: " << shared.string() << " is not there");
    return;
  }
  int count = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(shared)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".gltf" && extension != ".glb") continue;
    const std::string path = entry.path().string();
    CAPTURE(path);
    const Run run = render_over_older_picture(path);
    // Behind the file's name stands a field, "name: what" or "name[3].name: what".
    if (run.exit_code != 0) {
      const std::string rest = run.err.substr(run.err.find(path) + path.size());
      CHECK(rest.rfind(": ", 0) == 0);
      const std::size_t colon = rest.find(": ", 2);
      REQUIRE(colon != std::string::npos);
      CHECK(rest.substr(2, colon - 2).find(' ') == std::string::npos);
    }
    ++count;
  }
  CHECK(count > 10);
}

TEST_CASE("files_that_are_no_scene_are_refused") {
  const TemporaryFolder folder;
  const std::string empty = folder.file("empty.glb");
  write_text(empty, "");
  CHECK(render_over_older_picture(empty).exit_code == 1);

  const std::string picture = folder.file("picture.glb");
  REQUIRE(image::write_png(picture + ".png", image::Image(8, 8, 3)).ok());
  fs::rename(picture + ".png", picture);
  CHECK(render_over_older_picture(picture).exit_code == 1);

  std::mt19937 random(1);
  std::vector<std::uint8_t> noise(4096);
  for (std::uint8_t& byte : noise)
    byte = std::uint8_t(random());
  for (const char* name : {"noise.glb", "noise.gltf"}) {
    image::test::write_bytes(folder.file(name), noise);
    CHECK(render_over_older_picture(folder.file(name)).exit_code == 1);
  }

  CHECK(render_over_older_picture(folder.file("missing.glb")).exit_code == 1);
  fs::create_directory(folder.file("folder.glb"));
  CHECK(render_over_older_picture(folder.file("folder.glb")).exit_code == 1);
}

TEST_CASE("truncated_scenes_are_refused_wherever_they_end") {
  const TemporaryFolder folder;
  const std::vector<std::uint8_t> whole = lit_floor().to_glb();
  for (const std::size_t size : {std::size_t(4), std::size_t(12), std::size_t(19), std::size_t(200),
                                 whole.size() / 2, whole.size() - 40, whole.size() - 1}) {
    CAPTURE(size);
    const std::string path = folder.file("cut.glb");
    image::test::write_bytes(
        path, std::vector<std::uint8_t>(whole.begin(), whole.begin() + std::ptrdiff_t(size)));
    CHECK(render_over_older_picture(path).exit_code == 1);
  }
  const std::string text = lit_floor().to_text();
  write_text(folder.file("cut.gltf"), text.substr(0, text.size() / 2));
  CHECK(render_over_older_picture(folder.file("cut.gltf")).exit_code == 1);
}

TEST_CASE("cyclic_nodes_are_refused") {
  const TemporaryFolder folder;
  GltfBuilder scene = lit_floor();
  scene.root["nodes"][0]["children"] = {1};
  scene.root["nodes"][1]["children"] = {0};
  write_scene(folder.file("cycle.gltf"), scene);
  const Run run = render_over_older_picture(folder.file("cycle.gltf"));
  CHECK(run.exit_code == 1);
  CHECK(contains(run.err, "nodes["));
}

TEST_CASE("positions_that_are_no_places_are_refused_with_their_field") {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    const TemporaryFolder folder;
    GltfBuilder scene;
    scene.add_mesh_node(
        {{"attributes", {{"POSITION", scene.add_vec3({0, 0, 0, 1, 0, bad, 0, 1, 0})}}}});
    write_scene(folder.file("bad.gltf"), scene);
    const Run run = render_over_older_picture(folder.file("bad.gltf"));
    CHECK(run.exit_code == 1);
    CHECK(contains(run.err, "meshes[0].primitives[0].attributes.POSITION"));
  }
}

TEST_CASE("lights_and_triangles_without_size_are_no_reason_to_fail") {
  const TemporaryFolder folder;
  GltfBuilder scene = lit_floor();
  scene.root["nodes"][1]["scale"] = {0, 0, 0}; // the lamp
  scene.use("EXT_lights_area");
  scene.root["extensions"]["EXT_lights_area"]["lights"] = {{{"type", "rect"}, {"size", 0.0}}};
  const int node = scene.add("nodes", {{"extensions", {{"EXT_lights_area", {{"light", 0}}}}}});
  scene.root["scenes"][0]["nodes"].push_back(node);
  write_scene(folder.file("no_size.gltf"), scene);
  const Run run = render_over_older_picture(folder.file("no_size.gltf"));
  CHECK(run.exit_code >= 0);

  GltfBuilder flat;
  flat.add_mesh_node({{"attributes", {{"POSITION", flat.add_vec3({1, 1, 1, 1, 1, 1, 1, 1, 1})}}}});
  write_scene(folder.file("flat.gltf"), flat);
  CHECK(render_over_older_picture(folder.file("flat.gltf")).exit_code >= 0);
}
