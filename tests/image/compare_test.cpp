// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// `openltc compare`, run as a user runs it.

#include "openltc/image/compare/flip.h"
#include "openltc/image/file.h"
#include "tests/image/make_exr.h"
#include "tests/image/make_picture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

using namespace openltc;
using namespace openltc::image;
using namespace openltc::image::test;

namespace {

struct Run {
  int exit_code = -1;
  std::string out, err;
};

Run run(const TemporaryFolder& folder, const std::string& arguments) {
  const std::string out = folder.file("stdout"), err = folder.file("stderr");
  const std::string command =
      std::string(OPENLTC_TOOL) + " compare " + arguments + " >" + out + " 2>" + err;
  const int status = std::system(command.c_str());
  const auto text = [](const std::string& path) {
    const auto bytes = file_bytes(path);
    return std::string(bytes.begin(), bytes.end());
  };
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text(out), text(err)};
}

int line_count(const std::string& text) { return int(std::count(text.begin(), text.end(), '\n')); }

// a = 1.1 b, with b from 1 to 2.
struct Pair {
  explicit Pair(const TemporaryFolder& folder) : a(folder.file("a.exr")), b(folder.file("b.exr")) {
    const Image reference = random_image(60, 40, 3, 60, 1.0f, 2.0f);
    Image test = reference;
    for (float& v : test.data)
      v *= 1.1f;
    REQUIRE(write_exr(a, std::vector<Layer>{{"", test}}).ok());
    REQUIRE(write_exr(b, std::vector<Layer>{{"", reference}}).ok());
  }
  std::string a, b;
};

} // namespace

TEST_CASE("compare prints a table, and the same numbers as JSON") {
  const TemporaryFolder folder;
  const Pair pair(folder);
  const Run table = run(folder, pair.a + " " + pair.b);
  CHECK(table.exit_code == 0);
  CHECK(table.err.empty());
  for (const char* word : {"RMSE", "relative MSE", "MAE", "PSNR", "FLIP mean", "max absolute"})
    CHECK(table.out.find(word) != std::string::npos);

  const Run json = run(folder, pair.a + " " + pair.b + " --json");
  REQUIRE(json.exit_code == 0);
  const auto values = nlohmann::json::parse(json.out);
  CHECK(values["reference"] == pair.b);
  CHECK(values["width"] == 60);
  CHECK(values["pixels_compared"] == 2400);
  CHECK(double(values["mean_relative_error"]) == doctest::Approx(0.099).epsilon(0.01));
  CHECK(double(values["bias"]) == doctest::Approx(0.15).epsilon(0.02));
  const HdrFlip flip = flip_hdr(*read(pair.a), *read(pair.b));
  CHECK(double(values["flip"]["mean"]) == doctest::Approx(mean_value(flip.map)).epsilon(1e-9));
  CHECK(values["flip"]["kind"] == "hdr");

  // The reference is the second one: the other way round the relative error is another.
  const auto swapped = nlohmann::json::parse(run(folder, pair.b + " " + pair.a + " --json").out);
  CHECK(double(swapped["bias"]) < 0.0);
  CHECK(double(swapped["mean_relative_error"]) < double(values["mean_relative_error"]));
}

TEST_CASE("compare of a picture with itself is zero, and its PSNR null in JSON") {
  const TemporaryFolder folder;
  const Pair pair(folder);
  const Run json = run(folder, pair.b + " " + pair.b + " --json");
  REQUIRE(json.exit_code == 0);
  const auto values = nlohmann::json::parse(json.out);
  CHECK(values["rmse"] == 0.0);
  CHECK(values["flip"]["max"] == 0.0);
  CHECK(values["psnr_db"].is_null());
}

TEST_CASE("compare writes a difference picture of each kind") {
  const TemporaryFolder folder;
  const Pair pair(folder);
  for (const char* metric : {"relative", "absolute", "signed", "flip"}) {
    CAPTURE(metric);
    const std::string png = folder.file(std::string(metric) + ".png");
    const Run result =
        run(folder, pair.a + " " + pair.b + " --diff " + png + " --metric " + metric);
    CHECK(result.exit_code == 0);
    const Result<Image> picture = read(png);
    REQUIRE(picture.ok());
    CHECK(picture->width > 480);
  }
  // Inputs are not overwritten.
  const std::string png = folder.file("relative.png");
  const auto before = file_bytes(png);
  const Run result = run(folder, png + " " + png + " --diff " + png);
  CHECK(result.exit_code == 1);
  CHECK(file_bytes(png) == before);
}

