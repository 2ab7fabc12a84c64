// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Normals for meshes that come without, or with unusable ones.

#pragma once

#include "openltc/scene/scene.h"

#include <cstddef>

namespace openltc::scene {

/// Gives every triangle its own three vertices, all other arrays copied along, and its geometric
/// normal: what glTF asks for when a primitive has no normals.
void make_flat_normals(Mesh& mesh);

/// Replaces normals that are not finite or have no length by the area-weighted mean of the vertex's
/// triangles, and brings the others to unit length. Returns how many were replaced.
std::size_t repair_normals(Mesh& mesh);

/// Drops triangles with repeated corners or without area. Returns how many.
std::size_t drop_degenerate_triangles(Mesh& mesh);

} // namespace openltc::scene
