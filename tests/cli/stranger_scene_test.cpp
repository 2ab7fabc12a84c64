// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Scenes of strangers in the tool: lights that cannot be read, files outside, memory, names.

#include "openltc/image/file.h"
#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

using namespace openltc;
using namespace openltc::test;
namespace fs = std::filesystem;

namespace {

struct Scene {
  TemporaryFolder folder;
  std::string path = folder.file("scene.gltf"), exr = folder.file("x.exr");

  Run render(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"render",    path, "--size", "16x12",
                                          "--samples", "1",  "-o",     exr};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_tool(arguments);
  }
  float largest() const {
    const image::Image picture = *image::read(exr);
    return *std::max_element(picture.data.begin(), picture.data.end());
  }
};

// A floor, and a node with this light in its extras.
GltfBuilder with_light(const json& light) {
  GltfBuilder scene = lit_floor(0);
  scene.root["scenes"][0]["nodes"].push_back(
      scene.add("nodes", {{"translation", {0, 1, 0}},
                          {"rotation", {-0.7071068, 0, 0, 0.7071068}},
                          {"extras", {{"openltc_light", light}}}}));
  return scene;
}

} // namespace

TEST_CASE("a_light_that_cannot_be_read_is_no_reason_for_another_lighting") {
  const Scene scene;
  write_scene(scene.path, with_light({{"type", "rect"}, {"luminance_nits", 100}}));
  const Run run = scene.render();
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.err, "warning: the file describes lights, but none that can be used"));
  CHECK(!contains(run.err, "studio rig"));
  CHECK(scene.largest() == 0);
  // Asked for, the rig comes.
  REQUIRE(scene.render({"--lights", "studio"}).exit_code == 0);
  CHECK(scene.largest() > 0.1f);
  const Run inspected = run_tool({"inspect", scene.path});
  CHECK(contains(inspected.out, "none that can be used"));
}

TEST_CASE("a_dim_light_that_is_described_is_the_only_one") {
  const Scene scene;
  write_scene(scene.path,
              with_light({{"type", "rect"}, {"width", 1}, {"height", 1}, {"luminance_nits", 1}}));
  const Run run = scene.render();
  REQUIRE(run.exit_code == 0);
  CHECK(!contains(run.err, "studio rig"));
  // A white floor reflects at most what shines on it: no more than the light's own luminance.
  CHECK(scene.largest() > 0);
  CHECK(scene.largest() <= 1.0f);
}

TEST_CASE("a_missing_texture_costs_a_warning") {
  const Scene scene;
  GltfBuilder file = lit_floor();
  const int texture =
      file.add("textures", {{"source", file.add("images", {{"uri", "gone.ktx2"}})}});
  file.root["materials"][0]["normalTexture"] = {{"index", texture}};
  write_scene(scene.path, file);
  const Run run = scene.render();
  CHECK(run.exit_code == 0);
  CHECK(contains(run.err, "warning: images[0].uri: the file"));
  CHECK(contains(run.err, "gone.ktx2"));
}

TEST_CASE("every_command_that_reads_scenes_is_confined_to_their_folder") {
  const Scene scene;
  fs::create_directory(scene.folder.file("inner"));
  GltfBuilder file = lit_floor();
  image::test::write_bytes(scene.folder.file("data.bin"), file.buffer);
  file.root["buffers"] =
      json::array({{{"uri", "../data.bin"}, {"byteLength", file.buffer.size()}}});
  const std::string path = scene.folder.file("inner/scene.gltf"),
                    out = scene.folder.file("out.glb");
  write_text(path, file.root.dump());
  const std::vector<std::string> commands[] = {
      {"render", path, "--quiet", "--size", "16x12", "--samples", "1", "-o", scene.exr},
      {"convert", path, out, "--quiet"},
      {"inspect", path}};
  for (std::vector<std::string> command : commands) {
    CAPTURE(command[0]);
    CHECK(fails_naming(run_tool(command), "--allow-outside"));
    CHECK(!fs::exists(scene.exr));
    CHECK(!fs::exists(out));
    command.push_back("--allow-outside");
    CHECK(run_tool(command).exit_code == 0);
    fs::remove(scene.exr);
    fs::remove(out);
  }
}

TEST_CASE("memory_is_limited_by_the_option_in_one_line") {
  const Scene scene;
  image::test::write_bytes(scene.folder.file("big.bin"), {0});
  fs::resize_file(scene.folder.file("big.bin"), std::uint64_t(1) << 30);
  json root = {{"asset", {{"version", "2.0"}}},
               {"buffers", {{{"uri", "big.bin"}, {"byteLength", std::uint64_t(1) << 30}}}}};
  write_text(scene.path, root.dump());
  for (const char* command : {"render", "inspect"}) {
    CAPTURE(command);
    const Run run = run_tool({command, scene.path, "--memory", "100M"});
    CHECK(fails_naming(run, "asks for 1 GiB"));
    CHECK(contains(run.err, "100 MiB"));
    CHECK(contains(run.err, "--memory"));
  }
  for (const char* wrong : {"much", "-1", "0", "4X"})
    CHECK(refuses_usage(run_tool({"inspect", scene.path, std::string("--memory=") + wrong}),
                        "--memory"));
}

