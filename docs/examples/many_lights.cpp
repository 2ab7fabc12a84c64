// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Five hundred lamps over a floor: the renderer as a library, which leaves out or takes in groups
// what cannot be told from shading every lamp.
//
//   many_lights [FILE.png]   prints what that saves and what it errs, and writes the picture
//
// Needs the libraries openltc::render and openltc::image (C++20).

#include "openltc/image/display.h"
#include "openltc/light/shapes.h"
#include "openltc/render/renderer.h"
#include "openltc/table/lobe_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace openltc;

namespace {

/// A floor of 40 m by 40 m under 500 small square lamps of many colours.
scene::Scene hall() {
  scene::Scene scene;
  scene::Material varnish;
  varnish.base_color = {0.5f, 0.45f, 0.4f, 1};
  varnish.metallic = 0;
  varnish.roughness = 0.3f;
  scene.materials = {varnish};
  scene::Mesh floor;
  floor.material = 0;
  floor.positions = {{-20, 0, -20}, {-20, 0, 20}, {20, 0, 20}, {20, 0, -20}};
  floor.normals.assign(4, {0, 1, 0});
  floor.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.meshes = {floor};
  for (int i = 0; i < 500; ++i) {
    const float x = float(i % 25) * 1.6f - 19.2f, z = float(i / 25) * 2 - 19;
    const float hue = float(i) * 0.618f;
    const Vec3f color(1.2f + std::sin(hue), 1.2f + std::sin(hue + 2), 1.2f + std::sin(hue + 4));
    scene.lights.polygons.push_back(
        light::rectangle({x, 2, z}, {0.15f, 0, 0}, {0, 0, 0.15f}, color * 50.0f));
  }
  scene::Camera camera;
  camera.position = {0, 5, 24};
  camera.forward = {0, -0.2425356f, -0.9701425f};
  camera.up = {0, 0.9701425f, -0.2425356f};
  scene.cameras = {camera};
  return scene;
}

} // namespace

int main(int argc, char** argv) {
  const scene::Scene scene = hall();
  render::RenderOptions options;
  options.width = 320;
  options.height = 180;
  options.samples = 1;
  options.shadow_samples = 0;
  const auto picture = render::render(scene, scene.cameras[0], table::builtin_ggx_table(), options);
  options.light_error = 0; // every lamp at every point
  const auto all = render::render(scene, scene.cameras[0], table::builtin_ggx_table(), options);
  if (!picture.ok() || !all.ok()) {
    std::fprintf(stderr, "many_lights: %s\n",
                 (picture.ok() ? all : picture).error().message.c_str());
    return 1;
  }
  float error = 0, brightest = 0;
  for (std::size_t i = 0; i < all->radiance.data.size(); ++i) {
    error = std::max(error, std::abs(picture->radiance.data[i] - all->radiance.data[i]));
    brightest = std::max(brightest, all->radiance.data[i]);
  }
  std::printf("of %zu lamps a point is shaded by %.1f and %.1f groups; largest error %.5f nits, of "
              "%.5f allowed, where the brightest is %.2f\n",
              scene.lights.area_light_count(), picture->lights_per_point,
              picture->far_groups_per_point, double(error), picture->light_error_nits,
              double(brightest));
  if (argc < 2) return 0;
  const float exposure = image::auto_exposure(picture->radiance);
  const Status written =
      image::write_picture(argv[1], picture->radiance, nullptr, exposure, image::Tonemap::neutral,
                           image::ExrPrecision::half_float);
  if (!written.ok()) std::fprintf(stderr, "many_lights: %s\n", written.error().message.c_str());
  return written.ok() ? 0 : 1;
}
