// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Tangents for normal maps of meshes that come without.

#pragma once

#include "openltc/scene/scene.h"

namespace openltc::scene {

/// Fills mesh.tangents from texture coordinate set `tex_coord` (0 or 1), which must not be empty,
/// and the normals. Vertices that mirrored and unmirrored triangles share are doubled, so that the
/// mesh may grow.
void compute_tangents(Mesh& mesh, int tex_coord);

/// Brings tangents to unit length and perpendicular to the normals, which are of unit length, and
/// their w to 1 or -1. False if one of them has no direction there: then mesh.tangents is empty.
bool repair_tangents(Mesh& mesh);

} // namespace openltc::scene
