// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What exposure and tone maps promise.

#include "openltc/image/file.h"
#include "openltc/image/tonemap.h"
#include "tests/image/make_picture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace openltc;
using namespace openltc::image;
using namespace openltc::image::test;

namespace {

constexpr Tonemap k_all[] = {Tonemap::neutral, Tonemap::aces, Tonemap::none};
constexpr float k_inf = std::numeric_limits<float>::infinity();
constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();

Image flat(float value, int width = 32, int height = 16) {
  Image image(width, height, 3);
  std::fill(image.data.begin(), image.data.end(), value);
  return image;
}

} // namespace

TEST_CASE("EV100 exposure halves with every stop, and saturates at 1.2 * 2^EV100 nits") {
  CHECK(exposure_from_ev100(0.0f) == doctest::Approx(1.0f / 1.2f));
  CHECK(exposure_from_ev100(15.0f) * 1.2f * 32768.0f == doctest::Approx(1.0f));
  for (float ev : {-6.0f, 0.0f, 3.5f, 15.0f}) {
    CHECK(exposure_from_ev100(ev + 1.0f) == doctest::Approx(0.5f * exposure_from_ev100(ev)));
    CHECK(ev100_from_exposure(exposure_from_ev100(ev)) == doctest::Approx(ev).epsilon(1e-5));
  }
}

TEST_CASE("PBR Neutral takes 0.04 off colours between 0.08 and 0.8 and changes nothing else") {
  // The specification's guarantee, which makes base colours of dielectrics appear unchanged.
  for (float r = 0.08f; r <= 0.8f; r += 0.08f)
    for (float g = 0.08f; g <= 0.8f; g += 0.08f)
      for (float b = 0.08f; b <= 0.8f; b += 0.08f) {
        const Vec3f out = apply_tonemap({r, g, b}, Tonemap::neutral);
        REQUIRE(out.x == doctest::Approx(r - 0.04f).epsilon(1e-5));
        REQUIRE(out.y == doctest::Approx(g - 0.04f).epsilon(1e-5));
        REQUIRE(out.z == doctest::Approx(b - 0.04f).epsilon(1e-5));
      }
}

TEST_CASE("PBR Neutral by hand: a dark grey and a highlight") {
  // x = 0.04: offset 0.04 - 0.0016 / 0.16 = 0.03.
  CHECK(pbr_neutral({0.04f, 0.04f, 0.04f}).x == doctest::Approx(0.01f));
  // (2.04, 1.04, 0.04 + 1): offset 0.04, peak 2, d = 0.24, new peak 1 - 0.0576 / 1.48 = 0.961081,
  // g = 1 / (0.15 * 1.038919 + 1) = 0.865173.
  const Vec3f out = pbr_neutral({2.04f, 1.04f, 1.04f});
  CHECK(out.x == doctest::Approx(0.961081f).epsilon(1e-5));
  CHECK(out.y == doctest::Approx(0.961081f * (0.5f * 0.865173f + 0.134827f)).epsilon(1e-5));
  CHECK(out.y == out.z);
}

TEST_CASE("PBR Neutral keeps hue: a colour stays in the plane of itself and white") {
  const Image colors = random_image(400, 1, 3, 30, 0.0f, 20.0f);
  for (int i = 0; i < 400; ++i) {
    const Vec3f in = colors.rgb(i, 0), out = pbr_neutral(in);
    const Vec3f n = cross(in, Vec3f(1.0f)); // normal of the plane
    REQUIRE(std::fabs(dot(n, out)) <= 1e-4f * length(n));
  }
}

TEST_CASE("every tone map is bounded, keeps black and increases on greys") {
  for (Tonemap tonemap : k_all) {
    CAPTURE(int(tonemap));
    CHECK(apply_tonemap(Vec3f(0.0f), tonemap).x == 0.0f);
    float before = -1.0f;
    for (float v = 1e-4f; v < 1e5f; v *= 1.05f) {
      const Vec3f out = apply_tonemap(Vec3f(v), tonemap);
      REQUIRE(out.x >= before);
      REQUIRE(out.x <= 1.0f);
      REQUIRE(out.x == out.y);
      before = out.x;
    }
    CHECK(before > 0.99f);
    for (Vec3f bad : {Vec3f(k_inf, 0, k_inf), Vec3f(k_nan, 1, -1), Vec3f(-k_inf, 3e38f, k_nan)}) {
      const Vec3f out = apply_tonemap(bad, tonemap);
      for (float v : {out.x, out.y, out.z})
        REQUIRE((v >= 0.0f && v <= 1.0f));
    }
  }
}

TEST_CASE("the ACES fit has its published value at 1 and an inverse") {
  CHECK(aces(1.0f / 0.6f) == doctest::Approx((2.51f + 0.03f) / (2.43f + 0.59f + 0.14f)));
  for (float x = 0.001f; x < 5.0f; x *= 1.3f)
    CHECK(inverse_aces(aces(x)) == doctest::Approx(x).epsilon(1e-3));
}

TEST_CASE("automatic exposure brings a flat picture to middle grey and scales inversely") {
  CHECK(auto_exposure(flat(100.0f)) == doctest::Approx(0.0018f));
  Image picture = random_image(64, 64, 3, 31, 0.01f, 5.0f);
  const float exposure = auto_exposure(picture);
  CHECK(auto_exposure(picture) == exposure);
  for (float& v : picture.data)
    v *= 1000.0f;
  CHECK(auto_exposure(picture) == doctest::Approx(exposure / 1000.0f).epsilon(1e-4));
}

