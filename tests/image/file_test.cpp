// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Every format gives back what was written, to the precision it promises.

#include "openltc/image/file.h"
#include "tests/image/make_picture.h"

#include <doctest/doctest.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace openltc;
using namespace openltc::image;
using namespace openltc::image::test;

namespace {

bool same_bits(float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
constexpr float k_inf = std::numeric_limits<float>::infinity();

} // namespace

TEST_CASE("EXR in full precision keeps every layer and value exactly, NaN and infinity too") {
  const TemporaryFolder folder;
  for (int channels : {3, 4}) {
    Image picture = random_image(37, 21, channels, 1, -5.0f, 1e6f);
    picture.data[3] = k_nan;
    picture.data[7] = k_inf;
    picture.data[8] = -k_inf;
    const Image error = random_image(37, 21, 3, 2);
    const Image depth = random_image(37, 21, 1, 3);
    const std::vector<Layer> layers = {{"", picture}, {"stderr", error}, {"depth", depth}};
    const std::string path = folder.file("layers.exr");
    REQUIRE(write_exr(path, layers).ok());

    const Result<Image> got = read(path);
    REQUIRE(got.ok());
    CHECK(got->width == 37);
    CHECK(got->height == 21);
    REQUIRE(got->channels == channels);
    CHECK(std::equal(got->data.begin(), got->data.end(), picture.data.begin(), same_bits));
    const Result<Image> got_error = read_layer(path, "stderr");
    REQUIRE(got_error.ok());
    CHECK(got_error->data == error.data);
    const Result<Image> got_depth = read_layer(path, "depth");
    REQUIRE(got_depth.ok());
    CHECK(got_depth->channels == 1);
    CHECK(got_depth->data == depth.data);
    const auto names = layer_names(path);
    REQUIRE(names.ok());
    CHECK(*names == std::vector<std::string>{"", "depth", "stderr"});

    const Result<Image> missing = read_layer(path, "albedo");
    REQUIRE(!missing.ok());
    CHECK(missing.error().message.find("albedo") != std::string::npos);
    CHECK(missing.error().message.find("'stderr'") != std::string::npos);
    CHECK(missing.error().message.find(path) == 0);
  }
}

TEST_CASE("EXR in half precision is rounded to 11 bits and saturates instead of overflowing") {
  const TemporaryFolder folder;
  Image picture = random_image(64, 5, 3, 4, 1e-3f, 100.0f);
  picture.data[0] = 1e9f;
  picture.data[1] = -1e9f;
  picture.data[2] = k_inf;
  picture.data[3] = k_nan;
  const std::vector<Layer> layers = {{"", picture}};
  const std::string path = folder.file("half.exr");
  REQUIRE(write_exr(path, layers, ExrPrecision::half_float).ok());
  const Result<Image> got = read(path);
  REQUIRE(got.ok());
  CHECK(got->data[0] == 65504.0f);
  CHECK(got->data[1] == -65504.0f);
  CHECK(got->data[2] == k_inf);
  CHECK(std::isnan(got->data[3]));
  for (std::size_t i = 4; i < picture.data.size(); ++i)
    REQUIRE(std::fabs(got->data[i] - picture.data[i]) <= picture.data[i] * 0x1p-11f);
}

TEST_CASE("a grey EXR is read as RGB") {
  const TemporaryFolder folder;
  const std::vector<Layer> layers = {{"", random_image(9, 4, 1, 5)}};
  REQUIRE(write_exr(folder.file("grey.EXR"), layers).ok());
  const Result<Image> got = read(folder.file("grey.EXR"));
  REQUIRE(got.ok());
  REQUIRE(got->channels == 3);
  for (std::size_t i = 0; i < layers[0].image.data.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      REQUIRE(got->data[3 * i + c] == layers[0].image.data[i]);
}

TEST_CASE("EXR refuses layers that do not belong together") {
  const TemporaryFolder folder;
  const std::string path = folder.file("bad.exr");
  const Image a(4, 4, 3), b(5, 4, 3), two(4, 4, 2);
  CHECK(!write_exr(path, {}).ok());
  CHECK(!write_exr(path, std::vector<Layer>{{"", a}, {"b", b}}).ok());
  CHECK(!write_exr(path, std::vector<Layer>{{"", a}, {"", a}}).ok());
  CHECK(!write_exr(path, std::vector<Layer>{{"named", a}}).ok());
  CHECK(!write_exr(path, std::vector<Layer>{{"", two}}).ok());
  CHECK(!write_exr(path, std::vector<Layer>{{"", Image()}}).ok());
  CHECK(folder.file_count() == 0);
}

TEST_CASE("an 8-bit PNG keeps every code value") {
  const TemporaryFolder folder;
  for (int channels : {1, 3, 4}) {
    Image display(16, 16, channels);
    for (std::size_t i = 0; i < display.pixel_count(); ++i)
      for (std::size_t c = 0; c < std::size_t(channels); ++c)
        display.data[i * std::size_t(channels) + c] = float((i + 85 * c) % 256) / 255.0f;
    REQUIRE(write_png(folder.file("a.png"), display).ok());
    const Result<Image> got = read(folder.file("a.png"));
    REQUIRE(got.ok());
    CHECK(got->channels == (channels == 4 ? 4 : 3));
    for (std::size_t i = 0; i < display.pixel_count(); ++i)
      for (std::size_t c = 0; c < std::size_t(got->channels); ++c) {
        const float v = display.data[i * std::size_t(channels) + (channels == 1 ? 0 : c)];
        REQUIRE(got->data[i * std::size_t(got->channels) + c] ==
                (c == 3 ? doctest::Approx(v) : doctest::Approx(linear_from_srgb(v))));
      }
  }
}

TEST_CASE("PNG writing clamps, and NaN becomes black") {
  const TemporaryFolder folder;
  Image display(2, 1, 3);
  display.data = {-1.0f, 2.0f, k_nan, k_inf, -k_inf, 0.5f};
  REQUIRE(write_png(folder.file("a.png"), display).ok());
  const Result<Image> got = decode(file_bytes(folder.file("a.png")), "a", false);
  REQUIRE(got.ok());
  CHECK(got->data == std::vector<float>{0.0f, 1.0f, 0.0f, 1.0f, 1.0f, 0.0f, 128.0f / 255.0f, 1.0f});
}

TEST_CASE("PNG files of every kind are decoded to four channels") {
  struct Kind {
    int color_type, bit_depth;
    std::vector<std::uint8_t> rows; // of a picture of 2x1
    std::vector<float> expected;    // without transfer function
  };
  const float s = 1.0f / 255.0f, s16 = 1.0f / 65535.0f;
  const std::vector<Kind> kinds = {
      {PNG_COLOR_TYPE_GRAY, 1, {0x40}, {0, 0, 0, 1, 1, 1, 1, 1}},
      {PNG_COLOR_TYPE_GRAY, 4, {0x3C}, {.2f, .2f, .2f, 1, .8f, .8f, .8f, 1}},
      {PNG_COLOR_TYPE_GRAY, 8, {7, 9}, {7 * s, 7 * s, 7 * s, 1, 9 * s, 9 * s, 9 * s, 1}},
      {PNG_COLOR_TYPE_GRAY,
       16,
       {1, 2, 3, 4},
       {258 * s16, 258 * s16, 258 * s16, 1, 772 * s16, 772 * s16, 772 * s16, 1}},
      {PNG_COLOR_TYPE_GRAY_ALPHA,
       8,
       {7, 9, 11, 13},
       {7 * s, 7 * s, 7 * s, 9 * s, 11 * s, 11 * s, 11 * s, 13 * s}},
      {PNG_COLOR_TYPE_RGB, 8, {1, 2, 3, 4, 5, 6}, {s, 2 * s, 3 * s, 1, 4 * s, 5 * s, 6 * s, 1}},
      {PNG_COLOR_TYPE_RGB_ALPHA,
       16,
       {0, 1, 0, 2, 0, 3, 0, 4, 1, 0, 2, 0, 3, 0, 4, 0},
       {s16, 2 * s16, 3 * s16, 4 * s16, 256 * s16, 512 * s16, 768 * s16, 1024 * s16}},
      {PNG_COLOR_TYPE_PALETTE, 8, {0, 5}, {0, 0, 0, 0, 15 * s, 10 * s, 5 * s, 1}},
      {PNG_COLOR_TYPE_PALETTE, 2, {0x30}, {0, 0, 0, 0, 9 * s, 6 * s, 3 * s, 1}},
  };
  for (const Kind& kind : kinds) {
    CAPTURE(kind.color_type);
    CAPTURE(kind.bit_depth);
    for (bool interlaced : {false, true}) {
      const auto bytes = make_png(2, 1, kind.color_type, kind.bit_depth, kind.rows, interlaced);
      const Result<Image> plain = decode(bytes, "texture 3", false);
      const Result<Image> linear = decode(bytes, "texture 3", true);
      REQUIRE(plain.ok());
      REQUIRE(linear.ok());
      REQUIRE(plain->channels == 4);
      for (std::size_t i = 0; i < 8; ++i) {
        CHECK(plain->data[i] == doctest::Approx(kind.expected[i]).epsilon(1e-6));
        CHECK(linear->data[i] ==
              doctest::Approx(i % 4 == 3 ? kind.expected[i] : linear_from_srgb(kind.expected[i]))
                  .epsilon(1e-6));
      }
    }
  }
}

TEST_CASE("JPEG is decoded to what was written, within its own loss") {
  const TemporaryFolder folder;
  const int width = 33, height = 18;
  for (int channels : {1, 3}) {
    std::vector<std::uint8_t> samples;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (int c = 0; c < channels; ++c)
          samples.push_back(std::uint8_t(60 + 4 * x + 2 * y - 20 * c));
    const auto bytes = make_jpeg(width, height, channels, samples);
    const Result<Image> got = decode(bytes, "embedded", false);
    REQUIRE(got.ok());
    REQUIRE(got->channels == 4);
    for (std::size_t i = 0; i < got->pixel_count(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        const auto from = i * std::size_t(channels) + (channels == 1 ? 0 : c);
        REQUIRE(std::fabs(got->data[4 * i + c] * 255.0f - float(samples[from])) < 6.0f);
      }
      REQUIRE(got->data[4 * i + 3] == 1.0f);
    }
    write_bytes(folder.file("a.JPG"), bytes);
    const Result<Image> from_file = read(folder.file("a.JPG"));
    REQUIRE(from_file.ok());
    CHECK(from_file->channels == 3);
    CHECK(from_file->data[3] == doctest::Approx(linear_from_srgb(got->data[4])));
  }
}

TEST_CASE("the textures of the real scenes are decoded") {
  const std::filesystem::path folder = std::filesystem::path(OPENLTC_SHARED_DIR) / "scenes";
  if (!std::filesystem::is_directory(folder)) {
    MESSAGE("skipped: " << folder.string() << " is not there");
    return;
  }
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string path = entry.path().string();
    if (!path.ends_with(".png") && !path.ends_with(".jpg")) continue;
    CAPTURE(path);
    const Result<Image> image = read(path);
    REQUIRE(image.ok());
    CHECK(image->pixel_count() > 0);
    const auto [least, most] = std::minmax_element(image->data.begin(), image->data.end());
    CHECK(*least >= 0.0f);
    CHECK(*most <= 1.0f);
    CHECK(*most > 0.0f);
    ++count;
  }
  CHECK(count > 0);
}

TEST_CASE("the sRGB transfer function and its inverse undo each other") {
  CHECK(srgb_from_linear(0.0f) == 0.0f);
  CHECK(srgb_from_linear(1.0f) == doctest::Approx(1.0f));
  CHECK(srgb_from_linear(0.18f) == doctest::Approx(0.46135613f)); // from the standard's formula
  CHECK(linear_from_srgb(0.5f) == doctest::Approx(0.21404114f));
  float before = -1.0f;
  for (int i = -2000; i <= 2000; ++i) {
    const float x = float(i) / 1000.0f;
    REQUIRE(linear_from_srgb(srgb_from_linear(x)) == doctest::Approx(x).epsilon(1e-5));
    REQUIRE(srgb_from_linear(x) > before - 2.0f);
    if (i > -2000) REQUIRE(srgb_from_linear(x) > before);
    before = srgb_from_linear(x);
  }
}

TEST_CASE("extensions that can be written") {
  CHECK(is_writable_extension("a.exr"));
  CHECK(is_writable_extension("b/c.HDR"));
  CHECK(is_writable_extension("x.Png"));
  CHECK(!is_writable_extension("x.jpg"));
  CHECK(!is_writable_extension("png"));
  CHECK(is_scene_linear_extension("a.EXR"));
  CHECK(!is_scene_linear_extension("a.png"));
}
