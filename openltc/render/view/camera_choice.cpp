// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/view/camera_choice.h"

#include "openltc/base/quote.h"
#include "openltc/render/view/view_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace openltc::render {

Result<scene::Camera> choose_camera(const scene::Scene& scene, const std::string& choice,
                                    float aspect) {
  if (choice == "frame" || (choice.empty() && scene.cameras.empty()))
    return choose_view(scene, aspect);
  if (choice.empty()) return scene.cameras[0];
  for (const scene::Camera& camera : scene.cameras)
    if (camera.name == choice) return camera;
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(choice.data(), choice.data() + choice.size(), index);
  if (error == std::errc() && end == choice.data() + choice.size() && index < scene.cameras.size())
    return scene.cameras[index];
  std::string known = "\"frame\"";
  constexpr std::size_t k_most_named = 12;
  for (std::size_t i = 0; i < std::min(scene.cameras.size(), k_most_named); ++i)
    known += fmt::format(", {} \"{}\"", i, quote(scene.cameras[i].name));
  if (scene.cameras.size() > k_most_named)
    known += fmt::format(" and {} more", scene.cameras.size() - k_most_named);
  return Error{"no such camera; there are " + known};
}

} // namespace openltc::render
