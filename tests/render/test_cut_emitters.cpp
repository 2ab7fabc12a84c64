// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A glowing rectangle of which alpha leaves a part lights a floor as that part does: the form
// factor by quadrature over what is open.

#include "openltc/light/light_list.h"
#include "openltc/render/renderer.h"
#include "openltc/scene/emissive/emissive.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace openltc;

namespace {

constexpr double k_albedo = 0.6, k_nits = 1000;

// A floor and a standing mesh of 2 x 2 metres at z = -2 that faces +z, with a texture whose alpha
// is `outside` but for one quarter of the rectangle, where it is 1.
scene::Scene panel(scene::AlphaMode mode, float factor, float outside) {
  scene::Scene scene;
  test::add_floor(scene, 20, 0, test::diffuse_material(Vec3f(float(k_albedo))));
  scene::Texture texture;
  texture.wrap_u = texture.wrap_v = scene::Wrap::clamp_to_edge;
  texture.nearest = true;
  image::Image picture(64, 64, 4);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      float* p = picture.pixel(x, y);
      p[0] = p[1] = p[2] = 1;
      p[3] = x >= 32 && y >= 32 ? 1.0f : outside;
    }
  texture.image = picture;
  scene.textures.push_back(texture);
  scene::Material glow = test::diffuse_material(Vec3f(0.5f));
  glow.emission = Vec3f(float(k_nits));
  glow.alpha_mode = mode;
  glow.base_color.w = factor;
  glow.base_color_texture.texture = 0;
  scene.materials.push_back(glow);
  scene::Mesh mesh;
  mesh.name = "panel";
  mesh.material = int(scene.materials.size()) - 1;
  mesh.positions = {{-1, 0.2f, -2}, {1, 0.2f, -2}, {1, 2.2f, -2}, {-1, 2.2f, -2}};
  mesh.tex_coord_0 = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.meshes.push_back(mesh);
  scene::Warnings warnings;
  for (const light::Lights& lights : scene::find_emissive_lights(scene, {}, warnings))
    light::append_lights(lights, scene.lights);
  CHECK(warnings.lines().empty());
  return scene;
}

// Radiance of the floor at the origin by a rectangle of the panel's plane.
double truth(double x0, double y0, double x1, double y1) {
  constexpr int n = 200;
  double sum = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Vec3d d(x0 + (x1 - x0) * (i + 0.5) / n, y0 + (y1 - y0) * (j + 0.5) / n, -2);
      const double r2 = dot(d, d);
      sum += d.y * -d.z / (r2 * r2);
    }
  return k_albedo / std::numbers::pi * k_nits * sum * (x1 - x0) * (y1 - y0) / (n * n);
}

double floor_radiance(const scene::Scene& scene, render::Integrator integrator, int samples) {
  render::RenderOptions options;
  options.width = options.height = 16;
  options.integrator = integrator;
  options.samples = samples;
  options.shadow_samples = samples;
  options.filter = render::PixelFilter::none;
  auto picture = render::render(scene, test::look_at({0, 2, 2}, {0, 0, 0}, 1e-3f),
                                table::builtin_ggx_table(), options);
  REQUIRE(picture.ok());
  double sum = 0;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      sum += double(picture->radiance.rgb(x, y).x);
  return sum / 256;
}

} // namespace

TEST_CASE("a glowing panel lights with what alpha leaves of it") {
  using scene::AlphaMode;
  const double whole = truth(-1, 0.2, 1, 2.2), open = truth(0, 0.2, 1, 1.2);
  struct Case {
    AlphaMode mode;
    float factor, outside;
    double expected;
  };
  for (const Case& c :
       {Case{AlphaMode::opaque, 0.25f, 0, whole}, Case{AlphaMode::mask, 1, 0.4f, open},
        Case{AlphaMode::mask, 0.4f, 0, 0}, Case{AlphaMode::mask, 0.6f, 1, whole},
        Case{AlphaMode::blend, 0.5f, 1, 0.5 * whole}, Case{AlphaMode::blend, 0.5f, 0, 0.5 * open},
        Case{AlphaMode::blend, 1, 0.25f, open + 0.25 * (whole - open)}}) {
    CAPTURE(int(c.mode));
    CAPTURE(c.factor);
    CAPTURE(c.outside);
    const scene::Scene scene = panel(c.mode, c.factor, c.outside);
    const double reference = floor_radiance(scene, render::Integrator::reference, 64);
    const double ltc = floor_radiance(scene, render::Integrator::ltc, 16);
    MESSAGE("truth ", c.expected, ", reference ", reference, ", LTC ", ltc);
    CHECK(reference == doctest::Approx(c.expected).epsilon(0.01));
    CHECK(ltc == doctest::Approx(c.expected).epsilon(0.04));
  }
}
