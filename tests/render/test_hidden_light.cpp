// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Light that does not arrive: behind the triangle's plane, whatever its normals say, and behind a
// wall, however few samples find the light. What is hidden gives exactly 0, in every mode.

#include "openltc/light/emission_stack.h"
#include "openltc/render/renderer.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace openltc;

namespace {

struct Shape {
  std::string name;
  /// Adds a light of 1000 nits, half a metre high and upright, around a point; it faces -x.
  std::function<void(scene::Scene&, Vec3f)> add;
};

// An upright outline of (z, y) around a point, facing -x: counter-clockwise seen from there.
light::PolygonLight upright(Vec3f at, const std::vector<std::vector<Vec2f>>& rings) {
  light::PolygonLight light;
  for (const auto& ring : rings) {
    for (const Vec2f p : ring)
      light.vertices.push_back(at + Vec3f(0, p.y, p.x));
    light.ring_end.push_back(std::uint32_t(light.vertices.size()));
  }
  light.normal = {-1, 0, 0};
  light.radiance = Vec3f(1000);
  return light;
}

std::vector<Shape> shapes() {
  std::vector<Shape> all;
  const auto polygon = [&](const char* name, const std::vector<std::vector<Vec2f>>& rings) {
    all.push_back({name, [rings](scene::Scene& scene, Vec3f at) {
                     scene.lights.polygons.push_back(upright(at, rings));
                   }});
  };
  polygon("rectangle", {{{-0.2f, -0.25f}, {0.2f, -0.25f}, {0.2f, 0.25f}, {-0.2f, 0.25f}}});
  // Two towers and a base: above most horizons two tips, between which the mean direction passes.
  polygon("towers", {{{-0.3f, -0.25f},
                      {0.3f, -0.25f},
                      {0.3f, 0.25f},
                      {0.25f, 0.25f},
                      {0.25f, -0.2f},
                      {-0.25f, -0.2f},
                      {-0.25f, 0.25f},
                      {-0.3f, 0.25f}}});
  polygon("frame", {{{-0.25f, -0.25f}, {0.25f, -0.25f}, {0.25f, 0.25f}, {-0.25f, 0.25f}},
                    {{-0.24f, -0.24f}, {-0.24f, 0.24f}, {0.24f, 0.24f}, {0.24f, -0.24f}}});
  all.push_back({"picture", [](scene::Scene& scene, Vec3f at) {
                   light::PolygonLight light = upright(
                       at, {{{-0.2f, -0.25f}, {0.2f, -0.25f}, {0.2f, 0.25f}, {-0.2f, 0.25f}}});
                   image::Image picture(8, 8, 3); // each texel has one colour
                   for (int i = 0; i < 64; ++i)
                     picture.data[std::size_t(3 * i + i % 3)] = 1;
                   scene.lights.textures = {picture};
                   light::place_texture(light, 0, {0, 0, 1});
                   scene.lights.polygons.push_back(light);
                 }});
  all.push_back({"disk", [](scene::Scene& scene, Vec3f at) {
                   light::EllipseLight light;
                   light.center = at;
                   light.half_u = {0, 0, 0.25f};
                   light.half_v = {0, 0.25f, 0};
                   light.two_sided = true;
                   light.radiance = Vec3f(1000);
                   scene.lights.ellipses.push_back(light);
                 }});
  all.push_back({"sphere", [](scene::Scene& scene, Vec3f at) {
                   light::SphereLight light;
                   light.center = at;
                   light.radius = 0.25f;
                   light.radiance = Vec3f(1000);
                   scene.lights.spheres.push_back(light);
                 }});
  for (const light::TubeCaps caps :
       {light::TubeCaps::none, light::TubeCaps::flat, light::TubeCaps::round})
    all.push_back({"tube " + std::to_string(int(caps)), [caps](scene::Scene& scene, Vec3f at) {
                     light::TubeLight light;
                     light.from = at - Vec3f(0, 0.2f, 0);
                     light.to = at + Vec3f(0, 0.2f, 0);
                     light.radius = 0.05f;
                     light.caps = caps;
                     light.radiance = Vec3f(1000);
                     scene.lights.tubes.push_back(light);
                   }});
  all.push_back({"line", [](scene::Scene& scene, Vec3f at) {
                   light::LineLight light;
                   light.from = at - Vec3f(0, 0.25f, 0);
                   light.to = at + Vec3f(0, 0.25f, 0);
                   light.intensity_per_metre = Vec3f(1000);
                   scene.lights.lines.push_back(light);
                 }});
  // So many that they are chosen, and taken in groups.
  all.push_back({"many", [](scene::Scene& scene, Vec3f at) {
                   for (int i = 0; i < 40; ++i)
                     scene.lights.polygons.push_back(
                         upright(at + Vec3f(0.02f * float(i % 5), 0, 0.1f * float(i % 8) - 0.4f),
                                 {{{0, -0.25f}, {0.05f, -0.25f}, {0.05f, 0.25f}, {0, 0.25f}}}));
                 }});
  return all;
}

// A square of half side `half` around `center`, spanned by orthonormal u, v.
void add_square(scene::Scene& scene, Vec3f center, Vec3f u, Vec3f v, float half, Vec3f normal,
                const scene::Material& material) {
  scene.materials.push_back(material);
  scene::Mesh mesh;
  mesh.material = int(scene.materials.size()) - 1;
  mesh.positions = {center - u * half - v * half, center + u * half - v * half,
                    center + u * half + v * half, center - u * half + v * half};
  mesh.normals.assign(4, normal);
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.meshes.push_back(mesh);
}

render::Picture rendered(const scene::Scene& scene, const scene::Camera& camera,
                         const render::RenderOptions& options) {
  auto picture = render::render(scene, camera, table::builtin_ggx_table(), options);
  REQUIRE(picture.ok());
  return std::move(*picture);
}

float largest(const render::Picture& picture) {
  return *std::max_element(picture.radiance.data.begin(), picture.radiance.data.end());
}

const render::Integrator k_both[] = {render::Integrator::ltc, render::Integrator::reference};

} // namespace

