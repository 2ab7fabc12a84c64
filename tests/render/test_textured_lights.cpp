// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights with pictures: the closed form and its prefiltered picture against the reference, which
// looks at the picture itself.

#include "openltc/light/emission_stack.h"
#include "openltc/render/renderer.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>

using namespace openltc;

namespace {

// Panes of coloured glass in a dark frame.
image::Image window() {
  image::Image picture(96, 64, 3);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 96; ++x) {
      const int pane = x / 24 + y / 32;
      const bool frame = x % 24 < 3 || x % 24 > 20 || y % 32 < 3 || y % 32 > 28;
      for (int c = 0; c < 3; ++c)
        picture.pixel(x, y)[c] = frame ? 0.02f : (pane % 3 == c ? 1.0f : 0.25f);
    }
  return picture;
}

// A floor and a standing light of 3 x 2 metres behind it, a rectangle or an ellipse.
scene::Scene standing_light(const scene::Material& floor, bool is_ellipse) {
  scene::Scene scene;
  test::add_floor(scene, 20, 0, floor);
  scene.lights.textures.push_back(window());
  if (is_ellipse) {
    light::EllipseLight light;
    light.center = {0, 1.2f, -2};
    light.half_u = {1.5f, 0, 0};
    light.half_v = {0, 1, 0};
    light.radiance = {10, 10, 10};
    light::place_texture(light, 0, {1, 0, 0});
    scene.lights.ellipses.push_back(light);
  } else {
    light::PolygonLight light;
    light.vertices = {{-1.5f, 0.2f, -2}, {1.5f, 0.2f, -2}, {1.5f, 2.2f, -2}, {-1.5f, 2.2f, -2}};
    light.ring_end = {4};
    light.normal = {0, 0, 1};
    light.radiance = {10, 10, 10};
    light::place_texture(light, 0, {1, 0, 0});
    scene.lights.polygons.push_back(light);
  }
  return scene;
}

image::Image rendered(const scene::Scene& scene, render::Integrator integrator, int samples,
                      int shadow_samples, const char* kernel = "auto", bool two_lobes = false,
                      std::optional<render::SpecularForm> form = {}) {
  render::RenderOptions options;
  options.width = 48;
  options.height = 36;
  options.integrator = integrator;
  options.samples = samples;
  options.shadow_samples = shadow_samples;
  options.kernel = kernel;
  options.specular_form = form;
  auto picture = render::render(
      scene, test::look_at({0, 1.6f, 3}, {0, 0, -0.5f}, 0.7f),
      two_lobes ? table::builtin_ggx_two_lobe_table() : table::builtin_ggx_table(), options);
  REQUIRE(picture.ok());
  CHECK(picture->warnings.empty());
  return std::move(picture->radiance);
}

// Mean absolute difference over the mean.
double error(const image::Image& a, const image::Image& truth) {
  double difference = 0, sum = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i) {
    difference += std::abs(double(a.data[i]) - double(truth.data[i]));
    sum += double(truth.data[i]);
  }
  return difference / sum;
}

// The same light without its picture, but of its mean.
scene::Scene averaged(scene::Scene scene) {
  for (auto& light : scene.lights.polygons) {
    light.radiance =
        light.radiance * light::build_emission_stack(scene.lights.textures[0], light)->mean;
    light.texture = -1;
  }
  return scene;
}

} // namespace

TEST_CASE("a textured rectangle over a floor: LTC against the reference, by roughness") {
  struct Row {
    double roughness; // negative: diffuse only
    double bound;
  };
  for (const Row& row : {Row{-1, 0.05}, Row{0.1, 0.03}, Row{0.2, 0.05}, Row{0.3, 0.05},
                         Row{0.5, 0.05}, Row{0.7, 0.05}, Row{1, 0.05}}) {
    const scene::Material floor =
        row.roughness < 0 ? test::diffuse_material({0.7f, 0.7f, 0.7f})
                          : test::glossy_material({0.9f, 0.9f, 0.9f}, float(row.roughness), true);
    const scene::Scene scene = standing_light(floor, false);
    const image::Image truth = rendered(scene, render::Integrator::reference, 1024, 0);
    const double with = error(rendered(scene, render::Integrator::ltc, 16, 0), truth);
    const double mean = error(rendered(averaged(scene), render::Integrator::ltc, 16, 0), truth);
    // What the lobes themselves, without a picture, differ by.
    const double lobes = error(rendered(averaged(scene), render::Integrator::ltc, 16, 0),
                               rendered(averaged(scene), render::Integrator::reference, 1024, 0));
    MESSAGE("roughness ", row.roughness, ": error ", with, "; with the picture's mean ", mean,
            "; of a light without a picture ", lobes);
    CHECK(with < row.bound + lobes);
    CHECK(with < 0.75 * mean);
  }
}

