// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Facetted spheres, disks and cylinders, as modellers make them.

#pragma once

#include "openltc/scene/scene.h"

#include <cstdint>

namespace openltc::test {

/// An icosahedron of radius 1, each triangle cut into four `subdivisions` times.
scene::Mesh icosphere(int subdivisions);
/// Radius 1, `rings` from pole to pole; with doubled vertices at the seam. Only the part whose
/// polar angle is below `end_rad`.
scene::Mesh uv_sphere(std::uint32_t rings, std::uint32_t segments, double end_rad = 4);
/// A fan of radius `x` by `y` in the xy plane that faces +z.
scene::Mesh disk_mesh(std::uint32_t corners, double x = 1, double y = 1);
/// Radius 1 along x from 0 to `length`, facing outwards, with `ends` of them closed; `share` of the
/// full circle.
scene::Mesh cylinder_mesh(std::uint32_t corners, double length, int ends, double share = 1);
/// Both in one mesh, the second moved by `offset`.
scene::Mesh together(scene::Mesh a, const scene::Mesh& b, Vec3f offset);

/// Rotated about some axis, scaled by (sx, sy, sz) before, and moved.
scene::Mesh transformed(scene::Mesh mesh, double angle_rad, Vec3d scale, Vec3d offset);

} // namespace openltc::test
