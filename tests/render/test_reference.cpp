// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The reference integrator, against what is known without it; and the LTC integrator against it.

#include "openltc/image/compare/metrics.h"
#include "openltc/render/renderer.h"
#include "openltc/scene/gltf.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace openltc;

namespace {

render::Picture rendered(const scene::Scene& scene, render::Integrator integrator, int samples,
                         int shadow_samples,
                         render::PunctualForm form = render::PunctualForm::exact) {
  render::RenderOptions options;
  options.width = 64;
  options.height = 48;
  options.integrator = integrator;
  options.samples = samples;
  options.shadow_samples = shadow_samples;
  options.punctual_form = form;
  auto picture = render::render(scene, test::look_at({0, 2.5f, 5}, {0, 0.7f, 0}, 0.7f),
                                table::builtin_ggx_table(), options);
  REQUIRE(picture.ok());
  return std::move(*picture);
}

double mean(const image::Image& image) {
  double sum = 0;
  for (const float v : image.data)
    sum += double(v);
  return sum / double(image.data.size());
}

double mean_absolute_difference(const image::Image& a, const image::Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i)
    sum += std::abs(double(a.data[i]) - double(b.data[i]));
  return sum / double(a.data.size());
}

scene::Scene spheres(bool with_metal) {
  scene::Scene scene;
  test::add_floor(scene, 20, 0, test::glossy_material({0.4f, 0.4f, 0.4f}, 0.5f, false));
  test::add_sphere(scene, {-1.2f, 0.7f, 0}, 0.7f,
                   test::glossy_material({0.8f, 0.3f, 0.2f}, 0.2f, false));
  test::add_sphere(scene, {1.2f, 0.7f, 0}, 0.7f,
                   test::glossy_material({0.9f, 0.8f, 0.5f}, 0.35f, with_metal));
  scene.lights.polygons.push_back(test::ceiling_rectangle(-1, -1, 1, 1, 4, 50));
  scene.lights.polygons.push_back(
      test::ceiling_light({{{-4, -2}, {-2, -2}, {-2, 0}, {-3, 0}, {-3, 1}, {-4, 1}}}, 3, 20));
  return scene;
}

} // namespace

TEST_CASE("reference equals the closed form on a Lambertian scene") {
  scene::Scene scene;
  test::add_floor(scene, 20, 0, test::diffuse_material({0.5f, 0.5f, 0.5f}));
  test::add_sphere(scene, {0, 0.8f, 0}, 0.8f, test::diffuse_material({0.7f, 0.4f, 0.3f}));
  scene.lights.polygons.push_back(test::ceiling_rectangle(-2, -1, 1, 2, 3, 10));
  const render::Picture ltc = rendered(scene, render::Integrator::ltc, 64, 0);
  const render::Picture reference = rendered(scene, render::Integrator::reference, 1024, 0);
  CHECK(mean(ltc.radiance) == doctest::Approx(mean(reference.radiance)).epsilon(0.002));
  CHECK(mean_absolute_difference(ltc.radiance, reference.radiance) <
        0.01 * mean(reference.radiance));
}

TEST_CASE("a reference that draws lights equals the closed form of all of them") {
  // Lambertian and without shadows, where the closed form is exact. From 128 lights on some are
  // drawn.
  scene::Scene scene;
  test::add_floor(scene, 20, 0, test::diffuse_material({0.5f, 0.5f, 0.5f}));
  test::add_sphere(scene, {0, 0.8f, 0}, 0.8f, test::diffuse_material({0.7f, 0.4f, 0.3f}));
  for (int i = 0; i < 200; ++i) {
    const float x = float(i % 20) * 0.5f - 5, z = float(i / 20) * 0.7f - 4;
    scene.lights.polygons.push_back(test::ceiling_rectangle(
        x, z, x + 0.2f, z + 0.3f, 2.5f + 0.1f * float(i % 7), 10 + 40.0f * float(i % 5)));
  }
  const render::Picture ltc = rendered(scene, render::Integrator::ltc, 16, 0);
  const render::Picture reference = rendered(scene, render::Integrator::reference, 64, 0);
  // Camera samples differ; what the means of pictures are apart by is their noise at the sphere's
  // rim.
  CHECK(mean(ltc.radiance) == doctest::Approx(mean(reference.radiance)).epsilon(0.002));
  CHECK(mean_absolute_difference(ltc.radiance, reference.radiance) <
        0.02 * mean(reference.radiance));
}