TEST_CASE("automatic exposure ignores background, sparks and bad pixels") {
  const float plain = auto_exposure(flat(3.0f));
  Image picture = flat(3.0f, 100, 100);
  std::fill_n(picture.pixel(0, 0), 3 * 50, 1e6f); // half a percent
  for (int i = 0; i < 100; ++i) {                 // one percent each
    std::fill_n(picture.pixel(i, 1), 3, k_nan);
    std::fill_n(picture.pixel(i, 2), 3, k_inf);
    std::fill_n(picture.pixel(i, 3), 3, -5.0f);
  }
  CHECK(auto_exposure(picture) == doctest::Approx(plain));
  for (int y = 10; y < 90; ++y)
    for (int x = 0; x < 100; ++x)
      std::fill_n(picture.pixel(x, y), 3, y < 50 ? 0.0f : 1e-5f);
  CHECK(auto_exposure(picture) == doctest::Approx(plain));
  for (const Image& none : {flat(0.0f), flat(k_nan), flat(-1.0f), Image()})
    CHECK(auto_exposure(none) == 1.0f);
}

TEST_CASE("automatic exposure protects highlights, within limits") {
  // A room with a tenth of it in the sun: exposed for the room the sun would burn out.
  const auto room = [](float sun) {
    Image picture = flat(1.0f, 100, 100);
    std::fill_n(picture.data.begin(), 3 * 1000, sun);
    return auto_exposure(picture);
  };
  const AutoExposureOptions options;
  CHECK(room(1.0f) == doctest::Approx(options.middle_grey));
  CHECK(room(20.0f) * 20.0f == doctest::Approx(options.white));
  // A light source in view that is ten thousand times as bright does not black out the room.
  CHECK(room(1e4f) > 0.1f * options.middle_grey);
  CHECK(room(1e4f) < room(20.0f));
}

TEST_CASE("automatic exposure keeps 99 % of the pixels at most white in every channel") {
  // A pool of light on a floor, as a lamp at height h makes it, E ~ h / (h^2 + r^2)^(3/2): most of
  // the picture is dark, a thousandth of the middle at the rim.
  const auto pool = [](Vec3f color, float height) {
    Image picture(200, 100, 3);
    for (int y = 0; y < 100; ++y)
      for (int x = 0; x < 200; ++x) {
        const float r2 = float((x - 100) * (x - 100) + (y - 50) * (y - 50));
        const float e = std::pow(height * height / (height * height + r2), 1.5f);
        picture.pixel(x, y)[0] = color.x * e;
        picture.pixel(x, y)[1] = color.y * e;
        picture.pixel(x, y)[2] = color.z * e;
      }
    return picture;
  };
  const auto share_above_white = [](const Image& picture, float exposure) {
    int above = 0;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) {
        const Vec3f c = picture.rgb(x, y) * exposure;
        above += std::max({c.x, c.y, c.z}) > 1.00001f;
      }
    return double(above) / double(picture.pixel_count());
  };
  for (const Vec3f color : {Vec3f(100, 100, 100), Vec3f(100, 1, 1), Vec3f(0.3f, 0.3f, 10)})
    for (const float height : {10.0f, 20.0f, 40.0f}) {
      Image picture = pool(color, height);
      AutoExposureOptions options;
      options.light = 1000; // nothing here
      const float exposure = auto_exposure(picture, options);
      CHECK(share_above_white(picture, exposure) <= 0.01);
      // A lamp in view on a twentieth of the picture takes two stops more at most.
      std::fill_n(picture.pixel(0, 0), 3 * 1000, 1e5f);
      const float with_lamp = auto_exposure(picture, options);
      CHECK(share_above_white(picture, with_lamp) <= 0.01 + 0.05);
      CHECK(with_lamp > exposure / 6);
    }
  // A white object that fills a quarter of the picture, in a light for which 1.2 is usual.
  Image object = flat(0.07f, 100, 100);
  std::fill_n(object.data.begin(), 3 * 2500, 1.6f);
  CHECK(exposure_below_white(object, 1.2f) == doctest::Approx(1 / 1.6f));
  CHECK(share_above_white(object, exposure_below_white(object, 1.2f)) == 0);
  // Nothing bright: as usual.
  CHECK(exposure_below_white(flat(0.1f), 1.2f) == 1.2f);
  CHECK(exposure_below_white(Image(), 1.2f) == 1.2f);
}

TEST_CASE("a displayed picture is encoded, in range, and keeps alpha") {
  Image picture(2, 1, 4);
  picture.data = {0.25f, 0.5f, -1.0f, 0.5f, k_nan, k_inf, 1.0f, 7.0f};
  const Image out = to_display(picture, 2.0f, Tonemap::none);
  REQUIRE(out.channels == 4);
  CHECK(out.data[0] == doctest::Approx(srgb_from_linear(0.5f)));
  CHECK(out.data[1] == doctest::Approx(1.0f));
  CHECK(out.data[2] == 0.0f);
  CHECK(out.data[3] == 0.5f);
  CHECK(out.data[4] == 0.0f);
  CHECK(out.data[5] == doctest::Approx(1.0f));
  CHECK(out.data[7] == 1.0f);
  CHECK(to_display(Image(3, 2, 1), 1.0f, Tonemap::aces).channels == 3);
}
