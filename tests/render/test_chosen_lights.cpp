// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Pictures of many lights, of which some are chosen: none errs more than the error it was allowed.

#include "openltc/light/shapes.h"
#include "openltc/table/lobe_table.h"
#include "test_scenes.h"
#include "tests/render/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace openltc;
using test::max_difference;
using test::Random;
using test::rendered;

namespace {

scene::Scene room_of_lamps(int count) {
  scene::Scene scene;
  test::add_floor(scene, 30, 0, test::glossy_material({0.5f, 0.4f, 0.3f}, 0.2f, false));
  for (int i = 0; i < 6; ++i)
    test::add_sphere(scene, {4.0f * float(i) - 10, 1, -4 + 2 * float(i % 3)}, 1,
                     test::glossy_material({0.8f, 0.7f, 0.6f}, 0.15f * float(i) + 0.05f, i % 2));
  Random random(3);
  for (int i = 0; i < count; ++i) {
    const Vec3f at(random(-28, 28), random(3, 6), random(-28, 28));
    const Vec3f n = i % 4 ? Vec3f(0, -1, 0) : normalize(random.direction() + Vec3f(0, -0.5f, 0));
    const Vec3f t = normalize(cross(n, Vec3f(0.3f, 0.2f, 1)));
    const float size = random(0.05f, 0.3f);
    scene.lights.polygons.push_back(light::rectangle(
        at, t * size, cross(n, t) * size, Vec3f(1000, random(300, 1000), random(200, 900))));
  }
  scene.cameras.push_back(test::look_at({0, 2.5f, 14}, {0, 0.5f, 0}, 0.8f));
  return scene;
}

render::RenderOptions small_picture() {
  render::RenderOptions options;
  options.width = 96;
  options.height = 64;
  options.samples = 2;
  options.shadow_samples = 0;
  return options;
}

/// Mean of the absolute difference over the mean of the truth.
double relative_difference(const image::Image& picture, const image::Image& truth) {
  double sum = 0, difference = 0;
  for (std::size_t i = 0; i < truth.data.size(); ++i) {
    sum += double(truth.data[i]);
    difference += std::abs(double(picture.data[i]) - double(truth.data[i]));
  }
  return difference / sum;
}

} // namespace

TEST_CASE("no pixel of a picture of many lights errs more than was allowed, and fewer are shaded") {
  const scene::Scene scene = room_of_lamps(150);
  render::RenderOptions options = small_picture();
  for (const render::SpecularForm form :
       {render::SpecularForm::lobe, render::SpecularForm::ratio, render::SpecularForm::exact,
        render::SpecularForm::adaptive}) {
    options.specular_form = form;
    options.light_error = 0;
    const render::Picture all = rendered(scene, options);
    CHECK(all.light_error_nits == 0);
    CHECK(all.lights_per_point == doctest::Approx(150));
    double previous = 150;
    for (const float error : {0.002f, 0.02f, 0.2f}) {
      options.light_error = error;
      const render::Picture chosen = rendered(scene, options);
      CHECK(chosen.light_error_nits > 0);
      const float brightest = *std::max_element(all.radiance.data.begin(), all.radiance.data.end());
      CHECK(max_difference(all.radiance, chosen.radiance) <=
            chosen.light_error_nits + 1e-6 * double(brightest));
      MESSAGE("lights per point: ", chosen.lights_per_point);
      // Groups have no specular part but by the lobe alone.
      CHECK(chosen.lights_per_point < (form == render::SpecularForm::lobe ? 0.4 : 0.6) * 150);
      CHECK(chosen.lights_per_point < 0.9 * previous);
      previous = chosen.lights_per_point;
    }
  }
}

TEST_CASE("by two lobes, too, no pixel of many lights errs more than was allowed") {
  const scene::Scene scene = room_of_lamps(80);
  render::RenderOptions options = small_picture();
  const auto two_lobes = [&](float error) {
    options.light_error = error;
    auto picture =
        render::render(scene, scene.cameras[0], table::builtin_ggx_two_lobe_table(), options);
    REQUIRE(picture.ok());
    return std::move(*picture);
  };
  const render::Picture all = two_lobes(0), chosen = two_lobes(0.02f);
  CHECK(chosen.light_error_nits > 0);
  const float brightest = *std::max_element(all.radiance.data.begin(), all.radiance.data.end());
  CHECK(max_difference(all.radiance, chosen.radiance) <=
        chosen.light_error_nits + 1e-6 * double(brightest));
  CHECK(chosen.lights_per_point < 0.8 * 80);
}

TEST_CASE("with shadows the picture of chosen lights stays near that of all") {
  const scene::Scene scene = room_of_lamps(60);
  render::RenderOptions options = small_picture();
  options.width = 48;
  options.height = 32;
  options.samples = 4;
  options.shadow_samples = 16;
  options.light_error = 0;
  const render::Picture all = rendered(scene, options);
  options.light_error = 0.002f;
  const render::Picture chosen = rendered(scene, options);
  // Shadows of dim lights are sampled together: noise, but little, and no bias.
  CHECK(relative_difference(chosen.radiance, all.radiance) < 0.02);
}

TEST_CASE("chosen lights do not depend on the number of threads, and the reference takes all") {
  const scene::Scene scene = room_of_lamps(40);
  render::RenderOptions options = small_picture();
  options.shadow_samples = 4;
  options.threads = 1;
  const render::Picture one = rendered(scene, options);
  options.threads = 3;
  CHECK(one.radiance.data == rendered(scene, options).radiance.data);

  options.integrator = render::Integrator::reference;
  const render::Picture reference = rendered(scene, options);
  CHECK(reference.lights_per_point == doctest::Approx(40));
  options.light_error = 0;
  CHECK(reference.radiance.data == rendered(scene, options).radiance.data);
}

TEST_CASE("a light error out of range is refused") {
  const scene::Scene scene = room_of_lamps(1);
  for (const float wrong : {-0.1f, 1.5f, std::nanf("")}) {
    render::RenderOptions options = small_picture();
    options.light_error = wrong;
    CHECK_FALSE(
        render::render(scene, scene.cameras.at(0), table::builtin_ggx_table(), options).ok());
  }
}

TEST_CASE("shadows of many lights are as quiet by the ratio and by GGX itself as by the lobe") {
  const scene::Scene scene = room_of_lamps(120);
  const auto noise = [&](render::SpecularForm form) {
    render::RenderOptions options = small_picture();
    options.samples = 1;
    options.filter = render::PixelFilter::none;
    options.specular_form = form;
    options.shadow_samples = 16;
    const render::Picture picture = rendered(scene, options);
    options.shadow_samples = 512;
    options.seed = 1;
    return relative_difference(picture.radiance, rendered(scene, options).radiance);
  };
  const double of_lobe = noise(render::SpecularForm::lobe);
  const double of_ratio = noise(render::SpecularForm::ratio);
  const double of_ggx = noise(render::SpecularForm::exact);
  MESSAGE("noise of the lobe ", of_lobe, ", by the ratio ", of_ratio, ", of GGX ", of_ggx);
  CHECK(of_lobe > 1e-4); // there are shadows
  CHECK(of_ratio < 1.25 * of_lobe);
  CHECK(of_ggx < 1.25 * of_lobe);
}
