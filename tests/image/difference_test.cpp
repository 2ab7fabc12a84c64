// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Colour scales, the font, and the difference picture made of them.

#include "openltc/image/compare/difference.h"
#include "openltc/image/file.h"
#include "openltc/image/font.h"
#include "openltc/image/tonemap.h"
#include "tests/image/make_picture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using namespace openltc;
using namespace openltc::image;
using namespace openltc::image::test;

namespace {

float display_luminance(Vec3f c) {
  return luminance({linear_from_srgb(c.x), linear_from_srgb(c.y), linear_from_srgb(c.z)});
}

// CIE 1976 lightness.
float lightness(Vec3f c) {
  const float y = display_luminance(c);
  return y > 0.008856f ? 116.0f * std::cbrt(y) - 16.0f : 903.3f * y;
}

bool contains(const Image& image, Vec3f color) {
  for (std::size_t i = 0; i < image.data.size(); i += 3)
    if (image.data[i] == color.x && image.data[i + 1] == color.y && image.data[i + 2] == color.z)
      return true;
  return false;
}

} // namespace

TEST_CASE("sequential colour scales brighten all along, diverging ones to the middle and back") {
  for (Colormap map : {Colormap::magma, Colormap::viridis})
    for (int i = 0; i < 256; ++i)
      REQUIRE(display_luminance(map_color(map, float(i) / 256.0f)) <
              display_luminance(map_color(map, float(i + 1) / 256.0f)));
  for (int i = 0; i < 128; ++i) {
    const float t = float(i) / 256.0f, next = float(i + 1) / 256.0f;
    const Vec3f blue = map_color(Colormap::blue_red, t);
    const Vec3f red = map_color(Colormap::blue_red, 1.0f - t);
    REQUIRE(display_luminance(blue) < display_luminance(map_color(Colormap::blue_red, next)));
    REQUIRE(display_luminance(red) < display_luminance(map_color(Colormap::blue_red, 1.0f - next)));
    REQUIRE(std::fabs(lightness(blue) - lightness(red)) < 12.0f);
    REQUIRE(blue.z >= blue.x);
    REQUIRE(red.x >= red.z);
  }
}

TEST_CASE("steps of lightness along a colour scale are even") {
  for (Colormap map : {Colormap::magma, Colormap::viridis}) {
    const float whole = lightness(map_color(map, 1.0f)) - lightness(map_color(map, 0.0f));
    for (int i = 0; i < 8; ++i) {
      const float step = lightness(map_color(map, float(i + 1) / 8.0f)) -
                         lightness(map_color(map, float(i) / 8.0f));
      CHECK(step > 0.6f * whole / 8.0f);
      CHECK(step < 1.4f * whole / 8.0f);
    }
  }
}

TEST_CASE("colour scales clamp, and take NaN for 0") {
  for (Colormap map : {Colormap::magma, Colormap::viridis, Colormap::blue_red}) {
    CHECK(map_color(map, -1.0f).x == map_color(map, 0.0f).x);
    CHECK(map_color(map, 9.0f).x == map_color(map, 1.0f).x);
    CHECK(map_color(map, std::numeric_limits<float>::quiet_NaN()).x == map_color(map, 0.0f).x);
  }
}

TEST_CASE("the characters of the font all differ, and text is cut where it does not fit") {
  std::set<std::vector<float>> glyphs;
  for (char c = ' '; c <= '~'; ++c) {
    Image cell(k_glyph_advance, k_glyph_height, 1);
    draw_text(cell, 0, 0, std::string(1, c), Vec3f(1.0f));
    for (int y = 0; y < k_glyph_height; ++y) // the column between characters stays free
      REQUIRE(cell.pixel(k_glyph_advance - 1, y)[0] == 0.0f);
    CHECK(glyphs.insert(cell.data).second);
  }
  Image small(7, 5, 3);
  draw_text(small, -3, -4, "clipped on every side", Vec3f(1.0f), 2); // must stay inside

  CHECK(text_width("abc", 2) == 34);
  CHECK(fit_text("short", 200, 1) == "short");
  const std::string cut =
      fit_text("a/long/path/to/picture.exr", text_width("...picture.exr", 2), 2);
  CHECK(cut == "...picture.exr");
  CHECK(fit_text("long text", 1, 1).empty());
}

