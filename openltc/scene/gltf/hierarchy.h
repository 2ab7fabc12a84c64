// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The tree of nodes, and where each node is: glTF 2.0 specification, section 3.5.

#pragma once

#include "openltc/scene/transform.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace openltc::scene::gltf {

struct Document;

/// What an animation makes of a node; what is missing stays as the file has it.
struct NodePose {
  std::optional<Vec3d> translation;
  std::optional<std::array<double, 4>> rotation; ///< quaternion x y z w
  std::optional<Vec3d> scale;
  std::optional<std::vector<double>> weights; ///< of the mesh's morph targets
};

struct Hierarchy {
  std::vector<Transform> to_world; ///< of each node of the file, in the file's coordinates
  std::vector<int> placed;         ///< nodes of the scene, parents before their children
};

/// The nodes in `pose`, one for each node of the file or none at all. Throws Failure when nodes do
/// not form trees, or one stands in two places.
Hierarchy read_hierarchy(Document& document, std::span<const NodePose> pose);

} // namespace openltc::scene::gltf
