// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights of every shape: the closed form against the reference integrator. On a Lambertian surface
// both are the same integral, so they agree within the reference's own noise.

#include "openltc/render/renderer.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace openltc;

namespace {

struct Case {
  std::string name;
  std::function<void(light::Lights&)> add;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  all.push_back({"disk", [](light::Lights& lights) {
                   light::EllipseLight light;
                   light.center = Vec3f(0.3f, 0.9f, -0.2f);
                   light.half_u = Vec3f(0, 0, 0.5f);
                   light.half_v = Vec3f(-0.48f, 0.14f, 0); // shines down
                   lights.ellipses.push_back(light);
                 }});
  all.push_back({"upright two-sided ellipse", [](light::Lights& lights) {
                   light::EllipseLight light;
                   light.center = Vec3f(0, 0.2f, 0); // half of it below the floor
                   light.half_u = Vec3f(0.9f, 0, 0);
                   light.half_v = Vec3f(0, 0.4f, 0);
                   light.two_sided = true;
                   lights.ellipses.push_back(light);
                 }});
  all.push_back({"sphere", [](light::Lights& lights) {
                   light::SphereLight light;
                   light.center = Vec3f(0.2f, 0.3f, 0);
                   light.radius = 0.45f; // touches the floor and goes through
                   lights.spheres.push_back(light);
                 }});
  for (const light::TubeCaps caps :
       {light::TubeCaps::none, light::TubeCaps::flat, light::TubeCaps::round})
    all.push_back({"tube", [caps](light::Lights& lights) {
                     light::TubeLight light;
                     light.from = Vec3f(-0.6f, 0.5f, -0.3f);
                     light.to = Vec3f(0.5f, 0.3f, 0.4f);
                     light.radius = 0.2f;
                     light.caps = caps;
                     lights.tubes.push_back(light);
                   }});
  all.push_back({"upright tube", [](light::Lights& lights) {
                   light::TubeLight light;
                   light.from = Vec3f(0.1f, -0.2f, 0);
                   light.to = Vec3f(0.1f, 0.8f, 0);
                   light.radius = 0.1f;
                   light.caps = light::TubeCaps::flat;
                   lights.tubes.push_back(light);
                 }});
  all.push_back({"line", [](light::Lights& lights) {
                   light::LineLight light;
                   light.from = Vec3f(-0.6f, 0.5f, -0.3f);
                   light.to = Vec3f(0.5f, 0.2f, 0.4f);
                   light.intensity_per_metre = Vec3f(50.0f);
                   lights.lines.push_back(light);
                 }});
  return all;
}

scene::Scene lit_floor(const Case& c, const scene::Material& material) {
  scene::Scene scene;
  test::add_floor(scene, 10, 0, material);
  c.add(scene.lights);
  const auto brighten = [](auto& lights) {
    for (auto& light : lights)
      light.radiance = Vec3f(100.0f);
  };
  brighten(scene.lights.ellipses);
  brighten(scene.lights.spheres);
  brighten(scene.lights.tubes);
  return scene;
}

render::Picture picture_of(const scene::Scene& scene, const render::RenderOptions& options) {
  auto picture = render::render(scene, test::look_at({0, 3, 2}, {0, 0, 0}, 0.9f),
                                table::builtin_ggx_table(), options);
  REQUIRE(picture.ok());
  CHECK(picture->warnings.empty());
  return *picture;
}

} // namespace

TEST_CASE("on a Lambertian floor every shape equals its reference within the noise") {
  for (const Case& c : cases()) {
    CAPTURE(c.name);
    const scene::Scene scene = lit_floor(c, test::diffuse_material({0.8f, 0.8f, 0.8f}));
    render::RenderOptions options;
    options.width = 32;
    options.height = 24;
    options.filter = render::PixelFilter::none;
    options.shadow_samples = 0;
    options.samples = 1;
    const render::Picture closed = picture_of(scene, options);
    options.integrator = render::Integrator::reference;
    options.samples = 2048;
    const render::Picture reference = picture_of(scene, options);
    double difference = 0, total = 0, worst = 0;
    for (std::size_t i = 0; i < closed.radiance.data.size(); ++i) {
      const double a = double(closed.radiance.data[i]), b = double(reference.radiance.data[i]);
      const double noise = double(reference.standard_error.data[i]);
      difference += a - b;
      total += b;
      worst = std::max(worst, std::abs(a - b) / (noise + 1e-4 * b + 1e-4));
    }
    REQUIRE(total > 1);
    MESSAGE(c.name, ": means differ by ", difference / total, ", pixels by at most ", worst,
            " standard errors");
    CHECK(std::abs(difference / total) < 5e-4);
    CHECK(worst < 6);
  }
}

TEST_CASE("lights of any shape below the floor leave it dark, whatever its roughness") {
  for (const Case& c : cases())
    for (const float roughness : {0.0f, 0.1f, 0.5f, 1.0f}) {
      CAPTURE(c.name);
      scene::Scene scene = lit_floor(c, test::glossy_material({0.8f, 0.8f, 0.8f}, roughness, true));
      for (scene::Mesh& mesh : scene.meshes)
        for (Vec3f& p : mesh.positions)
          p.y = 1.2f; // above all of them
      render::RenderOptions options;
      options.width = options.height = 24;
      options.samples = 1;
      for (const int shadow_samples : {0, 4}) {
        options.shadow_samples = shadow_samples;
        const render::Picture picture = picture_of(scene, options);
        for (const float v : picture.radiance.data)
          CHECK(v == 0);
      }
    }
}
