// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Where a node puts a light or a camera: position and rotation, and one number for the scale.

#pragma once

#include "openltc/scene/transform.h"

#include <string>

namespace openltc::scene::gltf {

struct Document;

/// Axes of the node in the world without scale, shear or mirroring; orthonormal.
struct Placement {
  Vec3d position{0, 0, 0};
  Vec3d right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1}; ///< x y z of the node
  double scale = 1; ///< the largest component of the node's scale, without its sign

  /// A point of the node's own space, all lengths times `scale`.
  Vec3d point(Vec3d local) const {
    return position + (right * local.x + up * local.y + back * local.z) * scale;
  }
};

/// Position and rotation of `to_world`. `what` stands for the light or camera in messages: a
/// warning when the node has no direction, a Failure when it lies outside the range of numbers.
Placement placement_of(const Transform& to_world, const std::string& what, Document& document);

} // namespace openltc::scene::gltf
