// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// openltc fit --engine: the files of an engine in a folder, or one line that says what is wrong.

#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <filesystem>

using namespace openltc;
using namespace openltc::test;

TEST_CASE("fit_writes_the_files_of_an_engine") {
  const TemporaryFolder folder;
  const std::string out = folder.file("");
  const Run run = run_tool({"fit", "--engine", "o3de", "-o", out});
  CHECK(run.exit_code == 0);
  CHECK(contains(run.err, "Gems/Atom"));
  // A header of DDS with its DX10 part has 148 bytes; 32 x 32 texels of four floats and of two.
  CHECK(bytes_of(out + "/ltc_mat_lutrgba32f.dds").size() == 148 + 32 * 32 * 16);
  CHECK(bytes_of(out + "/ltc_amp_lutrg32f.dds").size() == 148 + 32 * 32 * 8);
  for (const char* name : {"ltc_mat_lutrgba32f.dds", "ltc_amp_lutrg32f.dds"})
    CHECK(text_of(out + "/" + name) ==
          text_of(std::string(OPENLTC_SOURCE_DIR) + "/tables/o3de/" + name));
  CHECK(contains(text_of(out + "/ltc_table.json"), "openltc fit --brdf ggx --engine o3de\""));
}

TEST_CASE("fit_engine_names_what_is_wrong_usage") {
  const Run run = run_tool({"fit", "--quiet", "--engine", "unreal", "-o", "."});
  CHECK(refuses_usage(run, "'unreal'"));
  for (const char* name :
       {"threejs", "playcanvas", "babylon", "bevy", "eevee", "unity", "godot", "o3de", "ogre-next"})
    CHECK(contains(run.err, name));
  for (const char* option : {"--size", "--layout", "--precision", "--form"}) {
    const std::string value = option == std::string("--size")     ? "32"
                              : option == std::string("--layout") ? "godot"
                              : option == std::string("--form")   ? "table"
                                                                  : "float16";
    CHECK(refuses_usage(run_tool({"fit", "--engine", "godot", option, value}), option));
  }
  CHECK(refuses_usage(run_tool({"fit", "--engine", "godot", "-o", "a", "-o", "b"}), "-o"));
}

TEST_CASE("fit_engine_needs_a_folder") {
  const TemporaryFolder folder;
  const std::string missing = folder.file("missing");
  CHECK(fails_naming(run_tool({"fit", "--engine", "o3de", "-o", missing}), missing));
  CHECK(!std::filesystem::exists(missing));
}
