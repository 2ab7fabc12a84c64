// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/polygon.h"
#include "openltc/light/punctual.h"
#include "openltc/scene/view/framing.h"
#include "openltc/scene/view/studio.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace {

using namespace openltc;

std::vector<Vec3f> corners_of(const scene::Bounds& b) {
  std::vector<Vec3f> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back(Vec3f(i & 1 ? b.upper.x : b.lower.x, i & 2 ? b.upper.y : b.lower.y,
                            i & 4 ? b.upper.z : b.lower.z));
  return corners;
}

TEST_CASE("a_framed_scene_is_all_in_view_and_fills_the_picture") {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (int trial = 0; trial < 200; ++trial) {
    scene::Bounds bounds;
    bounds.lower = Vec3f(uniform(random), uniform(random), uniform(random)) * 5.0f;
    const float scale = std::pow(10.0f, 3 * uniform(random));
    bounds.upper =
        bounds.lower +
        Vec3f(1.01f + uniform(random), 1.01f + uniform(random), 1.01f + uniform(random)) * scale;
    const float aspect = std::exp(uniform(random));
    const scene::Camera camera = scene::frame_scene(bounds, aspect);
    CHECK(std::abs(length(camera.forward) - 1) < 1e-5f);
    CHECK(length(cross(camera.right, camera.up) + camera.forward) < 1e-5f);
    const float tan_y = std::tan(0.5f * camera.fov_y_rad);
    float widest = 0;
    for (const Vec3f corner : corners_of(bounds)) {
      const Vec3f d = corner - camera.position;
      const float depth = dot(d, camera.forward);
      CHECK(depth > camera.near);
      const float x = std::abs(dot(d, camera.right)) / (depth * tan_y * aspect);
      const float y = std::abs(dot(d, camera.up)) / (depth * tan_y);
      CHECK(x < 1);
      CHECK(y < 1);
      widest = std::max({widest, x, y});
    }
    CHECK(widest > 0.85f);
    const float short_angle = aspect >= 1 ? camera.fov_y_rad : 2 * std::atan(tan_y * aspect);
    CHECK(double(short_angle) == doctest::Approx(35 * std::numbers::pi / 180).epsilon(1e-4));
  }
}

TEST_CASE("a_chart_is_framed_from_the_front_and_by_its_points_not_its_box") {
  scene::Scene chart;
  chart.meshes.emplace_back();
  // A diamond: its box has corners that it does not reach.
  chart.meshes[0].positions = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  chart.bounds = {Vec3f(-1, -1, 0), Vec3f(1, 1, 0)};
  const scene::Camera camera = scene::frame_scene(chart, 1);
  CHECK(double(camera.forward.z) == doctest::Approx(-1));
  float widest = 0;
  for (const Vec3f p : chart.meshes[0].positions) {
    const Vec3f d = p - camera.position;
    const float tan_y = std::tan(0.5f * camera.fov_y_rad);
    widest = std::max({widest, std::abs(dot(d, camera.right)) / (dot(d, camera.forward) * tan_y),
                       std::abs(dot(d, camera.up)) / (dot(d, camera.forward) * tan_y)});
  }
  CHECK(widest < 1);
  CHECK(widest > 0.9f);
}

TEST_CASE("empty_bounds_give_a_usable_camera") {
  const scene::Camera camera = scene::frame_scene(scene::Bounds{}, 1.5f);
  CHECK(std::isfinite(camera.position.z));
  CHECK(length(camera.position) > 0.5f);
}

// Irradiance per channel at `point` with `normal`, by summing over the light's surface.
double irradiance(const light::PolygonLight& light, Vec3f point, Vec3f normal) {
  constexpr int n = 200;
  const Vec3f a = light.vertices[1] - light.vertices[0], b = light.vertices[3] - light.vertices[0];
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vec3f d =
          light.vertices[0] + a * ((float(i) + 0.5f) / n) + b * ((float(j) + 0.5f) / n) - point;
      const double r2 = double(dot(d, d));
      const double cos_light = -double(dot(d, light.normal)), cos_point = double(dot(d, normal));
      if (cos_light > 0 && cos_point > 0) sum += cos_light * cos_point / (r2 * r2);
    }
  return double(light.radiance.x) * sum * light::area(light) / (n * n);
}

TEST_CASE("the_studio_gives_a_white_card_the_luminance_asked_for_at_any_size") {
  for (const float size : {0.001f, 1.0f, 500.0f}) {
    const scene::Bounds bounds{Vec3f(-size, 0, -size), Vec3f(size, size, size)};
    const Vec3f center(0, 0.5f * size, 0);
    const float radius = 0.5f * length(bounds.upper - bounds.lower);
    const auto lights = scene::studio_lights(bounds, scene::frame_scene(bounds, 1), 25);
    REQUIRE(lights.polygons.size() == 3);
    CHECK(lights.punctual.empty());
    for (const auto& light : lights.polygons) {
      CHECK(light::validate(light).ok());
      CHECK(!light.two_sided);
      // outside the scene's sphere, facing it
      for (const Vec3f v : light.vertices)
        CHECK(length(v - center) > radius);
      CHECK(dot(light.normal, center - light.vertices[0]) > 0);
    }
    const light::PolygonLight& key = lights.polygons[0];
    const double luminance_nits = irradiance(key, center, -key.normal) / std::numbers::pi;
    CHECK(luminance_nits == doctest::Approx(25).epsilon(0.01));
    // What the scene's own lights give is estimated with polygons taken for points.
    CHECK(scene::white_level_nits(lights, bounds) == doctest::Approx(25).epsilon(0.5));
  }
}

TEST_CASE("the_key_comes_from_the_upper_left_of_the_camera_and_the_rim_from_behind") {
  const scene::Bounds bounds{Vec3f(-1, -1, -1), Vec3f(1, 1, 1)};
  for (const float turn : {0.0f, 1.0f, 2.5f}) {
    scene::Camera camera;
    camera.forward = Vec3f(std::sin(turn), 0, -std::cos(turn));
    camera.right = Vec3f(std::cos(turn), 0, std::sin(turn));
    const auto lights = scene::studio_lights(bounds, camera);
    const Vec3f to_key = -lights.polygons[0].normal, to_rim = -lights.polygons[2].normal;
    CHECK(dot(to_key, camera.right) < 0);
    CHECK(to_key.y > 0.3f);
    CHECK(dot(to_key, camera.forward) < 0);
    CHECK(dot(to_rim, camera.forward) > 0);
  }
  // looking straight down still works
  scene::Camera down;
  down.forward = Vec3f(0, -1, 0);
  down.up = Vec3f(0, 0, -1);
  for (const auto& light : scene::studio_lights(bounds, down).polygons)
    CHECK(light::validate(light).ok());
}

} // namespace
