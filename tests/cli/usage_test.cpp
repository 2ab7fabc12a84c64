// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Help that teaches, and wrong usage: exit code 2, one line.

#include "tests/cli/tool.h"

#include <doctest/doctest.h>

using namespace openltc::test;

TEST_CASE("help_of_the_tool_names_every_command_and_what_it_does") {
  const Run help = run_tool({"--help"});
  CHECK(help.exit_code == 0);
  CHECK(help.err.empty());
  for (const char* command :
       {"render", "fit", "compare", "inspect", "convert", "plot", "shaders", "view"})
    CHECK(contains(help.out, std::string("\n  ") + command + " "));
  CHECK(line_count(help.out) < 30); // the whole tool at a glance
  const Run version = run_tool({"--version"});
  CHECK(version.exit_code == 0);
  CHECK(contains(version.out, "openltc "));
}

TEST_CASE("help_of_each_command_lists_its_options_and_examples") {
  struct Case {
    std::string command;
    std::vector<std::string> words;
  };
  const std::vector<Case> commands = {
      {"render",
       {"--integrator",
        "--samples",
        "--shadow-samples",
        "--point-lights",
        "--lights",
        "--recognise-shapes",
        "--shape-tolerance",
        "--camera",
        "--size",
        "--exposure",
        "--tonemap",
        "--background",
        "--seed",
        "--threads",
        "-o,",
        "--half",
        "--table",
        "--json",
        "--quiet",
        "ltc|reference",
        "neutral|aces|none",
        ".exr",
        "openltc render"}},
      {"fit",
       {"--brdf",
        "--list",
        "--size",
        "--objective",
        "balanced",
        "--form",
        "table|polynomial",
        "--degree",
        "--layout",
        "native|ltc_code|unity|godot|o3de",
        "--precision",
        "float32|float16",
        "--refine",
        "auto|on|off",
        "--clip-aware",
        "-o,",
        ".ktx2",
        "--report",
        ".html",
        "--against",
        "openltc fit"}},
      {"shaders",
       {"--language", "glsl|glsl-es|hlsl|metal|wgsl|gdshader", "--lobe",
        "polynomial|two-lobe-polynomial|table|two-lobe", "--shapes", "textured", "--prefix", "-o,",
        "openltc shaders"}},
      {"view", {"--port", "--no-open", "--page", "127.0.0.1", "openltc view"}},
      {"convert", {"--layout", "--precision", "--from-layout", "--size", "openltc convert"}},
      {"compare", {"--metric", "--diff", "--json", "FLIP", "openltc compare"}},
      {"inspect", {"--json", ".glb", ".exr", "openltc inspect"}}};
  for (const Case& c : commands) {
    CAPTURE(c.command);
    const Run help = run_tool({c.command, "--help"});
    CHECK(help.exit_code == 0);
    CHECK(help.err.empty());
    for (const std::string& word : c.words) {
      CAPTURE(word);
      CHECK(contains(help.out, word));
    }
  }
}

TEST_CASE("no_command_or_an_unknown_one_is_wrong_usage") {
  CHECK(refuses_usage(run_tool({}), "--help"));
  CHECK(refuses_usage(run_tool({"paint"}), "paint"));
}

TEST_CASE("wrong_options_and_values_are_named_in_one_line") {
  struct Case {
    std::vector<std::string> arguments;
    std::string named;
  };
  const std::string scene = demo_scene();
  const std::vector<Case> cases = {
      {{"render"}, "scene"},
      {{"render", scene, "--colour"}, "--colour"},
      {{"render", scene, "second.glb"}, "second.glb"},
      {{"render", scene, "--samples", "0"}, "--samples"},
      {{"render", scene, "--samples", "many"}, "--samples"},
      {{"render", scene, "--shadow-samples", "-1"}, "--shadow-samples"},
      {{"render", scene, "--integrator", "path"}, "--integrator"},
      {{"render", scene, "--integrator", "1"}, "ltc or reference"},
      {{"render", scene, "--lights", "sun"}, "'sun'"},
      {{"render", scene, "--tonemap", "filmic"}, "--tonemap"},
      {{"render", scene, "--point-lights", "2"}, "--point-lights"},
      {{"render", scene, "--exposure", "bright"}, "--exposure bright"},
      {{"render", scene, "--exposure", "nan"}, "--exposure nan"},
      {{"render", scene, "--background", "1,2"}, "--background 1,2"},
      {{"render", scene, "--background", "1,-2,3"}, "--background 1,-2,3"},
      {{"render", scene, "--threads", "x"}, "--threads"},
      {{"render", scene, "--seed", "x"}, "--seed"},
      {{"render", scene, "--kernel", "gpu"}, "--kernel"},
      {{"render", scene, "--size"}, "--size"},
      {{"fit", "--size", "1"}, "--size"},
      {{"fit", "--brdf", "velvet"}, "velvet"},
      {{"compare", "a.exr"}, "B"},
      {{"inspect"}, "file"},
      {{"inspect", scene, "--loud"}, "--loud"}};
  for (const Case& c : cases) {
    CAPTURE(c.named);
    CHECK(refuses_usage(run_tool(c.arguments), c.named));
  }
}

