// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Radiance pictures: the format's precision, its orders of pixels, and what its headers may say.

#include "openltc/image/file.h"
#include "tests/image/make_picture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace openltc;
using namespace openltc::image;
using namespace openltc::image::test;

namespace {

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
constexpr float k_inf = std::numeric_limits<float>::infinity();

} // namespace

TEST_CASE("Radiance files are within 1/256 of the pixel's largest channel") {
  const TemporaryFolder folder;
  // Widths below 8 are stored plainly, others by runs; long flat stretches make long runs.
  for (int width : {1, 7, 8, 130, 700}) {
    Image picture = random_image(width, 6, 3, 6, 0.0f, 3.0f);
    for (float& v : picture.data)
      v = std::exp(20.0f * (v - 1.5f));
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c) {
        picture.pixel(x, 1)[c] = 0.25f;                      // one run
        picture.pixel(x, 2)[c] = x % 40 < 20 ? 0.0f : 64.0f; // some runs
        picture.pixel(x, 3)[c] = x % 5 < 3 ? 1.0f : 2.0f;    // runs too short to be stored
      }
    const std::string path = folder.file("picture.hdr");
    REQUIRE(write_hdr(path, picture).ok());
    const Result<Image> got = read(path);
    REQUIRE(got.ok());
    REQUIRE(got->width == width);
    REQUIRE(got->height == 6);
    for (std::size_t i = 0; i < picture.data.size(); ++i) {
      const float* pixel = &picture.data[i / 3 * 3];
      const float largest = std::max({pixel[0], pixel[1], pixel[2]});
      REQUIRE(std::fabs(got->data[i] - picture.data[i]) <= largest / 256.0f);
    }
    // What came out of the format goes into it again without loss.
    REQUIRE(write_hdr(path, *got).ok());
    const Result<Image> again = read(path);
    REQUIRE(again.ok());
    CHECK(again->data == got->data);
  }
}

TEST_CASE("Radiance writing replaces what the format cannot hold") {
  const TemporaryFolder folder;
  Image picture(8, 1, 3);
  const float values[] = {-1, 0.5f,   0.25f,  k_nan, 1,     1, k_inf, 0,
                          0,  1e-45f, 1e-44f, 0,     3e38f, 1, 1};
  std::copy(std::begin(values), std::end(values), picture.data.begin());
  REQUIRE(write_hdr(folder.file("a.hdr"), picture).ok());
  const Result<Image> got = read(folder.file("a.hdr"));
  REQUIRE(got.ok());
  CHECK(got->data[0] == 0.0f);
  CHECK(got->data[1] == 0.5f);
  CHECK(got->data[3] == 0.0f);
  CHECK(got->data[4] == 1.0f);
  CHECK(got->data[6] == doctest::Approx(1.6947e38f).epsilon(1e-3));
  CHECK(got->data[9] == 0.0f);
  CHECK(got->data[12] == got->data[6]);
}

TEST_CASE("Radiance reading obeys EXPOSURE, orientation and the older run-length encoding") {
  const TemporaryFolder folder;
  const auto text = [](std::string header, std::vector<std::uint8_t> pixels) {
    header.append(pixels.begin(), pixels.end());
    return std::vector<std::uint8_t>(header.begin(), header.end());
  };
  const std::string path = folder.file("old.hdr");
  // Exponent 136 makes the mantissa the value. The second pixel is repeated three times.
  write_bytes(path, text("#?RADIANCE\n# a comment\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\nEXPOSURE= 4"
                         "\n\n+Y 2 -X 3\n",
                         {8,  16, 24, 136, 80, 0, 0, 136, 1, 1, 1, 1, //
                          40, 40, 40, 136, 1,  1, 1, 2}));
  const Result<Image> got = read(path);
  REQUIRE(got.ok());
  REQUIRE(got->width == 3);
  REQUIRE(got->height == 2);
  CHECK(got->rgb(2, 1).x == 1.0f);
  CHECK(got->rgb(2, 1).z == 3.0f);
  CHECK(got->rgb(1, 1).x == 10.0f);
  CHECK(got->rgb(0, 1).x == 10.0f);
  for (int x = 0; x < 3; ++x)
    CHECK(got->rgb(x, 0).y == 5.0f);
}