TEST_CASE("compare leaves masked and bad pixels out") {
  const TemporaryFolder folder;
  Image b = random_image(20, 10, 3, 61), a = b, mask(20, 10, 1);
  std::fill(mask.data.begin(), mask.data.end(), 1.0f);
  a.pixel(3, 4)[0] = 50.0f;
  mask.pixel(3, 4)[0] = 0.0f;
  a.pixel(7, 7)[1] = std::numeric_limits<float>::quiet_NaN();
  REQUIRE(write_exr(folder.file("a.exr"), std::vector<Layer>{{"", a}}).ok());
  REQUIRE(write_exr(folder.file("b.exr"), std::vector<Layer>{{"", b}}).ok());
  REQUIRE(write_png(folder.file("mask.png"), mask).ok());
  const std::string files = folder.file("a.exr") + " " + folder.file("b.exr");
  const auto all = nlohmann::json::parse(run(folder, files + " --json").out);
  CHECK(double(all["max_absolute_difference"]) > 40.0);
  CHECK(all["max_absolute_difference_at"] == nlohmann::json::array({3, 4}));
  CHECK(all["pixels_not_finite_in_image"] == 1);
  const auto masked =
      nlohmann::json::parse(run(folder, files + " --json --mask " + folder.file("mask.png")).out);
  CHECK(masked["max_absolute_difference"] == 0.0);
  CHECK(masked["pixels_masked"] == 1);
  CHECK(masked["pixels_compared"] == 198);
}

TEST_CASE("compare shows HDR pictures at an exposure for FLIP, and PNG pictures as they are") {
  const TemporaryFolder folder;
  const Pair pair(folder);
  const std::string files = pair.a + " " + pair.b + " --json";
  for (const char* exposure : {"auto", "1.5", "-3"}) {
    const auto values = nlohmann::json::parse(run(folder, files + " --exposure=" + exposure).out);
    CHECK(values["flip"]["kind"] == "ldr");
    CHECK(double(values["flip"]["mean"]) > 0.0);
    if (std::string(exposure) != "auto")
      CHECK(double(values["flip"]["ev100"]) == doctest::Approx(std::atof(exposure)).epsilon(1e-4));
  }

  const Image a = random_image(30, 30, 3, 62), b = random_image(30, 30, 3, 63);
  REQUIRE(write_png(folder.file("a.png"), a).ok());
  REQUIRE(write_png(folder.file("b.png"), b).ok());
  const auto values = nlohmann::json::parse(
      run(folder, folder.file("a.png") + " " + folder.file("b.png") + " --json").out);
  // 8 bits stand between the two.
  CHECK(double(values["flip"]["mean"]) ==
        doctest::Approx(mean_value(flip_ldr(a, b))).epsilon(0.01));
}

TEST_CASE("compare fails with one line and exit code 1, and 2 for wrong usage") {
  const TemporaryFolder folder;
  const Pair pair(folder);
  const std::string other = folder.file("other.hdr");
  REQUIRE(write_hdr(other, Image(61, 40, 3)).ok());

  const Run sizes = run(folder, pair.a + " " + other);
  CHECK(sizes.exit_code == 1);
  CHECK(line_count(sizes.err) == 1);
  for (const std::string& part : {pair.a, other, std::string("60x40"), std::string("61x40")})
    CHECK(sizes.err.find(part) != std::string::npos);
  CHECK(sizes.out.empty());

  const Run mask = run(folder, pair.a + " " + pair.b + " --mask " + other);
  CHECK(mask.exit_code == 1);
  CHECK(mask.err.find(other) != std::string::npos);

  const Run missing = run(folder, pair.a + " " + folder.file("nothing.exr"));
  CHECK(missing.exit_code == 1);
  CHECK(line_count(missing.err) == 1);
  CHECK(missing.err.find("nothing.exr") != std::string::npos);

  const Run unwritable =
      run(folder, pair.a + " " + pair.b + " --diff " + folder.file("no/folder/d.png"));
  CHECK(unwritable.exit_code == 1);
  CHECK(unwritable.err.find("no/folder") != std::string::npos);

  const std::string black = folder.file("black.png");
  REQUIRE(write_png(black, Image(60, 40, 3)).ok());
  CHECK(run(folder, pair.a + " " + pair.b + " --mask " + black).exit_code == 1);

  const std::string files = pair.a + " " + pair.b;
  for (const std::string& wrong :
       {std::string(), pair.a, files + " --exposure bright", files + " --diff out.jpg",
        files + " --metric flip", files + " --diff d.png --metric ssim",
        files + " --diff d.png --scale 0", files + " --pixels-per-degree -1", files + " --unknown",
        files + " third.exr"}) {
    CAPTURE(wrong);
    const Run result = run(folder, wrong);
    CHECK(result.exit_code == 2);
    CHECK(!result.err.empty());
    CHECK(result.out.empty());
  }
}

