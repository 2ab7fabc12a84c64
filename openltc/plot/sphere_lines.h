// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lines and areas on the unit sphere, as points close enough to look smooth.

#pragma once

#include "openltc/target/vec.h"

#include <span>
#include <vector>

namespace openltc::plot {

/// From the direction of a to that of b on the shorter great circle, both ends included.
std::vector<Vec3d> great_arc(Vec3d a, Vec3d b);

/// The closed outline of a polygon seen from the origin: great circles from corner to corner; the
/// first point is also the last. corners: not on the origin.
std::vector<Vec3d> outline_on_sphere(std::span<const Vec3d> corners);

/// The circle of radius `radius` around `center` in the plane perpendicular to `normal`; the first
/// point is also the last.
std::vector<Vec3d> circle(Vec3d normal, double radius = 1, Vec3d center = {0, 0, 0});

/// A straight line, in parts short enough for cut_by_visibility.
std::vector<Vec3d> segment(Vec3d a, Vec3d b);

/// Outline of the directions w that the viewer sees of the half sphere normal.w >= 0: the half of
/// the sphere with towards.w >= 0. Unit normals, not parallel.
std::vector<Vec3d> seen_half(Vec3d normal, Vec3d towards);

} // namespace openltc::plot