TEST_CASE("the standard error of the reference covers its true error") {
  const scene::Scene scene = spheres(true);
  const render::Picture rough = rendered(scene, render::Integrator::reference, 32, 1);
  const render::Picture truth = rendered(scene, render::Integrator::reference, 2048, 1);
  // The estimate is an upper one: stratified samples do better than independent ones. 99.7 % of
  // normal errors lie within three standard errors; a little is left for the truth's own noise.
  std::size_t within = 0, counted = 0;
  double ratio = 0;
  for (std::size_t i = 0; i < rough.radiance.data.size(); ++i) {
    const double error = std::abs(double(rough.radiance.data[i]) - double(truth.radiance.data[i]));
    const double estimate = double(rough.standard_error.data[i]);
    if (estimate <= 0) continue;
    ++counted;
    within += error < 3 * estimate;
    ratio += error / estimate;
  }
  REQUIRE(counted > rough.radiance.data.size() / 2);
  CHECK(double(within) / double(counted) > 0.97);
  // And it is no idle bound: the mean of |error| / sigma of a normal error is 0.8.
  CHECK(ratio / double(counted) > 0.1);
  CHECK(ratio / double(counted) < 1.0);
}

TEST_CASE("two seeds of the reference agree") {
  // Different seeds are different estimates of the same picture.
  const scene::Scene scene = spheres(true);
  const render::Picture a = rendered(scene, render::Integrator::reference, 1024, 1);
  scene::Scene same = spheres(true);
  render::RenderOptions options;
  options.width = 64;
  options.height = 48;
  options.integrator = render::Integrator::reference;
  options.samples = 1024;
  options.seed = 7;
  auto b = render::render(same, test::look_at({0, 2.5f, 5}, {0, 0.7f, 0}, 0.7f),
                          table::builtin_ggx_table(), options);
  REQUIRE(b.ok());
  CHECK(mean(a.radiance) == doctest::Approx(mean(b->radiance)).epsilon(0.002));
  CHECK(mean_absolute_difference(a.radiance, b->radiance) < 0.02 * mean(a.radiance));
}

TEST_CASE("LTC is close to the reference on glossy spheres, unshadowed") {
  const scene::Scene scene = spheres(true);
  const render::Picture ltc = rendered(scene, render::Integrator::ltc, 64, 0);
  const render::Picture reference = rendered(scene, render::Integrator::reference, 1024, 0);
  const double error =
      mean_absolute_difference(ltc.radiance, reference.radiance) / mean(reference.radiance);
  MESSAGE("mean absolute error over mean radiance: " << error);
  CHECK(error < 0.03);
}

TEST_CASE("LTC with its shadow ratio is close to the shadowed reference") {
  const scene::Scene scene = spheres(false);
  const render::Picture ltc = rendered(scene, render::Integrator::ltc, 32, 32);
  const render::Picture reference = rendered(scene, render::Integrator::reference, 1024, 1);
  const render::Picture unshadowed = rendered(scene, render::Integrator::ltc, 32, 0);
  CHECK(mean(ltc.radiance) == doctest::Approx(mean(reference.radiance)).epsilon(0.01));
  const double error =
      mean_absolute_difference(ltc.radiance, reference.radiance) / mean(reference.radiance);
  MESSAGE("mean absolute error over mean radiance: " << error);
  CHECK(error < 0.03);
  // The shadows are there at all.
  CHECK(mean(unshadowed.radiance) > 1.02 * mean(reference.radiance));
}

TEST_CASE("the demo scene, unshadowed: mean relative error of at most 3 %") {
  auto scene = scene::load_gltf(std::string(OPENLTC_SOURCE_DIR) + "/scenes/demo.glb");
  REQUIRE(scene.ok());
  render::RenderOptions options;
  options.width = 128;
  options.height = 72;
  options.filter = render::PixelFilter::none;
  options.shadow_samples = 0;
  options.samples = 1;
  auto ltc = render::render(*scene, scene->cameras.at(0), table::builtin_ggx_table(), options);
  options.integrator = render::Integrator::reference;
  options.samples = 1024;
  auto reference =
      render::render(*scene, scene->cameras.at(0), table::builtin_ggx_table(), options);
  REQUIRE(ltc.ok());
  REQUIRE(reference.ok());
  const double error = image::compare(ltc->radiance, reference->radiance).mean_relative;
  MESSAGE("mean relative error: " << error);
  CHECK(error < 0.03);
}

