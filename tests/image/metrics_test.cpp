// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The metrics against values worked out by hand, and their promises.

#include "openltc/image/compare/metrics.h"
#include "tests/image/make_picture.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace openltc;
using namespace openltc::image;
using namespace openltc::image::test;

namespace {

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
constexpr float k_inf = std::numeric_limits<float>::infinity();

} // namespace

TEST_CASE("metrics of two pixels by hand") {
  Image a(2, 1, 3), b(2, 1, 3);
  a.data = {1.0f, 2.0f, 3.0f, 4.0f, 4.0f, 0.0f};
  b.data = {1.0f, 1.0f, 1.0f, 4.0f, 8.0f, 0.0f};
  // differences 0 1 2, 0 -4 0; mean of |b| 15 / 6 = 2.5, so eps 0.025
  const Metrics m = compare(a, b);
  CHECK(m.pixel_count == 2);
  CHECK(m.non_finite_count == 0);
  CHECK(m.eps == doctest::Approx(0.025));
  CHECK(m.mean_a == doctest::Approx(14.0 / 6));
  CHECK(m.mean_b == doctest::Approx(2.5));
  CHECK(m.bias == doctest::Approx(-1.0 / 6));
  CHECK(m.mae == doctest::Approx(7.0 / 6));
  CHECK(m.mse == doctest::Approx(21.0 / 6));
  CHECK(m.rmse == doctest::Approx(std::sqrt(3.5)));
  CHECK(m.mean_relative == doctest::Approx((1 / 1.025 + 2 / 1.025 + 4 / 8.025) / 6));
  CHECK(m.relative_mse == doctest::Approx((1 / 1.000625 + 4 / 1.000625 + 16 / 64.000625) / 6));
  CHECK(m.psnr_peak == 8.0);
  CHECK(m.psnr == doctest::Approx(10 * std::log10(64 / 3.5)));
  CHECK(m.max_abs == 4.0);
  CHECK(m.max_abs_at.x == 1);
  CHECK(m.max_relative == doctest::Approx(2 / 1.025));
  CHECK(m.max_relative_at.x == 0);
  CHECK(m.max_relative_at.y == 0);
}

TEST_CASE("equal pictures have no error and an infinite PSNR") {
  const Image a = random_image(17, 9, 4, 40, -1.0f, 9.0f);
  const Metrics m = compare(a, a);
  CHECK(m.pixel_count == 17 * 9);
  for (double v : {m.bias, m.mae, m.rmse, m.relative_mse, m.mean_relative, m.max_abs})
    CHECK(v == 0.0);
  CHECK(std::isinf(m.psnr));
}

TEST_CASE("relative metrics and PSNR do not depend on the unit") {
  Image a = random_image(30, 20, 3, 41), b = random_image(30, 20, 3, 42);
  const Metrics m = compare(a, b);
  for (Image* image : {&a, &b})
    for (float& v : image->data)
      v *= 4096.0f;
  const Metrics scaled = compare(a, b);
  CHECK(scaled.relative_mse == doctest::Approx(m.relative_mse).epsilon(1e-12));
  CHECK(scaled.mean_relative == doctest::Approx(m.mean_relative).epsilon(1e-12));
  CHECK(scaled.psnr == doctest::Approx(m.psnr).epsilon(1e-12));
  CHECK(scaled.rmse == doctest::Approx(4096 * m.rmse).epsilon(1e-12));
}

TEST_CASE("a difference of 10 percent everywhere is a relative error near 10 percent") {
  const Image b = random_image(50, 50, 3, 43, 1.0f, 2.0f);
  Image a = b;
  for (float& v : a.data)
    v *= 1.1f;
  const Metrics m = compare(a, b);
  // eps is 0.015 beside values of 1 to 2
  CHECK(m.mean_relative < 0.1);
  CHECK(m.mean_relative > 0.098);
  CHECK(m.relative_mse == doctest::Approx(0.01).epsilon(1e-3));
}

TEST_CASE("pixels that are not finite are counted and left out") {
  const Image b = random_image(10, 10, 3, 44);
  Image a = random_image(10, 10, 3, 45);
  a.pixel(3, 3)[1] = k_nan;
  a.pixel(4, 3)[2] = -k_inf;
  Image bad_b = b;
  bad_b.pixel(3, 3)[0] = k_inf;
  bad_b.pixel(9, 9)[0] = k_nan;
  const Metrics m = compare(a, bad_b);
  CHECK(m.non_finite_count == 3);
  CHECK(m.non_finite_a == 2);
  CHECK(m.non_finite_b == 2);
  CHECK(m.pixel_count == 97);
  CHECK(std::isfinite(m.rmse));

  // The same as masking these pixels.
  std::vector<std::uint8_t> mask(100, 1);
  mask[33] = mask[34] = mask[99] = 0;
  const Metrics masked = compare(a, b, {.mask = mask});
  CHECK(masked.masked_count == 3);
  CHECK(masked.pixel_count == 97);
  CHECK(masked.rmse == m.rmse);
  CHECK(masked.mean_relative == m.mean_relative);
}

TEST_CASE("alpha does not count, grey counts as RGB, and nothing left is no error") {
  Image a = random_image(8, 8, 4, 46);
  Image b = a;
  for (std::size_t i = 3; i < b.data.size(); i += 4)
    b.data[i] += 1.0f;
  CHECK(compare(a, b).max_abs == 0.0);

  const Image grey = random_image(8, 8, 1, 47);
  Image rgb(8, 8, 3);
  for (std::size_t i = 0; i < rgb.data.size(); ++i)
    rgb.data[i] = grey.data[i / 3];
  CHECK(compare(grey, rgb).max_abs == 0.0);

  const std::vector<std::uint8_t> none(64, 0);
  const Metrics m = compare(a, b, {.mask = none});
  CHECK(m.pixel_count == 0);
  CHECK(m.rmse == 0.0);
  CHECK(m.max_abs_at.x == -1);

  // A black reference does not divide by zero.
  CHECK(std::isfinite(compare(rgb, Image(8, 8, 3)).relative_mse));
}
