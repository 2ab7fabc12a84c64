// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A mesh under a transform.

#pragma once

#include "openltc/scene/scene.h"
#include "openltc/scene/transform.h"

#include <span>
#include <utility>

namespace openltc::scene {

/// The box, as its lower and upper corner, around the box of `positions`, which are not empty, when
/// `to_world` has moved it.
std::pair<Vec3d, Vec3d> box_of(std::span<const Vec3f> positions, const Transform& to_world);

/// Moves `mesh` by `to_world`: normals stay of unit length and tangents perpendicular to them. A
/// mirroring transform turns the triangles' winding over. Triangles that lose their area are left
/// out, and `rounding` becomes what single precision loses of the positions.
void apply_transform(Mesh& mesh, const Transform& to_world);

} // namespace openltc::scene
