// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What a render writes: formats that agree, radiance that no display option touches, and nothing
// else.

#include "openltc/image/file.h"
#include "openltc/image/tonemap.h"
#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace openltc;
using namespace openltc::test;
namespace fs = std::filesystem;

namespace {

// The demo scene, small and quick, with these arguments behind.
std::vector<std::string> quick(std::vector<std::string> more) {
  std::vector<std::string> arguments = {"render", demo_scene(), "--quiet", "--size",
                                        "64x36",  "--samples",  "2",       "--shadow-samples",
                                        "2"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

} // namespace

TEST_CASE("several_outputs_of_one_render_agree") {
  const TemporaryFolder folder;
  const std::string exr = folder.file("x.exr"), hdr = folder.file("x.hdr"),
                    png = folder.file("x.png");
  const float ev100 = 10;
  const Run run = run_tool(quick({"-o", exr, "-o", hdr, "-o", png, "--exposure", "10"}));
  REQUIRE(run.exit_code == 0);
  CHECK(folder.file_count() == 3);
  const Result<image::Image> radiance = image::read(exr), rgbe = image::read(hdr),
                             shown = image::read(png);
  REQUIRE(radiance.ok());
  REQUIRE(rgbe.ok());
  REQUIRE(shown.ok());
  CHECK(radiance->width == 64);
  CHECK(radiance->height == 36);

  const image::Image expected =
      image::to_display(*radiance, image::exposure_from_ev100(ev100), image::Tonemap::neutral);
  double worst_rgbe = 0, worst_png = 0, brightest = 0;
  for (int y = 0; y < 36; ++y)
    for (int x = 0; x < 64; ++x) {
      const Vec3f a = radiance->rgb(x, y), b = rgbe->rgb(x, y), c = shown->rgb(x, y);
      const double largest = double(std::max({a.x, a.y, a.z}));
      brightest = std::max(brightest, largest);
      for (const float difference : {a.x - b.x, a.y - b.y, a.z - b.z})
        worst_rgbe = std::max(worst_rgbe, double(std::abs(difference)) / std::max(largest, 1e-30));
      const float* wanted = expected.pixel(x, y);
      const float channels[] = {c.x, c.y, c.z};
      for (int i = 0; i < 3; ++i)
        worst_png =
            std::max(worst_png, double(std::abs(image::srgb_from_linear(channels[i]) - wanted[i])));
    }
  CHECK(brightest > 100);        // nits: the scene is lit
  CHECK(worst_rgbe < 1.0 / 255); // 8 bits of mantissa for the largest channel
  CHECK(worst_png < 0.51 / 255); // rounded to 8 bits
}

TEST_CASE("display_options_change_the_png_and_nothing_else") {
  const TemporaryFolder folder;
  const auto render = [&](const std::string& name, const std::vector<std::string>& options) {
    std::vector<std::string> arguments =
        quick({"-o", folder.file(name + ".exr"), "-o", folder.file(name + ".hdr"), "-o",
               folder.file(name + ".png")});
    arguments.insert(arguments.end(), options.begin(), options.end());
    REQUIRE(run_tool(arguments).exit_code == 0);
  };
  render("plain", {});
  render("exposed", {"--exposure", "12"});
  render("aces", {"--tonemap", "aces"});
  render("none", {"--tonemap", "none", "--exposure", "-3.5"});
  for (const std::string name : {"exposed", "aces", "none"}) {
    CAPTURE(name);
    CHECK(bytes_of(folder.file(name + ".exr")) == bytes_of(folder.file("plain.exr")));
    CHECK(bytes_of(folder.file(name + ".hdr")) == bytes_of(folder.file("plain.hdr")));
    CHECK(bytes_of(folder.file(name + ".png")) != bytes_of(folder.file("plain.png")));
  }
}

TEST_CASE("half_precision_halves_the_file_and_keeps_three_digits") {
  const TemporaryFolder folder;
  const std::string full = folder.file("full.exr"), half = folder.file("half.exr");
  REQUIRE(run_tool(quick({"-o", full})).exit_code == 0);
  REQUIRE(run_tool(quick({"-o", half, "--half"})).exit_code == 0);
  CHECK(fs::file_size(half) < 0.7 * double(fs::file_size(full)));
  const image::Image a = *image::read(full), b = *image::read(half);
  REQUIRE(a.data.size() == b.data.size());
  double worst = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i)
    if (a.data[i] > 1e-3f && a.data[i] < 65504)
      worst = std::max(worst, double(std::abs(a.data[i] - b.data[i]) / a.data[i]));
  CHECK(worst > 0);
  CHECK(worst <= 1.0 / 2048); // 11 bits, rounded
}

TEST_CASE("the_reference_writes_its_standard_error") {
  const TemporaryFolder folder;
  const std::string exr = folder.file("x.exr"), hdr = folder.file("x.hdr");
  const Run run =
      run_tool({"render", demo_scene(), "--quiet", "--size", "48x27", "--integrator", "reference",
                "--samples", "16", "-o", exr, "-o", hdr, "-o", folder.file("x.png")});
  REQUIRE(run.exit_code == 0);
  CHECK(*image::layer_names(exr) == std::vector<std::string>{"", "stderr"});
  CHECK(folder.file_count() == 4); // and x_stderr.hdr
  const Result<image::Image> error = image::read_layer(exr, "stderr"),
                             error_file = image::read(folder.file("x_stderr.hdr"));
  REQUIRE(error.ok());
  REQUIRE(error_file.ok());
  double sum = 0, sum_file = 0;
  for (const float v : error->data) {
    CHECK_FALSE(!(v >= 0 && std::isfinite(v)));
    sum += double(v);
  }
  for (const float v : error_file->data)
    sum_file += double(v);
  CHECK(sum > 0);
  CHECK(sum_file == doctest::Approx(sum).epsilon(0.01));

  // The closed form has none.
  REQUIRE(run_tool(quick({"-o", exr})).exit_code == 0);
  CHECK(*image::layer_names(exr) == std::vector<std::string>{""});
}

TEST_CASE("outputs_that_cannot_be_written_are_refused_before_the_work") {
  const TemporaryFolder folder;
  write_text(folder.file("file"), "not a folder");
  fs::create_directory(folder.file("folder.png"));
  const std::string good = folder.file("good.exr");
  for (const std::string& bad :
       {folder.file("x.bmp"), folder.file("x"), folder.file("missing/x.png"),
        folder.file("file/x.png"), folder.file("folder.png"), std::string("/proc/x.png")}) {
    CAPTURE(bad);
    // A good output beside it is not written either, and hours of samples are not begun.
    const Run run =
        run_tool({"render", demo_scene(), "--quiet", "--size", "1920x1080", "--integrator",
                  "reference", "--samples", "100000", "-o", good, "-o", bad},
                 {"", 0, 10});
    CHECK(fails_naming(run, bad));
    CHECK(run.seconds < 5);
    CHECK_FALSE(fs::exists(good));
  }
  CHECK(folder.file_count() == 2);
}

TEST_CASE("without_output_the_picture_is_named_after_the_scene_and_lies_here") {
  const TemporaryFolder folder;
  write_scene(folder.file("room.gltf"), lit_floor());
  const Run run = run_tool({"render", "room.gltf", "--size", "24x16", "--samples", "1"},
                           {folder.file("."), 0, 60});
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.err, "wrote room.png"));
  CHECK(image::read(folder.file("room.png")).ok());
  CHECK(folder.file_count() == 2);
}