namespace {

// A Radiance file of 3 x 2 pixels, each of which has its own colour, as `header` and the resolution
// line say; `pixels` are six times R, G, B, to which the exponent 136 is added.
Image read_radiance(const std::string& header, const std::string& resolution,
                    const std::vector<std::uint8_t>& colors) {
  const TemporaryFolder folder;
  std::vector<std::uint8_t> bytes(header.begin(), header.end());
  bytes.insert(bytes.end(), resolution.begin(), resolution.end());
  for (std::size_t i = 0; i < colors.size(); i += 3)
    bytes.insert(bytes.end(), {colors[i], colors[i + 1], colors[i + 2], 136});
  write_bytes(folder.file("a.hdr"), bytes);
  const Result<Image> image = read(folder.file("a.hdr"));
  if (!image) MESSAGE(image.error().message);
  REQUIRE(image.ok());
  return *image;
}

const std::string k_rgbe = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";

std::vector<std::uint8_t> six_pixels() {
  std::vector<std::uint8_t> colors;
  for (std::uint8_t i = 0; i < 18; ++i)
    colors.push_back(std::uint8_t(10 + 3 * i));
  return colors;
}

} // namespace

TEST_CASE("all eight orders of a Radiance picture are the same picture") {
  // Radiance reference manual, picture file format: the first axis is that of the scan lines'
  // order, +X to the right, +Y up.
  const int width = 3, height = 2;
  const auto value = [](int x, int y) { return std::uint8_t(20 + 10 * y + 3 * x); }; // y down
  for (const bool x_first : {false, true})
    for (const bool x_down : {false, true})
      for (const bool y_up : {false, true}) {
        std::vector<std::uint8_t> colors;
        const int lines = x_first ? width : height, length = x_first ? height : width;
        for (int j = 0; j < lines; ++j)
          for (int i = 0; i < length; ++i) {
            int x = x_first ? j : i, y = x_first ? i : j;
            if (x_down) x = width - 1 - x;
            if (y_up) y = height - 1 - y;
            const std::uint8_t v = value(x, y);
            colors.insert(colors.end(), {v, std::uint8_t(v + 1), std::uint8_t(v + 2)});
          }
        const std::string x_axis = std::string(x_down ? "-X " : "+X ") + "3";
        const std::string y_axis = std::string(y_up ? "+Y " : "-Y ") + "2";
        const std::string line = x_first ? x_axis + " " + y_axis : y_axis + " " + x_axis;
        CAPTURE(line);
        const Image image = read_radiance(k_rgbe, line + "\n", colors);
        REQUIRE(image.width == width);
        REQUIRE(image.height == height);
        for (int y = 0; y < height; ++y)
          for (int x = 0; x < width; ++x) {
            REQUIRE(image.pixel(x, y)[0] == float(value(x, y)));
            REQUIRE(image.pixel(x, y)[2] == float(value(x, y) + 2));
          }
      }
}

