// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What a light shows of its texture: means over what falls together, by sums in double.

#include "openltc/base/memory_budget.h"
#include "openltc/light/texture_part.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

using namespace openltc;

namespace {

image::Texels some_picture(int width, int height) {
  std::vector<std::uint8_t> samples(std::size_t(width) * std::size_t(height) * 3);
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = std::uint8_t((i * i + 31 * i) >> 3);
  return {width, height, 3, std::move(samples), true};
}

} // namespace

TEST_CASE("a_reduced_picture_holds_the_means") {
  const image::Texels picture = some_picture(120, 90);
  const auto part = light::reduced_part(picture, 12, 30, {}, "a light");
  REQUIRE(part.ok());
  CHECK(part->pixels.width == 12);
  CHECK(part->pixels.height == 30);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 12; ++x) {
      Vec3d sum{0, 0, 0};
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 10; ++i)
          sum += to_double(picture.rgb(10 * x + i, 3 * y + j));
      const Vec3f mean = part->bilinear((x + 0.5) / 12, (y + 0.5) / 30);
      REQUIRE(double(mean.y) == doctest::Approx(sum.y / 30).epsilon(1e-5));
    }
}

TEST_CASE("sides_that_do_not_divide_lose_no_light") {
  const image::Texels picture = some_picture(101, 67);
  const auto part = light::reduced_part(picture, 16, 9, {}, "a light");
  REQUIRE(part.ok());
  double reduced = 0, whole = 0;
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 16; ++x)
      reduced += double(part->pixels.rgb(x, y).x) / (16 * 9);
  for (int y = 0; y < 67; ++y)
    for (int x = 0; x < 101; ++x)
      whole += double(picture.rgb(x, y).x) / (101 * 67);
  CHECK(reduced == doctest::Approx(whole).epsilon(1e-5));
}

TEST_CASE("only_what_is_shown_is_held") {
  // 2000 x 2000 pixels, of which a light shows a hundredth along each side.
  const image::Texels picture = some_picture(2000, 2000);
  const light::TextureRange shown{0.4, 0.7, 0.41, 0.71};
  const auto part = light::reduced_part(picture, 2000, 2000, shown, "a light");
  REQUIRE(part.ok());
  CHECK(part->pixels.pixel_count() < 30 * 30);
  // At a pixel's centre its own value.
  for (int i = 800; i < 820; ++i) {
    const Vec3f value = part->bilinear((i + 0.5) / 2000, (i + 600.5) / 2000);
    CHECK(value.z == doctest::Approx(picture.rgb(i, i + 600).z).epsilon(1e-4));
  }
}

TEST_CASE("a_reduced_picture_counts_before_it_is_made") {
  const image::Texels picture = some_picture(500, 500);
  const std::uint64_t limit = memory_budget().limit();
  memory_budget().set_limit(memory_budget().in_use() + 1000000);
  const auto refused = light::reduced_part(picture, 500, 500, {}, "the lamp");
  memory_budget().set_limit(limit);
  REQUIRE(!refused.ok()); // 500 x 500 x 12 bytes
  CHECK(refused.error().message.find("the lamp: ") == 0);
  CHECK(refused.error().message.find("--memory") != std::string::npos);
}
