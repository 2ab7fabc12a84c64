// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Promises of the renderer that are not about light: same bytes, kernels agree, alpha, errors.

#include "openltc/render/renderer.h"
#include "openltc/render/view/studio_choice.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <utility>

using namespace openltc;

namespace {

const scene::Camera k_camera = test::look_at({0, 2.5f, 5}, {0, 0.7f, 0}, 0.7f);

scene::Scene busy_scene() {
  scene::Scene scene;
  test::add_floor(scene, 20, 0, test::glossy_material({0.4f, 0.4f, 0.4f}, 0.5f, false));
  test::add_sphere(scene, {-0.8f, 0.7f, 0}, 0.7f,
                   test::glossy_material({0.8f, 0.3f, 0.2f}, 0.05f, false));
  test::add_sphere(scene, {0.8f, 0.7f, 0}, 0.7f,
                   test::glossy_material({0.9f, 0.8f, 0.5f}, 0.0f, true));
  scene.lights.polygons.push_back(test::ceiling_rectangle(-1, -1, 1, 1, 4, 50));
  light::PunctualLight point;
  point.position = {2, 3, 2};
  point.intensity = Vec3f(20);
  scene.lights.punctual.push_back(point);
  return scene;
}

render::RenderOptions small_options() {
  render::RenderOptions options;
  options.width = 83; // not a multiple of a tile
  options.height = 45;
  options.samples = 3;
  options.shadow_samples = 4;
  return options;
}

} // namespace

TEST_CASE("the same bytes for any number of threads") {
  const scene::Scene scene = busy_scene();
  for (const auto integrator : {render::Integrator::ltc, render::Integrator::reference}) {
    render::RenderOptions options = small_options();
    options.integrator = integrator;
    options.threads = 1;
    auto one = render::render(scene, k_camera, table::builtin_ggx_table(), options);
    REQUIRE(one.ok());
    for (const int threads : {2, 5}) {
      options.threads = threads;
      auto many = render::render(scene, k_camera, table::builtin_ggx_table(), options);
      REQUIRE(many.ok());
      CHECK(one->radiance.data == many->radiance.data);
      CHECK(one->standard_error.data == many->standard_error.data);
    }
  }
}

TEST_CASE("every kernel of this machine paints the same picture to rounding") {
  const scene::Scene scene = busy_scene();
  render::RenderOptions options = small_options();
  options.shadow_samples = 0; // a shadow ray that grazes an edge may fall on either side
  options.kernel = "scalar";
  auto scalar = render::render(scene, k_camera, table::builtin_ggx_table(), options);
  REQUIRE(scalar.ok());
  int kernels = 0;
  for (const char* name : {"sse4", "avx2", "avx512", "neon"}) {
    if (!render::kernel_by_name(name).shade) continue;
    ++kernels;
    options.kernel = name;
    auto lanes = render::render(scene, k_camera, table::builtin_ggx_table(), options);
    REQUIRE(lanes.ok());
    CHECK(lanes->kernel == name);
    double worst = 0;
    for (std::size_t i = 0; i < scalar->radiance.data.size(); ++i) {
      const double a = double(scalar->radiance.data[i]), b = double(lanes->radiance.data[i]);
      worst = std::max(worst, std::abs(a - b) / (std::abs(a) + 0.05));
    }
    MESSAGE(name << ": largest relative difference from scalar " << worst);
    CHECK(worst < 2e-3);
  }
  CHECK(kernels > 0);
}

