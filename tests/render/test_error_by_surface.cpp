// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The error of a picture, sorted by what its pixels show.

#include "openltc/render/error_by_surface.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace openltc;

TEST_CASE("error by surface: kinds, pixels, shares and places") {
  scene::Scene scene;
  test::add_floor(scene, 100, 0, test::glossy_material({0.5f, 0.5f, 0.5f}, 0.5f, false));
  test::add_sphere(scene, {0, 1, 0}, 1, test::glossy_material({0.9f, 0.9f, 0.9f}, 0.3f, true));
  scene::Material glow = test::diffuse_material({0, 0, 0});
  glow.emission = Vec3f(10);
  test::add_sphere(scene, {2.5f, 1, 0}, 0.5f, glow);
  const scene::Camera camera = test::look_at({0, 2, 8}, {0, 1, 0}, 0.8f);

  image::Image truth(61, 40, 3), picture(61, 40, 3);
  std::fill(truth.data.begin(), truth.data.end(), 2.0f);
  picture.data = truth.data;
  const auto equal = render::error_by_surface(scene, camera, picture, truth, 0.5);
  REQUIRE(equal.ok());
  int pixels = 0;
  for (const render::SurfaceError& e : *equal) {
    CHECK(e.mean_relative == 0);
    CHECK(e.share == 0);
    pixels += e.pixels;
  }
  CHECK(pixels == 61 * 40);

  // An error of 1 in the middle, where the metal is; nowhere else.
  for (int c = 0; c < 3; ++c)
    picture.pixel(30, 20)[c] = 3.0f;
  const auto errors = render::error_by_surface(scene, camera, picture, truth, 0.5);
  REQUIRE(errors.ok());
  const render::SurfaceError& worst = (*errors)[0];
  CHECK(worst.surface == "metal, roughness 0.2-0.4, front");
  CHECK(worst.share == doctest::Approx(1));
  CHECK(worst.max_relative == doctest::Approx(1 / 2.5));
  CHECK(worst.mean_relative == doctest::Approx(1 / 2.5 / worst.pixels));
  CHECK(worst.max_x == 30);
  CHECK(worst.max_y == 20);
  const auto has = [&](const std::string& surface) {
    return std::any_of(errors->begin(), errors->end(),
                       [&](const render::SurfaceError& e) { return e.surface == surface; });
  };
  CHECK(has("emitter"));
  CHECK(has("background"));
  CHECK(has("dielectric, roughness 0.4-0.6, front"));
  CHECK(has("dielectric, roughness 0.4-0.6, grazing"));
}