TEST_CASE("Radiance headers of Windows, and lines that count or do not") {
  const Image plain = read_radiance(k_rgbe, "-Y 2 +X 3\n", six_pixels());
  CHECK(plain.pixel(0, 0)[0] == 10.0f);
  for (const char* header :
       {"#?RADIANCE\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n", "#?RGBE\n\n",
        "#?RADIANCE\nFORMAT= 32-bit_rle_rgbe \nPRIMARIES=0 0 0 0 0 0 0 0\n\n",
        // Indented lines are another picture's; unknown ones are passed over.
        "#?RADIANCE\nother.hdr:\n\tEXPOSURE=4\nVIEW= -vtv\nPIXASPECT=1\nGAMMA=1\n"
        "PRIMARIES=0.640 0.330 0.300 0.600 0.150 0.060 0.3127 0.3290\n\n"}) {
    CAPTURE(header);
    CHECK(read_radiance(header, "-Y 2 +X 3\r\n", six_pixels()).data == plain.data);
  }
  const Image corrected =
      read_radiance("#?RADIANCE\nEXPOSURE=2\nCOLORCORR=2 4 .5\nEXPOSURE=.5\nCOLORCORR= 1 2 1\n\n",
                    "-Y 2 +X 3\n", six_pixels());
  for (std::size_t i = 0; i < plain.data.size(); ++i)
    CHECK(corrected.data[i] == plain.data[i] / std::vector<float>{2, 8, 0.5f}[i % 3]);
}

TEST_CASE("Radiance pictures in CIE XYZ or of other primaries become Rec.709") {
  // 100 times the XYZ of red and of white of IEC 61966-2-1, to whole numbers.
  const Image image = read_radiance("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n", "-Y 1 +X 2\n",
                                    {41, 21, 2, 95, 100, 109});
  CHECK(image.pixel(0, 0)[0] == doctest::Approx(100).epsilon(0.01));
  CHECK(std::fabs(image.pixel(0, 0)[1]) < 1.0f);
  CHECK(std::fabs(image.pixel(0, 0)[2]) < 1.0f);
  for (int c = 0; c < 3; ++c)
    CHECK(image.pixel(1, 0)[c] == doctest::Approx(100).epsilon(0.005));
  // Display P3's red is (1.2249, -.0420, -.0196) in Rec.709 (CSS Color 4); white stays white.
  const Image p3 =
      read_radiance("#?RADIANCE\nPRIMARIES=0.680 0.320 0.265 0.690 0.150 0.060 0.3127 0.3290\n\n",
                    "-Y 1 +X 2\n", {100, 0, 0, 100, 100, 100});
  CHECK(p3.pixel(0, 0)[0] == doctest::Approx(122.49).epsilon(1e-3));
  CHECK(p3.pixel(0, 0)[1] == doctest::Approx(-4.20).epsilon(5e-3));
  CHECK(p3.pixel(0, 0)[2] == doctest::Approx(-1.96).epsilon(5e-3));
  for (int c = 0; c < 3; ++c)
    CHECK(p3.pixel(1, 0)[c] == doctest::Approx(100));
}

TEST_CASE("Radiance headers that say nothing sensible are refused") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.hdr");
  for (const char* header :
       {"FORMAT=32-bit_rle_cmyk\n\n-Y 1 +X 1\n", "EXPOSURE=nan\n\n-Y 1 +X 1\n",
        "EXPOSURE=0\n\n-Y 1 +X 1\n", "COLORCORR=1 1\n\n-Y 1 +X 1\n",
        "COLORCORR=1 -1 1\n\n-Y 1 +X 1\n", "EXPOSURE=1e25\nEXPOSURE=1e25\n\n-Y 1 +X 1\n",
        "PRIMARIES=1 2 3\n\n-Y 1 +X 1\n", "PRIMARIES=.1 .1 .1 .1 .1 .1 .3 .3\n\n-Y 1 +X 1\n",
        "\n-Y 1 +Y 1\n", "\n+X 1 -X 1\n", "\n-Y 1\n", "\n-Y 1 +X 1 2\n", "\n-Y1 +X 1\n",
        "\nY 1 X 1\n", "\n\n"}) {
    CAPTURE(header);
    const std::string text = std::string("#?RADIANCE\n") + header;
    std::vector<std::uint8_t> bytes(text.begin(), text.end());
    bytes.insert(bytes.end(), {1, 2, 3, 128});
    write_bytes(path, bytes);
    const Result<Image> image = read(path);
    REQUIRE_FALSE(image.ok());
    CHECK(image.error().message.find(path + ": ") == 0);
    CHECK(image.error().message.find('\n') == std::string::npos);
  }
}
