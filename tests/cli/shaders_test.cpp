// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// openltc shaders: the files that it writes, and what it refuses. Their text is tested in
// tests/shaders.

#include "tests/cli/tool.h"

#include <doctest/doctest.h>

using namespace openltc::test;

TEST_CASE("shaders_writes_one_file_named_after_what_is_in_it") {
  const TemporaryFolder folder;
  struct Case {
    std::vector<std::string> arguments;
    std::string name, word;
  };
  const std::vector<Case> cases = {
      {{"--language", "glsl"}, "ltc_quad.glsl", "vec3 ltc_shade_quad("},
      {{"--language", "hlsl", "--shapes", "tube,disk"},
       "ltc_disk_tube.hlsl",
       "float3 ltc_shade_tube("},
      {{"--language", "wgsl", "--lobe", "two-lobe"},
       "ltc_quad_two_lobe.wgsl",
       "fn ltc_shade_quad("},
      {{"--language", "metal", "--shapes", "all", "--prefix", "A"},
       "A_lights.metal",
       "float3 Ashade_line("}};
  for (const Case& c : cases) {
    CAPTURE(c.name);
    std::vector<std::string> arguments = {"shaders", "-o", folder.file("")};
    arguments.insert(arguments.end(), c.arguments.begin(), c.arguments.end());
    const Run run = run_tool(arguments);
    CHECK(run.exit_code == 0);
    CHECK(run.out.empty());
    CHECK(run.err == "wrote " + folder.file(c.name) + "\n");
    CHECK(contains(text_of(folder.file(c.name)), c.word));
  }
  CHECK(folder.file_count() == int(cases.size()));
}

TEST_CASE("shaders_refuses_what_it_does_not_know_in_one_line") {
  const TemporaryFolder folder;
  const std::string to = folder.file("");
  CHECK(refuses_usage(run_tool({"shaders", "--language", "cg", "-o", to}), "'cg'"));
  CHECK(refuses_usage(run_tool({"shaders", "-o", to}), "--language"));
  CHECK(refuses_usage(run_tool({"shaders", "--language", "glsl"}), "--output"));
  CHECK(refuses_usage(run_tool({"shaders", "--language", "glsl", "-o", ""}), "must not be empty"));
  CHECK(refuses_usage(run_tool({"shaders", "--language", "glsl", "--lobe", "three", "-o", to}),
                      "'three'"));
  for (const char* shapes : {"cube", "quad,cube", "quad, disk", "Quad"}) {
    CAPTURE(shapes);
    CHECK(refuses_usage(run_tool({"shaders", "--language", "glsl", "--shapes", shapes, "-o", to}),
                        "--shapes"));
  }
  for (const char* prefix : {"7up", "a-b", "x__", "gl_", "_", "a b", "\xc3\xa4"}) {
    CAPTURE(prefix);
    CHECK(refuses_usage(run_tool({"shaders", "--language", "glsl", "--prefix", prefix, "-o", to}),
                        "--prefix"));
  }
  CHECK(folder.file_count() == 0);
}

TEST_CASE("shaders_says_where_it_cannot_write") {
  const TemporaryFolder folder;
  const std::string missing = folder.file("missing"), file = folder.file("file");
  CHECK(fails_naming(run_tool({"shaders", "--language", "glsl", "-o", missing}), missing));
  write_text(file, "text");
  CHECK(fails_naming(run_tool({"shaders", "--language", "glsl", "-o", file}), file));
  CHECK(text_of(file) == "text");
}
