// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Alpha from two pictures, of the same solids on black and on white: with coverage A and the
// solids' share S of a pixel they hold S and S + (1 - A), so A is 1 less their difference, and the
// colour is S / A (A. R. Smith, J. F. Blinn 1996, "Blue Screen Matting", section 4.3, for two grey
// backgrounds).

#include "openltc/plot/solid_picture.h"

#include "openltc/image/file.h"
#include "openltc/light/shapes.h"
#include "openltc/render/renderer.h"
#include "openltc/table/lobe_table.h"

#include <algorithm>
#include <cmath>

namespace openltc::plot {

namespace {

struct SoftBox {
  double right, up, towards; // where it stands, seen by the viewer
  double half_side;
  double radiance;
};

// A large key from above on the left, weaker fills from the right and from below, and one behind
// that lights the edge. Distances in halves of the window's longer side; radiance so that a white
// card which faces the key is nearly white.
constexpr SoftBox k_soft_boxes[] = {{-3.0, 4.0, 4.0, 3.0, 2.6},
                                    {5.0, 0.5, 3.5, 3.0, 1.5},
                                    {2.5, 3.0, -4.5, 2.5, 1.6},
                                    {-1.0, -5.0, 1.5, 3.0, 1.2}};

light::Lights lights_of(const View& view) {
  light::Lights lights;
  const double unit = std::max(view.half_width, view.half_height);
  for (const SoftBox& box : k_soft_boxes) {
    const Vec3d offset = view.right * box.right + view.up * box.up + view.towards * box.towards;
    const Vec3d back = -normalize(offset); // where it shines
    const Vec3d right = normalize(cross(view.up + view.right * 0.1, back));
    const Vec3d up = cross(back, right);
    lights.polygons.push_back(light::rectangle(
        to_float(view.center + offset * unit), to_float(right * (box.half_side * unit)),
        to_float(up * (box.half_side * unit)), Vec3f(float(box.radiance))));
  }
  return lights;
}

scene::Scene scene_of(std::span<const Solid> solids, const View& view) {
  scene::Scene scene;
  for (const Solid& solid : solids) {
    scene::Material material;
    material.metallic = 0;
    material.roughness = 0.55f;
    material.unlit = solid.finish == Finish::plain;
    material.double_sided = true;
    scene.materials.push_back(material);
    scene.meshes.push_back(solid.mesh);
    scene.meshes.back().material = int(scene.materials.size()) - 1;
  }
  scene.lights = lights_of(view);
  return scene;
}

} // namespace

Result<image::Image> render_solids(std::span<const Solid> solids, const View& view,
                                   const SolidPictureOptions& options) {
  const scene::Scene scene = scene_of(solids, view);
  render::RenderOptions render_options;
  render_options.width = options.width;
  render_options.height =
      std::max(1, int(std::lround(options.width * view.half_height / view.half_width)));
  render_options.samples = options.samples;
  render_options.shadow_samples = 0;
  render_options.light_error = 0;
  render_options.kernel = "scalar"; // the same bits whatever the machine's instruction set
  render_options.threads = options.threads;
  const scene::Camera camera = camera_of(view);
  const auto on = [&](float background) {
    render_options.background = Vec3f(background);
    return render::render(scene, camera, table::builtin_ggx_table(), render_options);
  };
  const Result<render::Picture> black = on(0), white = on(1);
  if (!black) return black.error();
  if (!white) return white.error();

  image::Image picture(render_options.width, render_options.height, 4);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const Vec3f solid = black->radiance.rgb(x, y), both = white->radiance.rgb(x, y);
      const float alpha = std::clamp(1 - (both.y - solid.y), 0.0f, 1.0f);
      float* pixel = picture.pixel(x, y);
      // What covers less than a 512th is nothing in eight bits.
      if (alpha < 1.0f / 512) continue;
      for (int c = 0; c < 3; ++c)
        pixel[c] =
            image::srgb_from_linear(std::clamp(black->radiance.pixel(x, y)[c] / alpha, 0.0f, 1.0f));
      pixel[3] = alpha;
    }
  return picture;
}

} // namespace openltc::plot