TEST_CASE("numbers_are_whole_finite_in_range_and_there") {
  const TemporaryFolder folder;
  const std::string scene = demo_scene(), png = folder.file("x.png");
  const std::vector<std::string> whole = {"",    " ",   "1e3",        "0x10",
                                          "1.5", "nan", "inf",        "1 ",
                                          "+",   "-1",  "4294967296", "99999999999999999999",
                                          "4,5"};
  std::vector<std::string> fractions = {"",      " ",  "nan", "NaN",  "-nan",   "inf", "-inf",
                                        "1e999", "-1", "2",   "0.5x", "0x1p-2", "1,5", "1e-999"};
  struct Case {
    std::vector<std::string> command;
    std::string option;
    const std::vector<std::string>& values;
  };
  const std::vector<Case> cases = {
      {{"render", scene, "-o", png}, "--samples", whole},
      {{"render", scene, "-o", png}, "--shadow-samples", whole},
      {{"render", scene, "-o", png}, "--seed", whole},
      {{"render", scene, "-o", png}, "--threads", whole},
      {{"render", scene, "-o", png}, "--light-error", fractions},
      {{"render", scene, "-o", png}, "--shape-tolerance", fractions},
      {{"inspect", scene}, "--shape-tolerance", fractions},
      {{"convert", scene, folder.file("x.glb")}, "--shape-tolerance", fractions},
      {{"convert", scene, folder.file("x.glb")}, "--size", whole},
      {{"fit"}, "--size", whole},
      {{"fit", "--form", "polynomial"}, "--degree", whole}};
  for (const Case& c : cases)
    for (const std::string& value : c.values) {
      CAPTURE(c.command[0]);
      CAPTURE(c.option);
      CAPTURE(value);
      std::vector<std::string> arguments = c.command;
      arguments.push_back(c.option);
      arguments.push_back(value);
      CHECK(refuses_usage(run_tool(arguments), c.option));
    }
  // From 2^-127 to 2^128 a float holds the factor.
  for (const char* value : {"", "nan", "inf", "1e9", "-1e9", "128", "-130", "12,5", "auto "})
    CHECK(refuses_usage(run_tool({"render", scene, "-o", png, "--exposure", value}), "--exposure"));
  for (const char* value : {"", "nan", "inf", "1e39", "-1", "1,2", "1,2,", "1,2,nan", "1,2,3,4"})
    CHECK(refuses_usage(run_tool({"render", scene, "-o", png, "--background", value}),
                        "--background"));
  for (const char* value : {"", "nan,1,1", "1,inf,1", "1,1", "-1,1,1", "0,0,0"})
    CHECK(refuses_usage(run_tool({"fit", "--objective", value}), "--objective"));
  CHECK(folder.file_count() == 0);
}

TEST_CASE("decimal_digits_are_decimal") {
  const TemporaryFolder folder;
  const std::string octal = folder.file("a.exr"), ten = folder.file("b.exr");
  const auto render = [&](const std::string& seed, const std::string& to) {
    return run_tool({"render", demo_scene(), "--quiet", "--size", "32x18", "--samples", "1",
                     "--seed", seed, "-o", to})
        .exit_code;
  };
  CHECK(render("010", octal) == 0);
  CHECK(render("10", ten) == 0);
  CHECK(bytes_of(octal) == bytes_of(ten));
}

TEST_CASE("an_empty_argument_is_not_an_option_left_out") {
  const std::string scene = demo_scene();
  for (const char* option : {"-o", "--camera", "--size", "--table", "--background", "--lights"})
    CHECK(refuses_usage(run_tool({"render", scene, option, ""}), "must not be empty"));
  CHECK(refuses_usage(run_tool({"render", ""}), "must not be empty"));
  CHECK(refuses_usage(run_tool({"inspect", ""}), "must not be empty"));
  CHECK(refuses_usage(run_tool({"compare", "a.exr", "b.exr", "--mask", ""}), "must not be empty"));
  for (const char* option : {"-o", "--report", "--against", "--brdf"})
    CHECK(refuses_usage(run_tool({"fit", option, ""}), "must not be empty"));
  CHECK(refuses_usage(run_tool({"plot", "lobes", "-o", ""}), "must not be empty"));
}

TEST_CASE("absurd_picture_sizes_are_refused_in_one_line") {
  for (const char* size :
       {"0x0", "-1x5", "64x", "x64", "abc", "64", "64x36x2", "64.5x36", "9999999999999x2"}) {
    CAPTURE(size);
    CHECK(refuses_usage(run_tool({"render", demo_scene(), "--size", size}), size));
  }
  // Numbers, but more than a picture can have; not the memory of the machine.
  for (const char* size : {"99999999x2", "32768x32768"}) {
    CAPTURE(size);
    const TemporaryFolder folder;
    const Run run =
        run_tool({"render", demo_scene(), "--quiet", "--size", size, "-o", folder.file("x.png")});
    CHECK(fails_naming(run, size));
    CHECK(folder.file_count() == 0);
  }
}

TEST_CASE("wrong_usage_of_a_figure_names_the_figure") {
  for (const char* figure : {"error", "literal", "lobes", "polygon"}) {
    const std::string command = std::string("openltc plot ") + figure;
    CHECK(refuses_usage(run_tool({"plot", figure, "--no-such"}), command + ": "));
    CHECK(refuses_usage(run_tool({"plot", figure, "--scale", "0"}), "see " + command + " --help"));
  }
  CHECK(refuses_usage(run_tool({"plot"}), "see openltc plot --help"));
}
