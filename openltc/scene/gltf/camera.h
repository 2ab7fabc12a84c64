// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Cameras that nodes carry.

#pragma once

#include "openltc/scene/scene.h"
#include "openltc/scene/transform.h"

#include <string>

namespace openltc::scene::gltf {

struct Document;

/// cameras[index], placed by `to_world`. Throws Failure for values that give no picture.
Camera read_camera(Document& document, int index, const Transform& to_world,
                   const std::string& node_name);

} // namespace openltc::scene::gltf