TEST_CASE("point, spot and directional lights: illuminance on a floor") {
  constexpr float pi = std::numbers::pi_v<float>;
  struct Case {
    light::PunctualLight light;
    float illuminance; // lux at the origin, the light being straight above
  };
  light::PunctualLight point;
  point.position = {0, 2, 0};
  point.intensity = Vec3f(100);
  light::PunctualLight spot = point;
  spot.type = light::PunctualType::spot;
  spot.direction = {0, -1, 0};
  spot.cos_inner = 0.9f;
  spot.cos_outer = 0.8f;
  light::PunctualLight away = spot;
  away.direction = {0, 1, 0};
  light::PunctualLight sun;
  sun.type = light::PunctualType::directional;
  sun.direction = {0, -1, 0};
  sun.intensity = Vec3f(30);
  light::PunctualLight near = point;
  near.range = 1.9f;
  for (const Case& c :
       {Case{point, 25}, Case{spot, 25}, Case{away, 0}, Case{sun, 30}, Case{near, 0}}) {
    scene::Scene scene;
    test::add_floor(scene, 5, 0, test::diffuse_material({0.5f, 0.5f, 0.5f}));
    scene.lights.punctual.push_back(c.light);
    render::RenderOptions options;
    options.width = options.height = 9;
    options.samples = 1;
    auto picture = render::render(scene, test::look_at({0.5f, 3, 0.5f}, {0, 0, 0}, 0.01f),
                                  table::builtin_ggx_table(), options);
    REQUIRE(picture.ok());
    CHECK(double(picture->radiance.pixel(4, 4)[0]) ==
          doctest::Approx(double(0.5f * c.illuminance / pi)).epsilon(0.001));
  }
}

TEST_CASE("a point light by its LTC density is close to the exact BRDF, not equal") {
  scene::Scene scene;
  test::add_floor(scene, 20, 0, test::glossy_material({0.4f, 0.4f, 0.4f}, 0.5f, false));
  light::PunctualLight point;
  point.position = {0, 2, -1};
  point.intensity = Vec3f(100);
  scene.lights.punctual.push_back(point);
  const render::Picture exact = rendered(scene, render::Integrator::ltc, 4, 0);
  const render::Picture ltc =
      rendered(scene, render::Integrator::ltc, 4, 0, render::PunctualForm::ltc);
  const double error =
      mean_absolute_difference(ltc.radiance, exact.radiance) / mean(exact.radiance);
  MESSAGE("mean absolute difference over mean radiance: " << error);
  CHECK(error > 1e-5);
  CHECK(error < 0.05);
}

TEST_CASE("a small polygon light is a point light of intensity L A") {
  const float side = 0.02f, nits = 1000, height = 2;
  scene::Scene area, point;
  for (scene::Scene* s : {&area, &point})
    test::add_floor(*s, 20, 0, test::glossy_material({0.4f, 0.4f, 0.4f}, 0.6f, false));
  area.lights.polygons.push_back(
      test::ceiling_rectangle(-side / 2, -side / 2, side / 2, side / 2, height, nits));
  // Lambertian: intensity falls with the cosine at the light, which a spot of wide cone lacks; so
  // compare below the light only.
  light::PunctualLight p;
  p.position = {0, height, 0};
  p.intensity = Vec3f(nits * side * side);
  point.lights.punctual.push_back(p);
  render::RenderOptions options;
  options.width = options.height = 9;
  options.samples = 1;
  options.shadow_samples = 0;
  options.punctual_form = render::PunctualForm::ltc;
  const scene::Camera camera = test::look_at({0.3f, 3, 0.3f}, {0, 0, 0}, 0.01f);
  auto a = render::render(area, camera, table::builtin_ggx_table(), options);
  auto b = render::render(point, camera, table::builtin_ggx_table(), options);
  REQUIRE(a.ok());
  REQUIRE(b.ok());
  CHECK(double(a->radiance.pixel(4, 4)[0]) ==
        doctest::Approx(double(b->radiance.pixel(4, 4)[0])).epsilon(0.002));
}