TEST_CASE("nothing but finite, non-negative radiance, even of a mirror and at grazing angles") {
  scene::Scene scene = busy_scene();
  // A light that touches the floor and one below it.
  light::PolygonLight wall;
  wall.vertices = {{-2, 0, -1}, {2, 0, -1}, {2, 1, -1}, {-2, 1, -1}};
  wall.ring_end = {4};
  wall.normal = {0, 0, 1};
  wall.radiance = Vec3f(1e6f);
  scene.lights.polygons.push_back(wall);
  scene.lights.polygons.push_back(test::ceiling_rectangle(-1, -1, 1, 1, -2, 1e6f));
  const scene::Camera grazing = test::look_at({0, 0.02f, 6}, {0, 0.021f, 0}, 0.7f);
  for (const auto integrator : {render::Integrator::ltc, render::Integrator::reference}) {
    render::RenderOptions options = small_options();
    options.integrator = integrator;
    auto picture = render::render(scene, grazing, table::builtin_ggx_table(), options);
    REQUIRE(picture.ok());
    for (const float v : picture->radiance.data) {
      REQUIRE(std::isfinite(v));
      REQUIRE(v >= 0);
    }
  }
}

TEST_CASE("alpha: masked surfaces let light through, blended ones a part of it") {
  const auto floor_radiance = [](scene::AlphaMode mode, float alpha) {
    scene::Scene scene;
    test::add_floor(scene, 10, 0, test::diffuse_material({0.5f, 0.5f, 0.5f}));
    scene::Material pane = test::diffuse_material({0, 0, 0});
    pane.alpha_mode = mode;
    pane.base_color.w = alpha;
    test::add_floor(scene, 1, 1, pane);
    scene.lights.polygons.push_back(test::ceiling_rectangle(-0.1f, -0.1f, 0.1f, 0.1f, 3, 1000));
    render::RenderOptions options;
    options.width = options.height = 8;
    options.samples = 1;
    // Looks below the pane, at the floor in its shadow.
    auto picture = render::render(scene, test::look_at({0.1f, 0.5f, 4.3f}, {0.1f, 0, 0.3f}, 0.02f),
                                  table::builtin_ggx_table(), options);
    REQUIRE(picture.ok());
    return double(picture->radiance.pixel(4, 4)[0]);
  };
  const double open = floor_radiance(scene::AlphaMode::mask, 0.2f);
  CHECK(open > 0.1);
  CHECK(floor_radiance(scene::AlphaMode::mask, 0.8f) == 0);
  CHECK(floor_radiance(scene::AlphaMode::opaque, 0.2f) == 0);
  CHECK(floor_radiance(scene::AlphaMode::blend, 0.0f) == doctest::Approx(open));
  CHECK(floor_radiance(scene::AlphaMode::blend, 0.25f) ==
        doctest::Approx(0.75 * open).epsilon(1e-4));
  CHECK(floor_radiance(scene::AlphaMode::blend, 1.0f) == 0);
}

TEST_CASE("alpha: the camera sees through blended surfaces") {
  scene::Scene scene;
  scene::Material glow = test::diffuse_material({0, 0, 0});
  glow.emission = Vec3f(10);
  test::add_floor(scene, 10, 0, glow);
  scene::Material pane = test::diffuse_material({0, 0, 0});
  pane.alpha_mode = scene::AlphaMode::blend;
  pane.base_color.w = 0.3f;
  test::add_floor(scene, 10, 1, pane);
  test::add_floor(scene, 10, 2, pane);
  render::RenderOptions options;
  options.width = options.height = 4;
  options.samples = 2;
  options.background = Vec3f(5);
  auto picture = render::render(scene, test::look_at({0, 4, 0.1f}, {0, 0, 0}, 0.1f),
                                table::builtin_ggx_table(), options);
  REQUIRE(picture.ok());
  CHECK(double(picture->radiance.pixel(2, 2)[1]) == doctest::Approx(10 * 0.7 * 0.7));
  auto away = render::render(scene, test::look_at({0, 4, 0.1f}, {0, 8, 0}, 0.1f),
                             table::builtin_ggx_table(), options);
  REQUIRE(away.ok());
  CHECK(double(away->radiance.pixel(2, 2)[1]) == doctest::Approx(5));
}