TEST_CASE("compare takes the layer that is named, or the only one of colour") {
  const TemporaryFolder folder;
  const Pair pair(folder);
  const Image a = *read(pair.a), b = *read(pair.b);
  const std::string layers = folder.file("layers.exr");
  ExrPart part;
  std::copy_n(std::array<int, 4>{0, 0, 59, 39}.data(), 4, part.data);
  std::copy_n(std::array<int, 4>{0, 0, 59, 39}.data(), 4, part.display);
  const auto add = [&](const std::string& prefix, const Image& image,
                       const std::vector<std::string>& components) {
    for (std::size_t c = 0; c < components.size(); ++c)
      part.channels.push_back(
          {prefix + components[c], [&image, c](int x, int y) { return image.pixel(x, y)[c]; }});
  };
  add("V.Combined.", a, {"R", "G", "B"});
  add("V.Normal.", b, {"X", "Y", "Z"});
  make_exr(layers, {part});
  const auto difference = [&](const std::string& arguments) {
    const Run result = run(folder, arguments + " --json");
    CHECK(result.err.empty());
    REQUIRE(result.exit_code == 0);
    return nlohmann::json::parse(result.out);
  };
  CHECK(difference(layers + " " + pair.a)["rmse"] == 0.0);
  CHECK(difference(layers + " " + pair.a)["image"] == layers + ":V.Combined");
  CHECK(difference(layers + ":V.Combined " + pair.a)["rmse"] == 0.0);
  CHECK(double(difference(layers + ":Combined " + pair.b)["rmse"]) > 0.1);
  const auto vectors = difference("--layer Normal " + layers + " " + layers);
  CHECK(vectors["rmse"] == 0.0);
  CHECK(vectors["flip"].is_null());

  // What is not the same kind of thing is not compared.
  const auto refused = [&](const std::string& arguments, const std::string& part_of_message) {
    const Run result = run(folder, arguments);
    CHECK(result.exit_code == 1);
    CHECK(line_count(result.err) == 1);
    CHECK(result.out.empty());
    CAPTURE(result.err);
    CHECK(result.err.find(part_of_message) != std::string::npos);
  };
  refused(layers + ":Normal " + pair.a, "is a vector, no colours but");
  refused(layers + ":Depth " + pair.a, "no layer 'Depth'");
  refused("--layer Normal " + layers + " " + pair.a, "no layer 'Normal'");
  refused(layers + ":Normal " + layers + ":Normal --diff " + folder.file("d.png") +
              " --metric flip",
          "no colours");
  std::copy_n(std::array<int, 4>{1, 0, 60, 39}.data(), 4, part.display);
  const std::string moved = folder.file("moved.exr");
  make_exr(moved, {part});
  refused(moved + " " + layers, "begins at pixel (1, 0)");

  // A crop is black where nothing is known, and that is said.
  std::copy_n(std::array<int, 4>{0, 0, 59, 39}.data(), 4, part.display);
  std::copy_n(std::array<int, 4>{0, 0, 59, 19}.data(), 4, part.data);
  const std::string crop = folder.file("crop.exr");
  make_exr(crop, {part});
  const Run cropped = run(folder, crop + " " + pair.a + " --json");
  CHECK(cropped.exit_code == 0);
  CHECK(line_count(cropped.err) == 1);
  CHECK(cropped.err.find("60x20 from (0, 0)") != std::string::npos);
  CHECK(double(nlohmann::json::parse(cropped.out)["max_absolute_difference"]) > 1.0);
}

TEST_CASE("compare refuses distances at which FLIP would need all memory") {
  const TemporaryFolder folder;
  const Pair pair(folder);
  for (const char* number : {"1e9", "nan", "inf", "0.5", "1001"})
    CHECK(run(folder, pair.a + " " + pair.b + " --pixels-per-degree " + number).exit_code == 2);
  for (const char* number : {"1", "1000"}) {
    const Run result = run(folder, pair.a + " " + pair.b + " --json --pixels-per-degree " + number);
    REQUIRE(result.exit_code == 0);
    CHECK(nlohmann::json::parse(result.out)["flip"]["mean"].is_number());
  }
}

TEST_CASE("the help of compare says which one is the reference") {
  const TemporaryFolder folder;
  const Run help = run(folder, "--help");
  CHECK(help.exit_code == 0);
  CHECK(help.out.find("B is the reference") != std::string::npos);
  CHECK(help.out.find("--diff") != std::string::npos);
}