TEST_CASE("what lies behind a triangle is hidden by it, whatever its normals say, in every mode") {
  std::vector<Shape> all = shapes();
  for (const auto type :
       {light::PunctualType::point, light::PunctualType::spot, light::PunctualType::directional})
    all.push_back({"punctual " + std::to_string(int(type)), [type](scene::Scene& scene, Vec3f at) {
                     light::PunctualLight light;
                     light.type = type;
                     light.position = at;
                     light.direction = normalize(Vec3f(-1, 0.3f, 0));
                     light.cos_outer = 0;
                     light.intensity = Vec3f(1000);
                     scene.lights.punctual.push_back(light);
                   }});
  const scene::Camera camera = test::look_at({0, 3, 0.5f}, {0, 0, 0}, 0.6f);
  int lit = 0;
  for (const Shape& shape : all)
    for (const float steepness : {0.3f, 1.0f, 2.5f})
      for (const float roughness : {0.1f, 0.6f}) {
        CAPTURE(shape.name);
        CAPTURE(steepness);
        CAPTURE(roughness);
        const auto scene_at = [&](Vec3f at, Vec3f normal) {
          scene::Scene scene;
          add_square(scene, Vec3f(0.0f), {0, 0, 1}, {1, 0, 0}, 5, normal,
                     test::glossy_material({0.8f, 0.8f, 0.8f}, roughness, false));
          shape.add(scene, at);
          return scene;
        };
        const Vec3f tilted = normalize(Vec3f(steepness, 1, 0.2f));
        const scene::Scene behind = scene_at({3, -0.3f, 0}, tilted);
        render::RenderOptions options;
        options.width = options.height = 8;
        options.samples = 2;
        for (const auto integrator : k_both)
          for (const char* kernel : {"scalar", "auto"})
            for (const float light_error : {0.0f, 0.003f})
              for (const int shadow_samples : {0, 4}) {
                options.integrator = integrator;
                options.kernel = kernel;
                options.light_error = light_error;
                options.shadow_samples = shadow_samples;
                CHECK(largest(rendered(behind, camera, options)) == 0);
              }
        // The other side of the same plane is lit.
        options.integrator = render::Integrator::ltc;
        if (shape.name.substr(0, 8) != "punctual")
          lit += largest(rendered(scene_at({3, 0.6f, 0}, tilted), camera, options)) > 0;
      }
  CHECK(lit == 6 * int(shapes().size()));
}

