// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Animations: glTF 2.0 specification, section 3.11.

#pragma once

#include "openltc/scene/gltf/hierarchy.h"
#include "openltc/scene/pose.h"
#include "openltc/scene/scene.h"

#include <vector>

namespace openltc::scene::gltf {

struct Document;

/// What the file's animations make of its nodes at the moment that `options` ask for: one pose for
/// each node, or none when nothing is asked for. Fills `animations` with those that can be read; a
/// warning names each other one, a channel that cannot be used, and animations that nobody asked
/// for. Throws Failure when there is no animation of the name that is asked for.
std::vector<NodePose> read_pose(Document& document, const PoseOptions& options,
                                std::vector<Animation>& animations);

} // namespace openltc::scene::gltf
