// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Polygon lights of simple shapes.

#pragma once

#include "openltc/light/light.h"

namespace openltc::light {

/// A rectangle around `center`. `half_right` and `half_up` reach from the centre to the middle of
/// two neighbouring sides and are perpendicular; it emits along normalize(half_right x half_up).
PolygonLight rectangle(Vec3f center, Vec3f half_right, Vec3f half_up, Vec3f radiance);

/// Corners of the polygon that stands for a disk.
inline constexpr int k_disk_corners = 64;

/// A disk around `center` as a regular polygon of k_disk_corners corners and exactly the disk's
/// area, so that its flux is right; its outline leaves the circle by at most 0.08 % of the radius.
/// `right` and `up` are orthonormal; it emits along right x up.
PolygonLight disk(Vec3f center, Vec3f right, Vec3f up, float radius, Vec3f radiance);

} // namespace openltc::light