TEST_CASE("a textured rectangle by two lobes is closer to the reference than by one") {
  const scene::Scene scene =
      standing_light(test::glossy_material({0.9f, 0.9f, 0.9f}, 0.4f, true), false);
  const image::Image truth = rendered(scene, render::Integrator::reference, 512, 0);
  const auto by_ratio = [&](bool two_lobes) {
    return rendered(scene, render::Integrator::ltc, 16, 0, "auto", two_lobes,
                    render::SpecularForm::ratio);
  };
  const double one = error(by_ratio(false), truth), ratio = error(by_ratio(true), truth);
  const image::Image two = rendered(scene, render::Integrator::ltc, 16, 0, "auto", true);
  MESSAGE("error by the ratio ", ratio, ", of one lobe ", one, "; by default ", error(two, truth));
  CHECK(ratio < 0.9 * one); // the rest is the picture, seen in a few looks
  CHECK(error(two, truth) < ratio);
  CHECK(error(rendered(scene, render::Integrator::ltc, 16, 0, "scalar", true), two) < 1e-4);
}

TEST_CASE("a textured disk is close to the reference; every kernel gives it alike") {
  const scene::Scene scene =
      standing_light(test::glossy_material({0.5f, 0.5f, 0.5f}, 0.4f, false), true);
  const image::Image truth = rendered(scene, render::Integrator::reference, 1024, 0);
  const image::Image ltc = rendered(scene, render::Integrator::ltc, 16, 0);
  MESSAGE("error ", error(ltc, truth));
  CHECK(error(ltc, truth) < 0.05);
  CHECK(error(rendered(scene, render::Integrator::ltc, 16, 0, "scalar"), ltc) < 1e-4);
}

TEST_CASE("the shadow of a textured light has the picture's colours") {
  // A ball before the window: where it hides the red panes the floor is less red.
  scene::Scene scene = standing_light(test::diffuse_material({0.7f, 0.7f, 0.7f}), false);
  test::add_sphere(scene, {-0.3f, 0.6f, -1.2f}, 0.5f, test::diffuse_material({0.2f, 0.2f, 0.2f}));
  const image::Image truth = rendered(scene, render::Integrator::reference, 2048, 1);
  const image::Image ltc = rendered(scene, render::Integrator::ltc, 256, 256);
  const image::Image unshadowed = rendered(scene, render::Integrator::ltc, 32, 0);
  MESSAGE("error ", error(ltc, truth), ", without shadows ", error(unshadowed, truth));
  CHECK(error(ltc, truth) < 0.07);
  CHECK(error(unshadowed, truth) > 2 * error(ltc, truth));
}

TEST_CASE("a picture that is missing leaves an even light and a word about it") {
  scene::Scene scene = standing_light(test::diffuse_material({0.7f, 0.7f, 0.7f}), false);
  scene.lights.textures.clear();
  scene.lights.polygons[0].name = "screen";
  render::RenderOptions options;
  options.width = options.height = 8;
  options.samples = 1;
  auto picture = render::render(scene, test::look_at({0, 1.6f, 3}, {0, 0, -0.5f}, 0.7f),
                                table::builtin_ggx_table(), options);
  REQUIRE(picture.ok());
  REQUIRE(picture->warnings.size() == 1);
  CHECK(picture->warnings[0].find("screen") != std::string::npos);
  CHECK(picture->radiance.pixel(4, 6)[0] > 0);
}
