// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/image/file.h"
#include "openltc/light/emission_stack.h"
#include "openltc/light/shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <unistd.h>

using namespace openltc;

namespace {

light::PolygonLight rectangle(float width, float height) {
  light::PolygonLight light;
  light.name = "panel";
  light.vertices = {{0, 0, 0}, {width, 0, 0}, {width, height, 0}, {0, height, 0}};
  light.ring_end = {4};
  light.normal = {0, 0, 1};
  light.radiance = {1, 1, 1};
  light::place_texture(light, 0, {1, 0, 0});
  return light;
}

light::EllipseLight disk(float radius) {
  light::EllipseLight light;
  light.name = "disk";
  light.half_u = {radius, 0, 0};
  light.half_v = {0, radius, 0};
  light.radiance = {1, 1, 1};
  light::place_texture(light, 0, {1, 0, 0});
  return light;
}

image::Image noise(int width, int height) {
  std::mt19937 generator(3);
  image::Image image(width, height, 3);
  for (float& value : image.data)
    value = float(generator() >> 8) * 0x1p-24f;
  return image;
}

bool same_place(Vec3f a, Vec3f b) { return length(a - b) < 1e-6f; }

// Colour of a texel without the light's share.
Vec3f color(const light::EmissionStack& stack, std::size_t texel) {
  const float* t = stack.texels.data() + 4 * texel;
  return Vec3f(t[0], t[1], t[2]) / t[3];
}

} // namespace

TEST_CASE("a uniform picture is uniform at every level, whatever the outline") {
  image::Image picture(20, 30, 3);
  for (std::size_t i = 0; i < picture.data.size(); ++i)
    picture.data[i] = float(i % 3) + 1;
  auto stack = light::build_emission_stack(picture, disk(0.5f));
  REQUIRE(stack.ok());
  for (std::size_t i = 0; i < stack->texels.size() / 4; ++i) {
    if (stack->texels[4 * i + 3] == 0) continue;
    CHECK(color(*stack, i).x == doctest::Approx(1).epsilon(1e-5));
    CHECK(color(*stack, i).z == doctest::Approx(3).epsilon(1e-5));
  }
}

TEST_CASE("levels halve down to one texel, which is the light's mean") {
  const image::Image picture = noise(100, 40);
  auto stack = light::build_emission_stack(picture, disk(0.5f));
  REQUIRE(stack.ok());
  std::size_t first = 0;
  int columns = stack->view.levels[1], rows = stack->view.levels[2];
  for (int l = 0; l < stack->view.level_count; ++l) {
    const std::int32_t* level = stack->view.levels + 4 * l;
    CHECK(std::size_t(level[0]) == first);
    CHECK(level[1] == columns);
    CHECK(level[2] == rows);
    first += std::size_t(columns) * std::size_t(rows);
    columns = std::max(columns / 2, 1);
    rows = std::max(rows / 2, 1);
  }
  CHECK(first * 4 == stack->texels.size());
  // The mean over the disk, point by point.
  double sum = 0;
  int inside = 0;
  for (int y = 0; y < 1000; ++y)
    for (int x = 0; x < 1000; ++x) {
      const double u = (x + 0.5) / 1000, v = (y + 0.5) / 1000;
      if (std::hypot(u - 0.5, v - 0.5) > 0.5) continue;
      ++inside;
      sum += double(picture.rgb(int(u * 100), int(v * 40)).y);
    }
  CHECK(stack->mean.y == doctest::Approx(sum / inside).epsilon(0.005));
  const Vec3f last = color(*stack, first - 1);
  CHECK(last.y == doctest::Approx(stack->mean.y));
  // And its share of the bounding square.
  CHECK(stack->texels.back() == doctest::Approx(0.785398).epsilon(0.002));
}

TEST_CASE("holes and what is outside give nothing to the picture around them") {
  // Bright inside the hole, 1 elsewhere.
  image::Image picture(64, 64, 3);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      for (int c = 0; c < 3; ++c)
        picture.pixel(x, y)[c] = x >= 20 && x < 44 && y >= 20 && y < 44 ? 1000.0f : 1.0f;
  light::PolygonLight light = rectangle(1, 1);
  const float a = 0.25f, b = 0.75f; // the hole, a little larger than what is bright
  light.vertices.insert(light.vertices.end(), {{a, a, 0}, {a, b, 0}, {b, b, 0}, {b, a, 0}});
  light.ring_end = {4, 8};
  auto stack = light::build_emission_stack(picture, light);
  REQUIRE(stack.ok());
  for (std::size_t i = 0; i < stack->texels.size() / 4; ++i)
    if (stack->texels[4 * i + 3] > 0) {
      CHECK(color(*stack, i).x == doctest::Approx(1).epsilon(1e-5));
    }
  CHECK(stack->texels.back() == doctest::Approx(0.75).epsilon(1e-4));
}