TEST_CASE(
    "a light that crosses a tilted triangle's plane has in both integrators what is in front") {
  // On a Lambertian surface both are the same integral.
  for (const Shape& shape : shapes()) {
    if (shape.name == "picture" || shape.name == "many") continue;
    CAPTURE(shape.name);
    scene::Scene scene;
    add_square(scene, Vec3f(0.0f), {0, 0, 1}, {1, 0, 0}, 5, normalize(Vec3f(1.5f, 1, 0.4f)),
               test::diffuse_material({0.8f, 0.8f, 0.8f}));
    shape.add(scene, {1, 0.05f, 0});
    const scene::Camera camera = test::look_at({0, 3, 0.5f}, {0, 0, 0}, 0.6f);
    render::RenderOptions options;
    options.width = options.height = 16;
    options.filter = render::PixelFilter::none;
    options.shadow_samples = 0;
    options.samples = 1;
    const render::Picture closed = rendered(scene, camera, options);
    options.integrator = render::Integrator::reference;
    options.samples = 2048;
    const render::Picture reference = rendered(scene, camera, options);
    double difference = 0, total = 0, worst = 0;
    for (std::size_t i = 0; i < closed.radiance.data.size(); ++i) {
      const double a = double(closed.radiance.data[i]), b = double(reference.radiance.data[i]);
      difference += a - b;
      total += b;
      worst = std::max(worst, std::abs(a - b) /
                                  (double(reference.standard_error.data[i]) + 1e-4 * b + 1e-4));
    }
    REQUIRE(total > 1);
    MESSAGE(shape.name, ": means differ by ", difference / total, ", pixels by at most ", worst,
            " standard errors");
    CHECK(std::abs(difference / total) < 1e-3);
    CHECK(worst < 6);
  }
}

TEST_CASE("no light reaches a pixel behind a wall, however little of it stands above the horizon") {
  // Of the light a tip, 1 to 60 mm, stands above the floor's horizon; a black wall stands between.
  // With tilted normals the light stands above the floor, and its tip above what they make of the
  // horizon.
  const scene::Camera camera = test::look_at({-0.6f, 2, 0.3f}, {-0.2f, 0, 0}, 0.5f);
  std::size_t lit_without = 0;
  for (const Shape& shape : shapes())
    for (const bool tilted : {false, true})
      for (const float tip : {0.001f, 0.01f, 0.06f}) {
        const float slope = tilted ? 0.4f : 0.0f;
        const Vec3f normal = normalize(Vec3f(-slope, 1, 0));
        const auto scene_with = [&](bool wall) {
          scene::Scene scene;
          add_square(scene, Vec3f(0.0f), {0, 0, 1}, {1, 0, 0}, 3, normal,
                     test::glossy_material({0.8f, 0.8f, 0.8f}, 0.4f, false));
          if (wall)
            add_square(scene, {0.8f, 0, 0}, {0, 0, 1}, {0, 1, 0}, 20, {-1, 0, 0},
                       test::diffuse_material({0, 0, 0}));
          // The horizon of the middle of the picture, (-0.2, 0, 0), at the light.
          shape.add(scene, {1.5f, 1.7f * slope + tip - 0.25f, 0});
          return scene;
        };
        render::RenderOptions options;
        options.width = options.height = 12;
        for (const int samples : {1, 4})
          for (const int shadow_samples : {1, 2, 16})
            for (const std::uint32_t seed : {0u, 7u}) {
              options.samples = samples;
              options.shadow_samples = shadow_samples;
              options.seed = seed;
              CAPTURE(shape.name);
              CAPTURE(tilted);
              CAPTURE(tip);
              CAPTURE(samples);
              CAPTURE(shadow_samples);
              for (const auto integrator : k_both) {
                options.integrator = integrator;
                CHECK(largest(rendered(scene_with(true), camera, options)) == 0);
              }
              options.integrator = render::Integrator::ltc;
              lit_without += largest(rendered(scene_with(false), camera, options)) > 0;
            }
      }
  CHECK(lit_without > shapes().size() * 60);
}
