// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights whose picture is dark but for a few places: samples are drawn where the light is. What is
// right is a sum over the lit texels, which interpolation makes tents of.

#include "openltc/light/emission_stack.h"
#include "openltc/render/renderer.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace openltc;

namespace {

constexpr double k_albedo = 0.6, k_nits = 1.0e5;

// A standing light of 2 x 2 metres, z = -2, that faces +z, and a floor; `lit` are its lit texels.
scene::Scene starlit(int size, const std::vector<std::pair<int, int>>& lit, bool is_ellipse) {
  scene::Scene scene;
  test::add_floor(scene, 20, 0, test::diffuse_material(Vec3f(float(k_albedo))));
  image::Image picture(size, size, 3);
  for (const auto& [x, y] : lit)
    for (int c = 0; c < 3; ++c)
      picture.pixel(x, y)[c] = 1;
  scene.lights.textures.push_back(picture);
  if (is_ellipse) {
    light::EllipseLight light;
    light.center = {0, 1.2f, -2};
    light.half_u = {1, 0, 0};
    light.half_v = {0, 1, 0};
    light.radiance = Vec3f(float(k_nits));
    light::place_texture(light, 0, {1, 0, 0});
    scene.lights.ellipses.push_back(light);
  } else {
    light::PolygonLight light;
    light.vertices = {{-1, 0.2f, -2}, {1, 0.2f, -2}, {1, 2.2f, -2}, {-1, 2.2f, -2}};
    light.ring_end = {4};
    light.normal = {0, 0, 1};
    light.radiance = Vec3f(float(k_nits));
    light::place_texture(light, 0, {1, 0, 0});
    scene.lights.polygons.push_back(light);
  }
  return scene;
}

// Radiance of the floor at `p` by these texels: each sends as much as its own area, L cos cos'/r^2.
double truth_at(Vec3d p, int size, const std::vector<std::pair<int, int>>& lit) {
  double sum = 0;
  const double side = 2.0 / size;
  for (const auto& [x, y] : lit) {
    const Vec3d d = Vec3d(-1 + (x + 0.5) * side, 2.2 - (y + 0.5) * side, -2) - p;
    const double r2 = dot(d, d);
    sum += d.y * -d.z / (r2 * r2) * side * side;
  }
  return k_albedo / std::numbers::pi * k_nits * sum;
}

// A very narrow view of the floor at the origin: all pixels see the same place.
render::Picture spot(const scene::Scene& scene, render::Integrator integrator, int samples,
                     int shadow_samples, const char* kernel = "auto") {
  render::RenderOptions options;
  options.width = options.height = 16;
  options.integrator = integrator;
  options.samples = samples;
  options.shadow_samples = shadow_samples;
  options.filter = render::PixelFilter::none;
  options.kernel = kernel;
  auto picture = render::render(scene, test::look_at({0, 2, 2}, {0, 0, 0}, 1e-3f),
                                table::builtin_ggx_table(), options);
  REQUIRE(picture.ok());
  CHECK(picture->warnings.empty());
  return std::move(*picture);
}

struct Mean {
  double value = 0, error = 0; // standard error from the spread of the pixels
};

Mean mean_of(const image::Image& image) {
  double sum = 0, squares = 0;
  const double n = double(image.pixel_count());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double v = double(image.rgb(x, y).x);
      sum += v;
      squares += v * v;
    }
  Mean mean;
  mean.value = sum / n;
  mean.error = std::sqrt(std::max(squares / n - mean.value * mean.value, 0.0) / (n - 1));
  return mean;
}

} // namespace

TEST_CASE("two lit texels of 512 x 512 are found: mean and variance of the reference") {
  const std::vector<std::pair<int, int>> lit = {{100, 57}, {400, 391}};
  const double truth = truth_at({0, 0, 0}, 512, lit);
  for (const char* kernel : {"auto", "scalar"})
    for (const bool is_ellipse : {false, true}) {
      CAPTURE(is_ellipse);
      const scene::Scene scene = starlit(512, lit, is_ellipse);
      constexpr int samples = 64;
      const render::Picture picture =
          spot(scene, render::Integrator::reference, samples, 0, kernel);
      const Mean mean = mean_of(picture.radiance);
      MESSAGE("mean ", mean.value, ", standard error ", mean.error, ", truth ", truth);
      CHECK(std::abs(mean.value - truth) < 4 * mean.error + 1e-3 * truth);
      // By the solid angle alone a sample finds the light with the probability f = 8/512^2 that it
      // is within two tents, and its relative variance is E[L^2]/E[L]^2 - 1 with E[L^2] = 2 (4/9) /
      // 512^2 and E[L] = 2/512^2: 58,253. It falls at least ten-thousandfold.
      const double solid_angle_variance = 512.0 * 512 * 4 / 9 / 2 - 1;
      const double relative = mean.error / truth;
      const double variance =
          relative * relative * samples * double(picture.radiance.pixel_count());
      MESSAGE("relative variance of a sample ", variance, " instead of ", solid_angle_variance);
      CHECK(variance < solid_angle_variance / 1e4);
    }
}

