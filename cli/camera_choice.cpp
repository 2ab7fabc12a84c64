// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/camera_choice.h"

#include "openltc/render/view_choice.h"

#include <fmt/format.h>

#include <charconv>

namespace openltc::cli {

Result<scene::Camera> choose_camera(const scene::Scene& scene, const std::string& choice,
                                    const std::string& file, float aspect) {
  if (choice == "frame" || (choice.empty() && scene.cameras.empty()))
    return render::choose_view(scene, aspect);
  if (choice.empty()) return scene.cameras[0];
  for (const scene::Camera& camera : scene.cameras)
    if (camera.name == choice) return camera;
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(choice.data(), choice.data() + choice.size(), index);
  if (error == std::errc() && end == choice.data() + choice.size() && index < scene.cameras.size())
    return scene.cameras[index];
  std::string known = "\"frame\"";
  for (std::size_t i = 0; i < scene.cameras.size(); ++i)
    known += fmt::format(", {} \"{}\"", i, scene.cameras[i].name);
  return Error{fmt::format("{}: --camera {}: no such camera; there are {}", file, choice, known)};
}

} // namespace openltc::cli