TEST_CASE("the automatic scale ends at a round number that at most 1 % of the pixels exceed") {
  for (float scale : {1.0f, 0.037f, 2200.0f}) {
    Image map = random_image(100, 100, 1, 50, 0.0f, scale);
    const float end = automatic_scale_max(map);
    const auto above =
        std::count_if(map.data.begin(), map.data.end(), [&](float v) { return v > end; });
    CHECK(above <= 100);
    const double leading = double(end) / std::pow(10.0, std::floor(std::log10(double(end)) + 1e-6));
    CHECK((std::fabs(leading - 1) < 1e-5 || std::fabs(leading - 2) < 1e-5 ||
           std::fabs(leading - 5) < 1e-5));
  }
  Image sparse(100, 100, 1);
  CHECK(automatic_scale_max(sparse) == 1.0f);
  sparse.data[7] = 3.0f;
  CHECK(automatic_scale_max(sparse) == 5.0f);
}

TEST_CASE("the difference map holds the differences it is named after") {
  Image a(2, 1, 3), b(2, 1, 3);
  a.data = {1, 2, 3, 0, std::numeric_limits<float>::quiet_NaN(), 0};
  b.data = {2, 2, 1, 0, 0, 0};
  CHECK(difference_map(a, b, DifferenceKind::absolute, 0.5).data[0] == doctest::Approx(1.0f));
  CHECK(difference_map(a, b, DifferenceKind::relative, 0.5).data[0] ==
        doctest::Approx((0.4 + 0.0 + 2.0 / 1.5) / 3));
  CHECK(difference_map(a, b, DifferenceKind::signed_relative, 0.5).data[0] ==
        doctest::Approx((-0.4 + 0.0 + 2.0 / 1.5) / 3));
  CHECK(std::isnan(difference_map(a, b, DifferenceKind::relative, 0.5).data[1]));
}

TEST_CASE("the difference picture shows map, scale, bad and masked pixels at any size") {
  const int sizes[][2] = {{1, 1}, {3, 200}, {700, 2}, {64, 48}, {1280, 720}};
  for (const auto& size : sizes) {
    const int width = size[0], height = size[1];
    CAPTURE(width);
    CAPTURE(height);
    Image map(width, height, 1);
    map.data[0] = 1.0f;
    for (bool is_signed : {false, true}) {
      DifferencePictureOptions options;
      options.title = "relative difference";
      options.caption = "a rather long caption that does not fit on pictures as narrow as this";
      options.is_signed = is_signed;
      options.scale_max = 1.0f;
      options.colormap = is_signed ? Colormap::blue_red : Colormap::magma;
      const Image picture = difference_picture(map, options);
      CHECK(picture.channels == 3);
      CHECK(picture.width > width);
      CHECK(picture.height > height);
      CHECK(contains(picture, map_color(options.colormap, 0.0f)));
      if (width * height > 1) // the map's zeros
        CHECK(contains(picture, map_color(options.colormap, is_signed ? 0.5f : 0.0f)));
      CHECK(contains(picture, map_color(options.colormap, 1.0f)));
      CHECK(std::all_of(picture.data.begin(), picture.data.end(),
                        [](float v) { return v >= 0.0f && v <= 1.0f; }));
    }
  }
  Image map(20, 20, 1);
  map.data[5] = std::numeric_limits<float>::quiet_NaN();
  CHECK(contains(difference_picture(map), {0.1f, 1.0f, 0.3f}));
  DifferencePictureOptions options;
  std::vector<std::uint8_t> mask(400, 1);
  mask[5] = 0;
  options.mask = mask;
  CHECK(!contains(difference_picture(map, options), {0.1f, 1.0f, 0.3f}));
}
