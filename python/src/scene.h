// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Scenes: what a file holds, and pictures of it.

#pragma once

#include "openltc/image/image.h"
#include "openltc/scene/scene.h"

#include <mutex>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <string>
#include <vector>

namespace openltc::python {

/// A scene of Python's, which is rendered by one thread at a time.
struct LoadedScene {
  scene::Scene scene;
  std::vector<std::string> files; ///< that were read or are named in it
  std::mutex in_use;
};

/// Height x width x channels, float32.
nanobind::object array_of_picture(image::Image picture);

/// Adds lights, cameras and materials of scenes.
void bind_scene_parts(nanobind::module_& m);
/// Adds loading and rendering.
void bind_scene(nanobind::module_& m);
/// Adds files of pictures and comparing.
void bind_pictures(nanobind::module_& m);

} // namespace openltc::python
