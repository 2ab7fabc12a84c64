// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A node that carries a light and a mesh: a lamp.

#pragma once

#include "openltc/scene/scene.h"
#include "openltc/scene/warnings.h"

#include <span>
#include <string>
#include <vector>

namespace openltc::scene::gltf {

/// Makes `meshes`, of the node that messages call `label`, show the node's `light`, one alone:
/// their emission makes no lights, and the light learns how far its mesh leaves it, where shadow
/// rays stop. A mesh that is something else is named in a warning, and may shadow the light.
void attach_mesh(const std::string& label, std::span<Mesh> meshes,
                 const std::vector<Material>& materials, light::Lights& light, Warnings& warnings);

} // namespace openltc::scene::gltf
