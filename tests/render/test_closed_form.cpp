// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The closed form in a picture, against converged quadrature of the same integral.

#include "openltc/render/camera_rays.h"
#include "openltc/render/renderer.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace openltc;

namespace {

struct Rectangle {
  double x0, z0, x1, z1, height;
};

// Irradiance/pi at a floor point from a rectangle parallel to it: the integral of
// cos cos' / (pi d^2) over the rectangle, by Gauss-Legendre on ever finer cells.
double quadrature(const Rectangle& r, double px, double pz) {
  static const double x[5] = {-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                              0.9061798459386640};
  static const double w[5] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                              0.4786286704993665, 0.2369268850561891};
  constexpr int cells = 24;
  constexpr double pi = std::numbers::pi;
  const double dx = (r.x1 - r.x0) / cells, dz = (r.z1 - r.z0) / cells;
  double sum = 0;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      for (int a = 0; a < 5; ++a)
        for (int b = 0; b < 5; ++b) {
          const double qx = r.x0 + dx * (i + 0.5 + 0.5 * x[a]) - px;
          const double qz = r.z0 + dz * (j + 0.5 + 0.5 * x[b]) - pz;
          const double d2 = qx * qx + qz * qz + r.height * r.height;
          sum += w[a] * w[b] * r.height * r.height / (pi * d2 * d2);
        }
  return sum * 0.25 * dx * dz;
}

} // namespace

TEST_CASE("Lambertian floor under polygon lights equals quadrature to 1e-4 at every pixel") {
  scene::Scene scene;
  test::add_floor(scene, 10, 0, test::diffuse_material({0.5f, 0.25f, 0.75f}));
  const std::vector<Rectangle> rectangles = {
      {-0.5, -0.5, 0.5, 0.5, 1.0}, {1.0, -2.0, 1.3, 1.0, 0.4}, {-3.0, -3.0, -1.0, 2.0, 2.5}};
  for (const Rectangle& r : rectangles)
    scene.lights.polygons.push_back(test::ceiling_rectangle(float(r.x0), float(r.z0), float(r.x1),
                                                            float(r.z1), float(r.height), 100));
  // An L of two rectangles, as one outline.
  scene.lights.polygons.push_back(
      test::ceiling_light({{{2, 2}, {4, 2}, {4, 3}, {3, 3}, {3, 4}, {2, 4}}}, 1.5f, 100));
  // A frame: a square with a square hole.
  scene.lights.polygons.push_back(
      test::ceiling_light({{{-4, 2}, {-2, 2}, {-2, 4}, {-4, 4}},
                           {{-3.5f, 2.5f}, {-3.5f, 3.5f}, {-2.5f, 3.5f}, {-2.5f, 2.5f}}},
                          1.2f, 100));

  const scene::Camera camera = test::look_at({0, 6, 0.01f}, {0, 0, 0}, 1.2f);
  render::RenderOptions options;
  options.width = 64;
  options.height = 48;
  options.samples = 1;
  options.shadow_samples = 0;
  auto picture = render::render(scene, camera, table::builtin_ggx_table(), options);
  REQUIRE(picture.ok());

  const render::CameraRays rays(camera, options.width, options.height);
  double worst = 0;
  for (int y = 0; y < options.height; ++y)
    for (int x = 0; x < options.width; ++x) {
      const render::CameraRay ray = rays.ray(float(x) + 0.5f, float(y) + 0.5f);
      const double t = -double(ray.origin.y) / double(ray.direction.y);
      const double px = double(ray.origin.x) + t * double(ray.direction.x);
      const double pz = double(ray.origin.z) + t * double(ray.direction.z);
      double expected = 0;
      for (const Rectangle& r : rectangles)
        expected += quadrature(r, px, pz);
      expected += quadrature({2, 2, 4, 3, 1.5}, px, pz) + quadrature({2, 3, 3, 4, 1.5}, px, pz);
      expected +=
          quadrature({-4, 2, -2, 4, 1.2}, px, pz) - quadrature({-3.5, 2.5, -2.5, 3.5, 1.2}, px, pz);
      const float* rgb = picture->radiance.pixel(x, y);
      const double albedo[3] = {0.5, 0.25, 0.75};
      for (int c = 0; c < 3; ++c) {
        const double wanted = 100 * albedo[c] * expected;
        worst = std::max(worst, std::abs(double(rgb[c]) - wanted) / wanted);
      }
    }
  MESSAGE("largest relative error: " << worst);
  CHECK(worst < 1e-4);
}

TEST_CASE("a light shines to its front only, unless it has two sides") {
  for (const bool two_sided : {false, true}) {
    scene::Scene scene;
    test::add_floor(scene, 10, 0, test::glossy_material({0.5f, 0.5f, 0.5f}, 0.3f, false));
    light::PolygonLight light = test::ceiling_rectangle(-1, -1, 1, 1, 2, 100);
    std::reverse(light.vertices.begin(), light.vertices.end());
    light.normal = {0, 1, 0};
    light.two_sided = two_sided;
    scene.lights.polygons.push_back(light);
    render::RenderOptions options;
    options.width = options.height = 16;
    options.samples = 1;
    for (const auto integrator : {render::Integrator::ltc, render::Integrator::reference}) {
      options.integrator = integrator;
      auto picture = render::render(scene, test::look_at({0, 3, 3}, {0, 0, 0}, 0.5f),
                                    table::builtin_ggx_table(), options);
      REQUIRE(picture.ok());
      double sum = 0;
      for (const float v : picture->radiance.data)
        sum += double(v);
      if (two_sided)
        CHECK(sum > 1);
      else
        CHECK(sum == 0);
    }
  }
}
