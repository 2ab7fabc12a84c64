// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A program that renders: consumer SCENE.glb takes a small picture of a glTF scene.

#include "openltc/batch.h"
#include "openltc/render/renderer.h"
#include "openltc/render/view/camera_choice.h"
#include "openltc/scene/gltf.h"
#include "openltc/table/lobe_table.h"

#include <cmath>
#include <cstdio>

using namespace openltc;

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const Result<scene::Scene> scene = scene::load_gltf(argv[1]);
  if (!scene) return std::printf("%s\n", scene.error().message.c_str()), 1;
  const Result<scene::Camera> camera = render::choose_camera(*scene, "", 16.0f / 9);
  if (!camera) return std::printf("%s\n", camera.error().message.c_str()), 1;
  render::RenderOptions options;
  options.width = 32;
  options.height = 18;
  const Result<render::Picture> picture =
      render::render(*scene, *camera, table::builtin_ggx_table(), options);
  if (!picture) return std::printf("%s\n", picture.error().message.c_str()), 1;
  double sum = 0;
  for (float nits : picture->radiance.data)
    sum += nits;
  std::printf("%zu polygon lights, mean %.3f nits\n", scene->lights.polygons.size(),
              sum / (3 * 32 * 18));
  return std::isfinite(sum) && sum > 0 ? 0 : 1;
}
