// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// openltc convert and inspect of picture files, and what is refused before it is opened.

#include "openltc/image/file.h"
#include "tests/cli/tool.h"
#include "tests/image/make_exr.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <sys/wait.h>

using namespace openltc;
using namespace openltc::test;
using image::test::ExrPart;
using image::test::make_exr;
using nlohmann::json;

namespace {

image::Image gradient(int channels = 3) {
  image::Image picture(8, 6, channels);
  for (std::size_t i = 0; i < picture.data.size(); ++i)
    picture.data[i] = float(i % 11) / 10.0f;
  return picture;
}

// Two parts: colours V.Combined (R = 1, G = 2, B = 4), and depth.
ExrPart combined_part() {
  ExrPart part;
  part.name = "V";
  part.channels = {{"V.Combined.R", [](int, int) { return 1.0f; }},
                   {"V.Combined.G", [](int, int) { return 2.0f; }},
                   {"V.Combined.B", [](int, int) { return 4.0f; }},
                   {"V.Normal.X", [](int, int) { return 0.0f; }},
                   {"V.Normal.Y", [](int, int) { return -1.0f; }},
                   {"V.Normal.Z", [](int, int) { return 0.5f; }}};
  return part;
}
ExrPart depth_part() {
  ExrPart part;
  part.name = "depth";
  part.channels = {{"Z", [](int x, int) { return float(x); }}};
  part.data[0] = 2;
  return part;
}

void converts(const std::vector<std::string>& arguments) {
  std::vector<std::string> all = {"convert"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const Run result = run_tool(all);
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
}

bool convert_fails(const std::vector<std::string>& arguments, const std::string& part) {
  std::vector<std::string> all = {"convert"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return fails_naming(run_tool(all), part);
}

} // namespace

TEST_CASE("convert_keeps_linear_pictures_linear") {
  const TemporaryFolder folder;
  const image::Image picture = gradient();
  REQUIRE(image::write_hdr(folder.file("a.hdr"), picture).ok());
  converts({folder.file("a.hdr"), folder.file("a.exr")});
  CHECK(image::read(folder.file("a.exr"))->data == image::read(folder.file("a.hdr"))->data);
  converts({folder.file("a.exr"), folder.file("b.hdr")});
  CHECK(image::read(folder.file("b.hdr"))->data == image::read(folder.file("a.hdr"))->data);
  converts({folder.file("a.exr"), folder.file("h.exr"), "--precision", "float16"});
  const image::Image half = *image::read(folder.file("h.exr"));
  for (std::size_t i = 0; i < half.data.size(); ++i) // 8 bits fit into the 11 of half precision
    REQUIRE(half.data[i] == image::read(folder.file("a.hdr"))->data[i]);
}

TEST_CASE("convert_decodes_displayed_pictures_and_exposes_linear_ones") {
  const TemporaryFolder folder;
  REQUIRE(image::write_png(folder.file("a.png"), gradient()).ok());
  converts({folder.file("a.png"), folder.file("a.exr")});
  const image::Image linear = *image::read(folder.file("a.exr"));
  CHECK(linear.data == image::read(folder.file("a.png"))->data);
  // A code value of .8 is .6038 in linear light (IEC 61966-2-1).
  CHECK(linear.data[8] == doctest::Approx(0.6038).epsilon(1e-3));
  converts({folder.file("a.png"), folder.file("copy.png")});
  CHECK(image::read(folder.file("copy.png"))->data == image::read(folder.file("a.png"))->data);

  // EV100 is defined by 1 = 1.2 * 2^EV100 nits at display white (as openltc render has it).
  converts({folder.file("a.exr"), folder.file("b.png"), "--exposure", "0", "--tonemap", "none"});
  const image::Image shown = *image::read(folder.file("b.png"));
  CHECK(shown.data[8] == doctest::Approx(linear.data[8] / 1.2f).epsilon(0.01));
  CHECK(convert_fails({folder.file("a.exr"), folder.file("b.hdr"), "--exposure", "0"},
                      "--exposure and --tonemap are for a .png"));
  CHECK(refuses_usage(
      run_tool({"convert", folder.file("a.exr"), folder.file("b.png"), "--exposure", "nan"}),
      "EV100"));
  CHECK(refuses_usage(run_tool({"convert", folder.file("a.png"), folder.file("b.exr"), "--size",
                                "32", "--layer", "x"}),
                      "are for tables"));
}

TEST_CASE("convert_changes_between_straight_and_premultiplied_alpha") {
  const TemporaryFolder folder;
  image::Image picture(1, 1, 4);
  picture.data = {1.0f, 1.0f, 0.0f, 51.0f / 255.0f}; // a fifth of yellow
  REQUIRE(image::write_png(folder.file("a.png"), picture).ok());
  converts({folder.file("a.png"), folder.file("a.exr")});
  const image::Image exr = *image::read(folder.file("a.exr"));
  CHECK(exr.data[0] == doctest::Approx(0.2));
  CHECK(exr.data[3] == doctest::Approx(0.2));
  converts({folder.file("a.png"), folder.file("a.hdr")});
  CHECK(image::read(folder.file("a.hdr"))->data[1] == doctest::Approx(0.2).epsilon(0.01));
  // Twice as bright as white at EV100 0, without a tone curve: white.
  converts({folder.file("a.exr"), folder.file("b.png"), "--exposure=-2", "--tonemap", "none"});
  CHECK(image::read(folder.file("b.png"))->data == image::read(folder.file("a.png"))->data);
}

TEST_CASE("convert_takes_the_layer_that_is_named") {
  const TemporaryFolder folder;
  const std::string exr = folder.file("layers.exr"), out = folder.file("out.exr");
  make_exr(exr, {combined_part(), depth_part()});
  converts({exr, out});
  CHECK(image::read(out)->rgb(0, 0).z == 4.0f); // the only one of colour
  converts({exr + ":V.Combined", out});
  CHECK(image::read(out)->rgb(0, 0).y == 2.0f);
  converts({exr, out, "--layer", "depth"});
  CHECK(image::read(out)->rgb(5, 0).x == 5.0f);
  CHECK(image::read(out)->rgb(1, 0).x == 0.0f); // outside the data window
  CHECK(convert_fails({exr + ":Normal", out}, "is a vector"));
  CHECK(convert_fails({exr + ":Mist", out}, "no layer 'Mist'"));
  CHECK(convert_fails({exr, exr}, "is also an input"));
  CHECK(convert_fails({exr, folder.file("no/out.exr")}, "does not exist"));
  REQUIRE(image::write_hdr(folder.file("a.hdr"), gradient()).ok());
  CHECK(convert_fails({folder.file("a.hdr"), out, "--layer", "x"}, "has no layers"));
  CHECK(convert_fails({folder.file("a.hdr"), folder.file("a.gif")}, ".exr, .hdr or .png"));
}

TEST_CASE("inspect_lists_every_part_and_layer_of_a_picture") {
  const TemporaryFolder folder;
  const std::string exr = folder.file("layers.exr");
  make_exr(exr, {combined_part(), depth_part()});
  const Run run = run_tool({"inspect", exr, "--json"});
  REQUIRE(run.exit_code == 0);
  const json values = json::parse(run.out);
  REQUIRE(values["layers"].size() == 3);
  CHECK(values["picture"] == "V.Combined");
  CHECK(values["layers"][0]["name"] == "V.Combined");
  CHECK(values["layers"][0]["kind"] == "colour");
  CHECK(values["layers"][0]["channels"]["B"]["max"] == 4);
  CHECK(values["layers"][1]["kind"] == "vector");
  CHECK(values["layers"][1]["channels"]["Y"]["mean"] == -1);
  CHECK(values["layers"][2]["part"] == 1);
  CHECK(values["layers"][2]["data_window"]["x"] == 2);
  CHECK(values["layers"][2]["channels"]["Y"]["max"] == 7);
  const Run text = run_tool({"inspect", exr});
  for (const char* words : {"V.Combined: colour, part 0 'V'", "V.Normal: vector",
                            "depth: one channel, part 1 'depth'", "6x6 from (2, 0)"})
    CHECK(contains(text.out, words));
  for (const std::vector<std::string>& one :
       {std::vector<std::string>{exr + ":Normal"}, {exr, "--layer", "V.Normal"}}) {
    std::vector<std::string> arguments = {"inspect", "--json"};
    arguments.insert(arguments.end(), one.begin(), one.end());
    const json layer = json::parse(run_tool(arguments).out);
    REQUIRE(layer["layers"].size() == 1);
    CHECK(layer["layers"][0]["name"] == "V.Normal");
  }
  CHECK(fails_naming(run_tool({"inspect", exr + ":x"}), "no layer 'x'"));
  image::test::make_deep_exr(folder.file("deep.exr"));
  CHECK(fails_naming(run_tool({"inspect", folder.file("deep.exr")}), "deep data"));
}

TEST_CASE("pipes_are_refused_by_every_command_that_reads_a_file") {
  const TemporaryFolder folder;
  REQUIRE(image::write_hdr(folder.file("a.hdr"), gradient()).ok());
  for (const char* extension : {"exr", "hdr", "png", "jpg", "dds", "json", "npy", "ktx2"}) {
    const std::string pipe = folder.file(std::string("pipe.") + extension);
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0); // who opens it waits for ever
    CHECK(fails_naming(run_tool({"inspect", pipe}), "is a pipe"));
    if (image::is_readable_extension(pipe))
      CHECK(fails_naming(run_tool({"compare", folder.file("a.hdr"), pipe}), "is a pipe"));
    CHECK(fails_naming(run_tool({"convert", pipe, folder.file("out.exr")}), "is a pipe"));
  }
  const std::string pipe = folder.file("pipe.binary");
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_FALSE(run_tool({"fit", "--brdf", pipe}).ended_by);
}

TEST_CASE("options_that_take_numbers_refuse_what_is_none") {
  const TemporaryFolder folder;
  const std::string out = folder.file("out.svg");
  const std::vector<std::vector<std::string>> options = {
      {"render", demo_scene(), "--light-error"},
      {"render", demo_scene(), "--background"},
      {"render", demo_scene(), "--samples"},
      {"render", demo_scene(), "--shadow-samples"},
      {"render", demo_scene(), "--seed"},
      {"render", demo_scene(), "--threads"},
      {"render", demo_scene(), "--size"},
      {"render", demo_scene(), "--shape-tolerance"},
      {"inspect", demo_scene(), "--shape-tolerance"},
      {"convert", demo_scene(), folder.file("out.glb"), "--shape-tolerance"},
      {"convert", folder.file("a.hdr"), folder.file("out.png"), "--exposure"},
      {"convert", folder.file("a.dds"), folder.file("b.dds"), "--size"},
      {"compare", "a.exr", "b.exr", "--exposure"},
      {"compare", "a.exr", "b.exr", "--pixels-per-degree"},
      {"compare", "a.exr", "b.exr", "--diff", "d.png", "--scale"},
      {"fit", "--size"},
      {"fit", "--objective"},
      {"fit", "--form", "polynomial", "--degree"},
      {"plot", "error", "-o", out, "--scale"},
      {"plot", "error", "-o", out, "--points"},
      {"plot", "error", "-o", out, "--roughness"},
      {"plot", "lobes", "-o", out, "--theta"},
      {"plot", "lobes", "-o", out, "--roughness"},
      {"plot", "lobes", "-o", out, "--matrix"},
      {"plot", "lobes", "-o", out, "--sweep"},
      {"plot", "fit", "-o", out, "--theta"},
      {"plot", "fit", "-o", out, "--roughness"},
      {"plot", "point", "-o", out, "--theta"},
      {"plot", "point", "-o", out, "--roughness"},
      {"plot", "point", "-o", out, "--metallic"},
      {"plot", "point", "-o", out, "--f0"},
      {"plot", "point", "-o", out, "--base-color"},
      {"plot", "polygon", "-o", out, "--theta"},
      {"plot", "polygon", "-o", out, "--roughness"},
      {"plot", "polygon", "-o", out, "--matrix"},
      {"plot", "polygon", "-o", out, "--samples"},
      {"plot", "polygon", "-o", out, "--seed"},
      {"plot", "polygon", "-o", out, "--scale"}};
  for (const std::vector<std::string>& option : options)
    for (const char* value : {"nan", "inf", "-inf", "1e400", "-1e30"}) {
      std::vector<std::string> arguments = option;
      arguments.back() += std::string("=") + value;
      const Run run = run_tool(arguments);
      CAPTURE(option[0]);
      CAPTURE(arguments.back());
      CAPTURE(run.err);
      CHECK(run.exit_code == 2);
      CHECK(line_count(run.err) == 1);
    }
}

#if !defined(__SANITIZE_ADDRESS__)
TEST_CASE("a_figure_without_memory_ends_in_one_line") {
  const TemporaryFolder folder;
  // Memory, in KiB, that is enough to start but not for a picture with Embree, fonts and threads.
  for (const char* memory : {"180000", "220000", "260000", "300000"})
    for (const char* what : {"polygon", "error"}) {
      const std::string err = folder.file("err");
      const std::string command = std::string("ulimit -c 0; ulimit -v ") + memory +
                                  "; exec timeout 120 " OPENLTC_TOOL " plot " + what + " -o " +
                                  folder.file("a.png") + " 2>" + err;
      const int status = std::system(command.c_str());
      CAPTURE(memory);
      CAPTURE(what);
      REQUIRE(WIFEXITED(status));
      // 124 is the end by timeout, over 128 that by a signal; 127 a tool that does not start.
      CHECK((WEXITSTATUS(status) == 1 || WEXITSTATUS(status) == 127 || WEXITSTATUS(status) == 0));
      const std::vector<std::uint8_t> bytes = bytes_of(err);
      CHECK(line_count(std::string(bytes.begin(), bytes.end())) == 1);
    }
}
#endif
