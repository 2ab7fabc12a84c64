// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Texels give the values that image::decode gives, to the bit, from the file's own samples.

#include "make_picture.h"
#include "openltc/base/regular_file.h"
#include "openltc/image/file.h"
#include "openltc/image/mip_levels.h"
#include "openltc/image/texels.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

using namespace openltc;
using image::Texels;

namespace {

template <class T> std::vector<T> ramp(std::size_t count, unsigned step) {
  std::vector<T> values(count);
  for (std::size_t i = 0; i < count; ++i)
    values[i] = T(i * step);
  return values;
}

} // namespace

TEST_CASE("texels_of_8_bits_are_linear_by_the_srgb_curve_and_alpha_is_not") {
  const Texels texels(64, 1, 4, ramp<std::uint8_t>(256, 1), true);
  CHECK(texels.byte_count() == 256);
  for (int x = 0; x < 64; ++x) {
    const Vec4f p = texels.rgba(x, 0);
    CHECK(p.x == image::linear_from_srgb(float(4 * x) / 255.0f));
    CHECK(p.z == image::linear_from_srgb(float(4 * x + 2) / 255.0f));
    CHECK(p.w == doctest::Approx((4 * x + 3) / 255.0));
    CHECK(texels.taken_as(false).rgba(x, 0).x == doctest::Approx(4 * x / 255.0));
  }
}

TEST_CASE("texels_of_16_bits_keep_them") {
  const Texels texels(4096, 1, 4, ramp<std::uint16_t>(16384, 4), true);
  CHECK(texels.byte_count() == 32768);
  for (const int x : {0, 1, 77, 4095}) {
    CHECK(texels.rgba(x, 0).x ==
          doctest::Approx(image::linear_from_srgb(float(16 * x) / 65535.0f)).epsilon(1e-6));
    CHECK(texels.taken_as(false).rgba(x, 0).y == doctest::Approx((16 * x + 4) / 65535.0));
  }
}

TEST_CASE("fewer_channels_are_grey_or_opaque") {
  const Texels grey(2, 1, 1, std::vector<std::uint8_t>{0, 255}, false);
  CHECK(grey.rgba(1, 0).y == 1.0f);
  CHECK(grey.rgba(0, 0).w == 1.0f);
  const Texels with_alpha(1, 1, 2, std::vector<std::uint8_t>{255, 51}, false);
  CHECK(with_alpha.rgba(0, 0).z == 1.0f);
  CHECK(with_alpha.rgba(0, 0).w == doctest::Approx(0.2));
  const Texels rgb(1, 1, 3, std::vector<std::uint8_t>{255, 0, 51}, false);
  CHECK(rgb.rgba(0, 0).z == doctest::Approx(0.2));
  CHECK(rgb.rgba(0, 0).w == 1.0f);
  CHECK(rgb.to_image().channels == 3);
  CHECK(with_alpha.to_image().channels == 4);
}

TEST_CASE("floats_are_kept_and_copies_share_them") {
  image::Image picture(2, 2, 3);
  std::iota(picture.data.begin(), picture.data.end(), -3.5f);
  const Texels texels = picture, copy = texels;
  CHECK(texels.to_image().data == picture.data);
  CHECK(copy.identity() == texels.identity());
  CHECK(Texels(picture).identity() != texels.identity());
}

TEST_CASE("decoded_texels_are_those_of_the_float_picture") {
  const image::test::TemporaryFolder folder;
  image::Image picture(13, 7, 4);
  for (std::size_t i = 0; i < picture.data.size(); ++i)
    picture.data[i] = float(i % 251) / 250.0f;
  REQUIRE(image::write_png(folder.file("x.png"), picture).ok());
  const std::vector<std::uint8_t> bytes = *read_regular_file(folder.file("x.png"));
  for (const bool is_color : {true, false}) {
    const auto floats = image::decode(bytes, "x", is_color);
    const auto texels = image::decode_texels(bytes, "x", is_color);
    REQUIRE(floats.ok());
    REQUIRE(texels.ok());
    CHECK(texels->to_image().data == floats->data);
    CHECK(texels->byte_count() * 4 == floats->data.size() * sizeof(float));
  }
}

TEST_CASE("smaller_copies_are_means_of_four_whether_kept_or_computed") {
  struct Size {
    int width, height;
  };
  // The second is larger than what keeps its largest copy; odd sides leave their last pixels out.
  for (const Size size : {Size{7, 5}, Size{4099, 1025}}) {
    const int width = size.width, height = size.height;
    CAPTURE(width);
    for (const int channels : {1, 3, 4}) {
      std::vector<std::uint8_t> samples =
          ramp<std::uint8_t>(std::size_t(width) * std::size_t(height) * std::size_t(channels), 37);
      const Texels picture(width, height, channels, std::move(samples), true);
      const image::MipLevels copies(picture);
      CHECK(copies.count() == int(std::floor(std::log2(width))));
      // The mean of 4 x 4 pixels, in double.
      const auto mean = [&](int x, int y, int side) {
        Vec3d sum{0, 0, 0};
        for (int j = 0; j < side; ++j)
          for (int i = 0; i < side; ++i)
            sum += to_double(picture.rgb(x * side + i, y * side + j));
        return sum / double(side * side);
      };
      for (const int level : {1, 2})
        copies.look_at(level, [&](const auto& copy) {
          CHECK(copy.width == width >> level);
          CHECK(copy.height == height >> level);
          for (const int x : {0, copy.width / 2, copy.width - 1}) {
            const Vec4f p = copy.rgba(x, copy.height - 1);
            const Vec3d expected = mean(x, copy.height - 1, 1 << level);
            CHECK(double(p.x) == doctest::Approx(expected.x).epsilon(1e-6));
            CHECK(double(p.z) == doctest::Approx(expected.z).epsilon(1e-6));
            if (channels == 3) CHECK(p.w == 1.0f);
          }
        });
    }
  }
}

TEST_CASE("smaller_copies_of_a_large_picture_take_a_third_of_it") {
  for (const int channels : {1, 2, 3, 4}) {
    const Texels picture(
        4096, 2048, channels,
        std::vector<std::uint8_t>(std::size_t(4096) * 2048 * std::size_t(channels)), true);
    // 4 bytes for each sample of 1/16 + 1/64 + ... = 1/12 of the pixels.
    CHECK(double(image::MipLevels::byte_count(picture)) ==
          doctest::Approx(double(picture.byte_count()) / 3).epsilon(1e-4));
  }
}