TEST_CASE("a picture is upright and not mirrored for who faces the light") {
  const light::PolygonLight facing = rectangle(2, 1);
  // Seen from +z, x runs to the right and y upwards: the first texel is at the upper left.
  CHECK(same_place(facing.texture_corner, {0, 1, 0}));
  CHECK(same_place(facing.texture_u, {2, 0, 0}));
  CHECK(same_place(facing.texture_v, {0, -1, 0}));
  const light::EllipseLight round = disk(3);
  CHECK(same_place(round.texture_corner, {-3, 3, 0}));
  CHECK(same_place(round.texture_v, {0, -6, 0}));

  image::Image picture(2, 2, 3);
  picture.pixel(1, 0)[0] = 1; // upper right
  auto stack = light::build_emission_stack(picture, facing);
  REQUIRE(stack.ok());
  CHECK(
      same_place({stack->view.corner[0], stack->view.corner[1], stack->view.corner[2]}, {0, 1, 0}));
  const std::size_t columns = std::size_t(stack->view.levels[1]);
  CHECK(color(*stack, columns - 1).x == 1.0f);
  CHECK(color(*stack, 0).x == 0.0f);
}

TEST_CASE("a large picture is reduced, keeps its mean and the memory's bound") {
  const image::Image picture = noise(3000, 1100);
  light::EmissionStackOptions options;
  options.max_side = 256;
  auto stack = light::build_emission_stack(picture, rectangle(3, 1), options);
  REQUIRE(stack.ok());
  CHECK(stack->view.levels[1] == 256);
  CHECK(stack->view.levels[2] == 256);
  CHECK(stack->texels.size() * sizeof(float) < 256 * 256 * 16 * 1.4);
  double sum = 0;
  for (const float value : picture.data)
    sum += double(value);
  const double mean = double(stack->mean.x + stack->mean.y + stack->mean.z) / 3;
  CHECK(mean == doctest::Approx(sum / double(picture.data.size())).epsilon(1e-3));
}

TEST_CASE("EXR, HDR and PNG sources make the same light") {
  const std::string base =
      (std::filesystem::temp_directory_path() / ("openltc_emission_" + std::to_string(getpid())))
          .string();
  image::Image picture = noise(24, 16);
  image::Image display = picture;
  for (float& value : display.data)
    value = image::srgb_from_linear(value);
  const image::Layer layer{"", picture};
  REQUIRE(image::write_exr(base + ".exr", {&layer, 1}).ok());
  REQUIRE(image::write_hdr(base + ".hdr", picture).ok());
  REQUIRE(image::write_png(base + ".png", display).ok());
  auto expected = light::build_emission_stack(picture, rectangle(1, 1));
  REQUIRE(expected.ok());
  for (const char* extension : {".exr", ".hdr", ".png"}) {
    CAPTURE(extension);
    auto read = image::read(base + extension);
    REQUIRE(read.ok());
    auto stack = light::build_emission_stack(*read, rectangle(1, 1));
    REQUIRE(stack.ok());
    REQUIRE(stack->texels.size() == expected->texels.size());
    for (std::size_t i = 0; i < stack->texels.size(); ++i)
      if (std::abs(stack->texels[i] - expected->texels[i]) > 0.005f) {
        CHECK(stack->texels[i] == doctest::Approx(expected->texels[i]));
      }
    std::filesystem::remove(base + extension);
  }
}

TEST_CASE("what cannot be a picture is refused by the light's name; odd values count as none") {
  const light::PolygonLight good = rectangle(1, 1);
  CHECK(!light::build_emission_stack(image::Image(), good).ok());
  light::PolygonLight bad = good;
  bad.texture_u = {0, 0, 1};
  auto result = light::build_emission_stack(noise(4, 4), bad);
  REQUIRE(!result.ok());
  CHECK(result.error().message.find("panel") != std::string::npos);
  bad = good;
  bad.texture_v = {0, 0, 0};
  CHECK(!light::build_emission_stack(noise(4, 4), bad).ok());

  image::Image odd(2, 1, 3);
  odd.data = {-1, std::numeric_limits<float>::quiet_NaN(), 1, 2, 1, 1};
  auto stack = light::build_emission_stack(odd, good);
  REQUIRE(stack.ok());
  for (const float value : stack->texels)
    CHECK((std::isfinite(value) && value >= 0));
}