TEST_CASE("the mixture of densities is exact for pictures of any kind") {
  // A dense and a sparse picture, seen from near and glossily as well: against the scene without a
  // picture's cells there is no comparison, so the light is cut into its texels, each a light.
  const int size = 8;
  std::vector<std::pair<int, int>> lit;
  for (int i = 0; i < size * size; ++i)
    if ((i * 7) % 11 < 3) lit.push_back({i % size, i / size});
  scene::Scene scene = starlit(size, lit, false);
  for (scene::Material& material : scene.materials)
    material = test::glossy_material({0.8f, 0.8f, 0.8f}, 0.3f, true);
  // Nearly no interpolation: the same picture, each texel 32 times as fine.
  const image::Image coarse = scene.lights.textures[0].to_image();
  image::Image fine(size * 32, size * 32, 3);
  for (int y = 0; y < fine.height; ++y)
    for (int x = 0; x < fine.width; ++x)
      std::copy_n(coarse.pixel(x / 32, y / 32), 3, fine.pixel(x, y));
  scene.lights.textures[0] = fine;
  scene::Scene texels = scene;
  texels.lights = {};
  const float side = 2.0f / size;
  for (const auto& [column, row] : lit) {
    light::PolygonLight light = scene.lights.polygons[0];
    light.texture = -1;
    const float x = -1 + float(column) * side, y = 2.2f - float(row) * side;
    light.vertices = {{x, y - side, -2}, {x + side, y - side, -2}, {x + side, y, -2}, {x, y, -2}};
    texels.lights.polygons.push_back(light);
  }
  const Mean by_cells = mean_of(spot(scene, render::Integrator::reference, 512, 0).radiance);
  const Mean by_lights = mean_of(spot(texels, render::Integrator::reference, 512, 0).radiance);
  MESSAGE(by_cells.value, " +- ", by_cells.error, ", ", by_lights.value, " +- ", by_lights.error);
  CHECK(std::abs(by_cells.value - by_lights.value) <
        4 * (by_cells.error + by_lights.error) + 2e-3 * by_lights.value);
  CHECK(by_cells.error < 0.02 * by_cells.value);
}

TEST_CASE("the shadow ratio sees the lit texels, not the dark rest of a light") {
  // A post before the left half of the light, which has all that is lit.
  const std::vector<std::pair<int, int>> lit = {{60, 300}, {110, 180}};
  scene::Scene scene = starlit(512, lit, false);
  const Mean open = mean_of(spot(scene, render::Integrator::ltc, 16, 16).radiance);
  const double truth = truth_at({0, 0, 0}, 512, lit);
  CHECK(open.value == doctest::Approx(truth).epsilon(0.1));
  scene.materials.push_back(test::diffuse_material(Vec3f(0.0f)));
  scene::Mesh wall;
  wall.material = int(scene.materials.size()) - 1;
  wall.positions = {{-1, 0, -1}, {-0.05f, 0, -1}, {-0.05f, 3, -1}, {-1, 3, -1}};
  wall.normals.assign(4, {0, 0, 1});
  wall.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.meshes.push_back(wall);
  const Mean hidden = mean_of(spot(scene, render::Integrator::ltc, 16, 16).radiance);
  MESSAGE("open ", open.value, ", hidden ", hidden.value);
  CHECK(hidden.value < 0.01 * truth);
  // And a post before the dark half hides nothing.
  for (Vec3f& p : scene.meshes.back().positions)
    p.x += 1.05f;
  const Mean beside = mean_of(spot(scene, render::Integrator::ltc, 16, 16).radiance);
  CHECK(beside.value == doctest::Approx(open.value).epsilon(0.01));
}
