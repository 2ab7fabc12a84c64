// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// FLIP agrees with its authors' own program, and has the properties that its paper promises.

#include "openltc/image/compare/flip.h"
#include "openltc/image/compare/flip_comparison.h"
#include "tests/image/flip_pairs.h"
#include "tests/image/flip_reference.h"
#include "tests/image/make_picture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace openltc;
using namespace openltc::image;
using namespace openltc::image::test;

TEST_CASE("FLIP agrees with the program of its authors") {
  for (const FlipReference& expected : k_flip_references) {
    CAPTURE(expected.name);
    const FlipPair pair = make_flip_pair(expected.name);
    REQUIRE(!pair.test.empty());
    const FlipOptions options{expected.pixels_per_degree};
    Image map;
    if (expected.hdr) {
      HdrFlip flip = flip_hdr(pair.test, pair.reference, options);
      CHECK(flip.exposure_count == expected.exposure_count);
      CHECK(double(flip.start_exposure) == doctest::Approx(expected.start_exposure).epsilon(1e-5));
      CHECK(double(flip.stop_exposure) == doctest::Approx(expected.stop_exposure).epsilon(1e-5));
      map = std::move(flip.map);
    } else {
      map = flip_ldr(pair.test, pair.reference, options);
    }
    CHECK(map.channels == 1);
    CHECK(std::fabs(mean_value(map) - expected.mean) < 1e-5);
    for (std::size_t i = 0; i < std::size(expected.pixels); ++i) {
      const int x = k_flip_pixels[i][0], y = k_flip_pixels[i][1];
      CAPTURE(x);
      CAPTURE(y);
      CHECK(std::fabs(map.pixel(x, y)[0] - expected.pixels[i]) < 5e-5f);
    }
  }
}

TEST_CASE("FLIP is zero for equal pictures, symmetric, and within [0, 1]") {
  const Image a = random_image(40, 31, 3, 20), b = random_image(40, 31, 3, 21);
  for (float v : flip_ldr(a, a).data)
    REQUIRE(v == 0.0f);
  for (float v : flip_hdr(a, a).map.data)
    REQUIRE(v == 0.0f);
  const Image ab = flip_ldr(a, b), ba = flip_ldr(b, a);
  CHECK(ab.data == ba.data);
  for (float v : ab.data) {
    REQUIRE(v > 0.0f);
    REQUIRE(v <= 1.0f);
  }
}

TEST_CASE("FLIP grows with the difference and shrinks with the distance") {
  Image grey(48, 48, 3);
  std::fill(grey.data.begin(), grey.data.end(), 0.5f);
  const Image noise = random_image(48, 48, 3, 22, -1.0f, 1.0f);
  double before = 0.0;
  for (float amount : {0.02f, 0.05f, 0.1f, 0.2f, 0.4f}) {
    Image noisy = grey;
    for (std::size_t i = 0; i < noisy.data.size(); ++i)
      noisy.data[i] += amount * noise.data[i];
    const double near = mean_value(flip_ldr(noisy, grey, {30.0f}));
    const double far = mean_value(flip_ldr(noisy, grey, {120.0f}));
    CHECK(near > before);
    CHECK(far < near);
    before = near;
  }
}

TEST_CASE("HDR-FLIP does not depend on the unit of radiance") {
  const FlipPair pair = make_flip_pair("hdr noise");
  FlipPair scaled = pair;
  for (Image* image : {&scaled.test, &scaled.reference})
    for (float& v : image->data)
      v *= 1024.0f;
  const HdrFlip a = flip_hdr(pair.test, pair.reference);
  const HdrFlip b = flip_hdr(scaled.test, scaled.reference);
  CHECK(b.start_exposure == doctest::Approx(a.start_exposure - 10.0f));
  CHECK(mean_value(b.map) == doctest::Approx(mean_value(a.map)).epsilon(1e-4));
}

TEST_CASE("FLIP survives black, NaN, infinite, negative and one-pixel pictures") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const Image black(20, 10, 3), noise = random_image(20, 10, 3, 23);
  const HdrFlip on_black = flip_hdr(noise, black);
  CHECK(mean_value(on_black.map) > 0.5);
  CHECK(on_black.exposure_count >= 2);
  CHECK(mean_value(flip_hdr(black, black).map) == 0.0);

  Image bad = noise;
  bad.data[3] = nan;
  bad.data[100] = inf;
  bad.data[200] = -inf;
  CHECK(mean_value(flip_ldr(bad, bad)) == 0.0);
  // A pixel that is no number in one of them counts as equal.
  CHECK(mean_value(flip_ldr(bad, noise)) == 0.0);
  CHECK(mean_value(flip_hdr(bad, noise).map) == 0.0);
  Image negative = black;
  std::fill(negative.data.begin(), negative.data.end(), -3.0f);
  CHECK(mean_value(flip_hdr(negative, black).map) == 0.0);

  Image white(1, 1, 3);
  white.data = {1, 1, 1};
  CHECK(flip_ldr(white, Image(1, 1, 3)).data[0] == doctest::Approx(0.967392f).epsilon(1e-5));
}

TEST_CASE("a comparison by FLIP leaves out what is masked or no number, and says how it was made") {
  Image dark(8, 4, 3), light(8, 4, 3);
  std::fill(light.data.begin(), light.data.end(), 1.0f);
  Image half = dark; // the right half differs
  for (int y = 0; y < 4; ++y)
    for (int x = 4; x < 8; ++x)
      std::fill_n(half.pixel(x, y), 3, 1.0f);
  FlipComparisonOptions options;
  const FlipComparison all = compare_flip(half, dark, options);
  CHECK_FALSE(all.is_hdr);
  CHECK_FALSE(all.ev100);
  CHECK(all.mean == doctest::Approx(mean_value(all.map)));
  CHECK(all.max_at.x >= 4);

  const std::vector<std::uint8_t> mask = mask_of(half);
  options.mask = mask;
  const FlipComparison right = compare_flip(half, dark, options);
  CHECK(right.mean > all.mean);
  CHECK(right.map.data == all.map.data);

  half.pixel(7, 3)[1] = std::numeric_limits<float>::infinity();
  const FlipComparison broken = compare_flip(half, dark, options);
  CHECK(std::isnan(broken.map.data.back()));
  CHECK(std::isfinite(broken.mean));

  options = {};
  options.scene_linear = true;
  CHECK(compare_flip(light, dark, options).is_hdr);
  options.ev100 = 3.0f;
  const FlipComparison exposed = compare_flip(light, dark, options);
  CHECK_FALSE(exposed.is_hdr);
  REQUIRE(exposed.ev100);
  CHECK(double(*exposed.ev100) == doctest::Approx(3.0));
}
