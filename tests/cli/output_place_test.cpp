// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Outputs that would destroy an input or each other, and what lies where an output goes.

#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <functional>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

using namespace openltc::test;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> render(const std::string& scene, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"render", scene,       "--quiet", "--size",
                                        "48x27",  "--samples", "1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

// Whether the command refuses to write over `input`, which stays as it is.
bool keeps(const std::string& input, const std::vector<std::string>& arguments,
           const RunOptions& options = {}) {
  const auto before = bytes_of(input);
  const Run run = run_tool(arguments, options);
  CHECK(fails_naming(run, "is also an input"));
  return bytes_of(input) == before && !before.empty();
}

mode_t mode_of(const std::string& path) {
  struct stat facts = {};
  REQUIRE(stat(path.c_str(), &facts) == 0);
  return facts.st_mode & 07777;
}

} // namespace

TEST_CASE("no_output_takes_the_place_of_an_input") {
  const TemporaryFolder folder;
  const auto file = [&](const std::string& name) { return folder.file(name); };
  REQUIRE(run_tool({"fit", "--size", "8", "--quiet", "-o", file("t.json"), "-o", file("n.exr"),
                    "--form", "table", "--report", file("r.json")})
              .exit_code == 0);
  REQUIRE(run_tool(render(demo_scene(), {"-o", file("a.exr"), "-o", file("b.exr")})).exit_code ==
          0);
  CHECK(keeps(file("n_1.exr"),
              render(demo_scene(), {"--table", file("n.exr"), "-o", file("n_1.exr")})));
  CHECK(keeps(file("t.json"), {"fit", "--size", "8", "--quiet", "--against", file("t.json"),
                               "--report", file("./t.json")}));
  CHECK(keeps(file("t.json"), {"fit", "--size", "8", "--quiet", "--against", file("t.json"), "-o",
                               file("t.json")}));
  CHECK(
      keeps(file("t.json"), {"convert", file("t.json"), file("t.json"), "--precision", "float16"}));
  CHECK(
      keeps(file("n_2.exr"), {"convert", file("n.exr"), file("n.exr"), "--precision", "float16"}));
  for (const char* input : {"a.exr", "b.exr"}) {
    fs::create_symlink(input, file("link.png"));
    CHECK(
        keeps(file(input), {"compare", file("a.exr"), file("b.exr"), "--diff", file("link.png")}));
    fs::remove(file("link.png"));
  }
  fs::create_hard_link(file("t.json"), file("hard.svg"));
  CHECK(keeps(file("t.json"),
              {"plot", "error", "--against", file("t.json"), "-o", file("hard.svg")}));
}

TEST_CASE("nothing_that_a_scene_refers_to_is_written_over") {
  const TemporaryFolder folder;
  GltfBuilder scene = lit_floor();
  write_scene(folder.file("room.gltf"), scene);
  REQUIRE(run_tool(render(folder.file("room.gltf"), {"-o", folder.file("room.png")})).exit_code ==
          0);
  // A picture that no material uses, one that is missing, and what only another program knows.
  scene.add("images", {{"uri", "room.png"}});
  scene.add("images", {{"uri", "not%20yet.png"}});
  scene.root["extensions"]["VENDOR_notes"]["file"]["uri"] = "./extra.exr";
  write_text(folder.file("extra.exr"), "four");
  write_scene(folder.file("room.gltf"), scene);
  const std::string room = folder.file("room.gltf");
  RunOptions here;
  here.folder = folder.file(".");
  CHECK(keeps(folder.file("room.png"), render("room.gltf", {}), here)); // the default output
  CHECK(keeps(folder.file("extra.exr"), render(room, {"-o", folder.file("extra.exr")})));
  CHECK(
      fails_naming(run_tool(render(room, {"-o", folder.file("not yet.png")})), "is also an input"));
  fs::create_hard_link(room, folder.file("scene.hdr"));
  CHECK(keeps(room, render(room, {"-o", folder.file("scene.hdr")})));
  fs::create_symlink(room, folder.file("link.glb"));
  CHECK(keeps(room, {"convert", room, folder.file("link.glb")}));
  // The difference picture is not the texture of the scene that --scene names either.
  REQUIRE(run_tool(render(room, {"-o", folder.file("a.exr")})).exit_code == 0);
  CHECK(keeps(folder.file("room.png"), {"compare", folder.file("a.exr"), folder.file("a.exr"),
                                        "--scene", room, "--diff", folder.file("room.png")}));
}

TEST_CASE("the_same_output_by_two_spellings_is_noticed_before_anything_exists") {
  const TemporaryFolder folder;
  fs::create_directory(folder.file("deep"));
  fs::create_directory_symlink("deep", folder.file("link"));
  RunOptions here;
  here.folder = folder.file("deep");
  const std::vector<std::string> others = {"./x", "../deep/x", "../link/x", folder.file("deep/x"),
                                           folder.file("link/../deep/x")};
  for (const std::string& other : others) {
    CAPTURE(other);
    CHECK(fails_naming(run_tool(render(demo_scene(), {"-o", "x.exr", "-o", other + ".exr"}), here),
                       "written twice"));
    CHECK(fails_naming(
        run_tool({"fit", "--size", "8", "--quiet", "-o", "x.json", "-o", other + ".json"}, here),
        "written twice"));
    CHECK(fails_naming(
        run_tool({"fit", "--size", "8", "--quiet", "-o", "x.json", "--report", other + ".json"},
                 here),
        "written twice"));
    CHECK(fails_naming(run_tool({"plot", "point", "-o", "x.svg", "-o", other + ".svg"}, here),
                       "written twice"));
  }
  CHECK(fs::is_empty(folder.file("deep")));
}

TEST_CASE("links_stay_links_and_modes_stay") {
  const TemporaryFolder folder;
  fs::create_directory(folder.file("deep"));
  fs::create_symlink("deep/real.png", folder.file("x.png"));
  for (int round = 0; round < 2; ++round) { // dangling, then not
    CHECK(run_tool(render(demo_scene(), {"-o", folder.file("x.png")})).exit_code == 0);
    CHECK(fs::is_symlink(folder.file("x.png")));
    CHECK(fs::is_regular_file(fs::symlink_status(folder.file("deep/real.png"))));
    REQUIRE(chmod(folder.file("deep/real.png").c_str(), 0600) == 0);
  }
  CHECK(mode_of(folder.file("deep/real.png")) == 0600);
}

TEST_CASE("a_pipe_gets_the_same_bytes_as_a_file") {
  const TemporaryFolder folder;
  const std::string pipe = folder.file("pipe.exr"), plain = folder.file("plain.exr");
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  std::vector<std::uint8_t> got;
  std::thread reader([&] { got = bytes_of(pipe); });
  CHECK(run_tool(render(demo_scene(), {"-o", pipe, "-o", plain})).exit_code == 0);
  reader.join();
  CHECK(got == bytes_of(plain));
  CHECK(fs::is_fifo(pipe));
  CHECK(folder.file_count() == 2);
}

TEST_CASE("a_full_device_is_named_and_no_other_output_changes") {
  const TemporaryFolder folder;
  fs::create_symlink("/dev/full", folder.file("full.exr"));
  write_text(folder.file("x.png"), "old");
  const Run run =
      run_tool(render(demo_scene(), {"-o", folder.file("x.png"), "-o", folder.file("full.exr")}));
  CHECK(fails_naming(run, "full.exr: cannot write: No space left on device"));
  CHECK(holds(folder.file("x.png"), "old"));
  CHECK(folder.file_count() == 2);
}
