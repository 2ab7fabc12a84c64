// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The outline of a set of triangles that lie in one plane.

#pragma once

#include "openltc/target/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace openltc::scene {

using Ring = std::vector<Vec3d>;

/// Closed rings around `triangles`, which index `points`, lie in one plane and run
/// counter-clockwise about the unit `normal`. Outer rings come first and run counter-clockwise,
/// holes follow and run clockwise; no ring visits a vertex twice. Vertices within `tolerance`
/// (metres) of an edge lie on it; corners within `straight` of an edge without them are left out.
///
/// The rings' signed areas sum up to that of the triangles, but for what left out corners cost.
/// Where triangles overlap or do not fit together, so that no such outline exists, each triangle is
/// its own ring; the sum, and with it every integral over the rings, is right in any case. Empty
/// when there is no area.
std::vector<Ring> trace_outline(std::span<const Vec3d> points,
                                std::span<const std::array<std::uint32_t, 3>> triangles,
                                Vec3d normal, double tolerance, double straight);
inline std::vector<Ring> trace_outline(std::span<const Vec3d> points,
                                       std::span<const std::array<std::uint32_t, 3>> triangles,
                                       Vec3d normal, double tolerance) {
  return trace_outline(points, triangles, normal, tolerance, tolerance);
}

/// Half the sum of cross products along `normal`: positive when counter-clockwise.
double signed_area(const Ring& ring, Vec3d normal);

} // namespace openltc::scene