namespace {

enum class Use { base_color, emission, lamp };

// A floor under a lamp, with a picture from `file` on the floor or on what shines.
void write_pictured(const std::string& path, Use use, const std::string& file) {
  GltfBuilder scene = lit_floor();
  const int texture = scene.add("textures", {{"source", scene.add("images", {{"uri", file}})}});
  if (use == Use::lamp) {
    scene = with_light({{"type", "rect"},
                        {"width", 1},
                        {"height", 1},
                        {"luminance_nits", 100},
                        {"texture", file}});
  } else {
    for (json& material : scene.root["materials"]) {
      if (use == Use::base_color)
        material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", texture}};
      else if (material.contains("emissiveFactor"))
        material["emissiveTexture"] = {{"index", texture}};
    }
    for (json& mesh : scene.root["meshes"])
      for (json& primitive : mesh["primitives"])
        primitive["attributes"]["TEXCOORD_0"] =
            scene.add_accessor(std::vector<float>{0, 1, 1, 1, 1, 0, 0, 0}, "VEC2", 5126, 2);
  }
  write_scene(path, scene);
}

constexpr std::uint64_t k_mib = std::uint64_t(1) << 20;

} // namespace

TEST_CASE("a_picture_takes_little_more_memory_than_its_samples") {
  // 48 MiB as 8-bit RGB. Nothing of it is left here when the tool starts: what a process had
  // before it became the tool counts in its peak.
  const Scene scene;
  const auto write = [&](const char* name, int side) {
    std::vector<std::uint8_t> samples(std::size_t(side) * std::size_t(side) * 3);
    for (std::size_t i = 0; i < samples.size(); ++i)
      samples[i] = std::uint8_t(100 + (i >> 6) % 100); // stripes compress well
    image::test::write_bytes(scene.folder.file(name),
                             image::test::make_png(side, side, 2 /* RGB */, 8, samples));
  };
  write("large.png", 4096);
  write("small.png", 4);
  for (const Use use : {Use::base_color, Use::emission, Use::lamp}) {
    CAPTURE(int(use));
    const auto peak_with = [&](const char* picture) {
      write_pictured(scene.path, use, picture);
      const Run run = scene.render();
      CHECK(run.exit_code == 0);
      CAPTURE(run.err);
      CHECK(!contains(run.err, "warning"));
      return run.peak_bytes;
    };
    const std::uint64_t small = peak_with("small.png"), large = peak_with("large.png");
    // Half as much again, and for lights the filtered picture of 1024 x 1024 texels, of 26 bytes
    // each when it is done and 82 while it is made.
    const std::uint64_t filtered = use == Use::base_color ? 0 : 82 * k_mib;
    CHECK(large > small + 40 * k_mib); // it was read
    CHECK(large < small + 72 * k_mib + filtered);
  }
}

TEST_CASE("a_texture_beyond_the_limit_costs_a_warning_that_says_how_much_it_wants") {
  const Scene scene;
  image::test::write_bytes(
      scene.folder.file("large.png"),
      image::test::make_png(4096, 4096, 2, 8, std::vector<std::uint8_t>(4096 * 4096 * 3, 9)));
  write_pictured(scene.path, Use::emission, "large.png");
  const Run run = scene.render({"--memory", "20M"});
  CHECK(run.exit_code == 0);
  for (const char* part :
       {"large.png", "4096x4096 pixels", "asks for 48 MiB", "20 MiB", "--memory"})
    CHECK(contains(run.err, part));
}

TEST_CASE("a_picture_to_render_counts_before_the_work") {
  const Scene scene;
  write_scene(scene.path, lit_floor());
  const Run run = run_tool(
      {"render", scene.path, "--size", "16384x7812", "--quiet", "--memory", "1G", "-o", scene.exr});
  for (const char* part : {"16384x7812", "--size", "--memory", "1 GiB"})
    CHECK(fails_naming(run, part));
  CHECK(!fs::exists(scene.exr));
}

TEST_CASE("names_cannot_end_a_line_or_steer_the_terminal") {
  const Scene scene;
  const std::string evil = "a\nopenltc render: all is well\x1b[31m" + std::string(100000, 'x');
  GltfBuilder file = lit_floor();
  add_camera(file, evil, 1);
  for (json& node : file.root["nodes"])
    node["name"] = evil;
  write_scene(scene.path, file);
  const Run run = scene.render({"--camera", "none\nsuch"});
  CHECK(fails_naming(run, "none\\nsuch"));
  CHECK(run.err.size() < 1000);
  const Run inspected = run_tool({"inspect", scene.path});
  CHECK(inspected.exit_code == 0);
  CHECK(inspected.out.size() < 3000);
  CHECK(!contains(inspected.out, "\x1b"));
  CHECK(!contains(inspected.out, "\nopenltc"));
}
