// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Skins: glTF 2.0 specification, section 3.7.3.

#pragma once

#include "openltc/scene/transform.h"

#include <cstddef>
#include <span>
#include <vector>

namespace openltc::scene::gltf {

struct Document;

/// For each joint of skins[skin] the transform from the mesh in which it is bound to the world:
/// that of the joint's node, of which `to_world` holds those of all nodes, times the inverse bind
/// matrix. Throws Failure when the skin cannot be used.
std::vector<Transform> joint_transforms(const Document& document, std::size_t skin,
                                        std::span<const Transform> to_world);

} // namespace openltc::scene::gltf