TEST_CASE("progress_goes_to_stderr_and_quiet_is_silent") {
  const TemporaryFolder folder;
  const std::string png = folder.file("x.png");
  const Run loud =
      run_tool({"render", demo_scene(), "--size", "64x36", "--samples", "2", "-o", png});
  CHECK(loud.exit_code == 0);
  CHECK(loud.out.empty());
  CHECK(contains(loud.err, "rendering"));
  CHECK(contains(loud.err, "wrote " + png));
  CHECK_FALSE(contains(loud.err, "\r")); // no terminal: plain lines
  const Run quiet = run_tool(quick({"-o", png}));
  CHECK(quiet.exit_code == 0);
  CHECK(quiet.out.empty());
  CHECK(quiet.err.empty());
}

TEST_CASE("json_says_what_was_done_and_how_long_it_took") {
  const TemporaryFolder folder;
  const std::string png = folder.file("x.png");
  const Run run = run_tool(quick({"-o", png, "--json", "--exposure", "9"}));
  REQUIRE(run.exit_code == 0);
  CHECK(run.err.empty());
  const auto values = json::parse(run.out);
  CHECK(values["width"] == 64);
  CHECK(values["height"] == 36);
  CHECK(values["samples"] == 2);
  CHECK(values["shadow_samples"] == 2);
  CHECK(values["integrator"] == "ltc");
  CHECK(values["area_lights"] == 4);
  CHECK(values["punctual_lights"] == 1);
  CHECK(double(values["ev100"]) == doctest::Approx(9));
  CHECK(values["outputs"] == json::array({png}));
  for (const char* time : {"load_seconds", "build_seconds", "render_seconds"}) {
    CAPTURE(time);
    CHECK(double(values[time]) > 0);
    CHECK(double(values[time]) < run.seconds);
  }
}

TEST_CASE("no_file_is_meant_twice") {
  const TemporaryFolder folder;
  const std::string exr = folder.file("x.exr");
  CHECK(fails_naming(run_tool(quick({"-o", exr, "-o", exr})), "written twice"));
  // The reference's standard error goes to NAME_stderr.hdr.
  CHECK(fails_naming(run_tool(quick({"--integrator", "reference", "-o", folder.file("m.hdr"), "-o",
                                     folder.file("m_stderr.hdr")})),
                     "m_stderr.hdr"));
  CHECK(folder.file_count() == 0);
}

TEST_CASE("one_sample_has_no_standard_error_and_none_is_written") {
  const TemporaryFolder folder;
  const std::string exr = folder.file("x.exr");
  const Run run = run_tool({"render", demo_scene(), "--size", "64x36", "--integrator", "reference",
                            "--samples", "1", "-o", exr});
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.err, "no standard error"));
  CHECK(!image::read_layer(exr, "stderr").ok());
}

TEST_CASE("half_precision_says_when_it_cuts_values") {
  const TemporaryFolder folder;
  write_scene(folder.file("bright.glb"), lit_floor(1e6));
  const std::vector<std::string> render = {
      "render", folder.file("bright.glb"), "--size", "64x36", "--samples", "1", "--half",
      "-o",     folder.file("x.exr")};
  const Run run = run_tool(render);
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.err, "65504"));
}

TEST_CASE("the_reference_takes_no_table") {
  const TemporaryFolder folder;
  CHECK(refuses_usage(run_tool(quick({"--integrator", "reference", "--table", "any.json", "-o",
                                      folder.file("x.exr")})),
                      "--table"));
}