TEST_CASE("a picture can be stopped at any tile, and its progress rises to one") {
  const scene::Scene scene = busy_scene();
  render::RenderOptions options = small_options();
  double last = 0;
  int calls = 0;
  bool rising = true;
  options.progress = [&](double share) {
    rising = rising && share > last;
    last = share;
    return ++calls > 0;
  };
  REQUIRE(render::render(scene, k_camera, table::builtin_ggx_table(), options).ok());
  CHECK(rising);
  CHECK(last == 1.0);
  for (const int stop : {1, 2, calls}) {
    int count = 0;
    options.progress = [&](double) { return ++count < stop; };
    const auto stopped = render::render(scene, k_camera, table::builtin_ggx_table(), options);
    REQUIRE_FALSE(stopped.ok());
    CHECK(stopped.error().message == "cancelled");
    CHECK(count == stop);
  }
}

TEST_CASE("a studio rig is lit where the scene says nothing to see by, and only there") {
  const auto chosen = [](scene::Scene scene, render::LightsFrom from) {
    const auto result = render::choose_lights(scene, from, k_camera);
    REQUIRE(result.ok());
    return std::pair(*result, scene.lights.area_light_count() + scene.lights.punctual.size());
  };
  const scene::Scene lit = busy_scene();
  const std::size_t own = lit.lights.area_light_count() + lit.lights.punctual.size();
  scene::Scene dark = lit;
  dark.lights = {};
  scene::Scene broken = dark; // the file describes lights, none of them usable
  broken.describes_lights = true;
  scene::Scene dim = dark;
  dim.lights.polygons = {test::ceiling_rectangle(-1, -1, 1, 1, 2, 0.5f)};
  using render::LightsFrom;
  using render::LightsReason;
  CHECK(chosen(lit, LightsFrom::automatic).second == own);
  CHECK(chosen(lit, LightsFrom::both).second > own);
  CHECK_FALSE(chosen(lit, LightsFrom::both).first.usual_exposure);
  CHECK(chosen(dark, LightsFrom::automatic).first.reason == LightsReason::no_lights);
  CHECK(chosen(dark, LightsFrom::automatic).second > 0);
  CHECK(chosen(dark, LightsFrom::automatic).first.usual_exposure);
  CHECK(chosen(dark, LightsFrom::scene).second == 0);
  CHECK(chosen(broken, LightsFrom::automatic).first.reason == LightsReason::unusable_lights);
  CHECK(chosen(broken, LightsFrom::automatic).second == 0);
  CHECK(chosen(dim, LightsFrom::automatic).first.reason == LightsReason::dim_lights);
  CHECK(chosen(dim, LightsFrom::automatic).second > 1);
}

TEST_CASE("options out of range are refused with one line") {
  const scene::Scene scene = busy_scene();
  const auto message = [&](auto change) {
    render::RenderOptions options = small_options();
    change(options);
    auto picture = render::render(scene, k_camera, table::builtin_ggx_table(), options);
    return picture.ok() ? std::string() : picture.error().message;
  };
  CHECK(message([](auto& o) { o.width = 0; }).find("size") != std::string::npos);
  CHECK(message([](auto& o) { o.height = 1 << 30; }).find("size") != std::string::npos);
  CHECK(message([](auto& o) { o.samples = 0; }).find("samples") != std::string::npos);
  CHECK(message([](auto& o) { o.shadow_samples = -1; }).find("shadow") != std::string::npos);
  CHECK(message([](auto& o) { o.kernel = "abacus"; }).find("abacus") != std::string::npos);
  CHECK(message([](auto&) {}).empty());
}

TEST_CASE("an empty scene is background") {
  scene::Scene scene;
  scene.materials.emplace_back();
  render::RenderOptions options = small_options();
  options.background = {1, 2, 3};
  auto picture = render::render(scene, k_camera, table::builtin_ggx_table(), options);
  REQUIRE(picture.ok());
  CHECK(picture->radiance.pixel(10, 10)[2] == 3);
}
