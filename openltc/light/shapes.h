// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Lights of simple shapes.

#pragma once

#include "openltc/light/light.h"

namespace openltc::light {

/// A rectangle around `center`. `half_right` and `half_up` reach from the centre to the middle of
/// two neighbouring sides and are perpendicular; it emits along normalize(half_right x half_up).
PolygonLight rectangle(Vec3f center, Vec3f half_right, Vec3f half_up, Vec3f radiance);

/// A flat ellipse around `center` with these perpendicular semi-axes, a disk when they are equally
/// long; it emits along half_right x half_up.
EllipseLight ellipse(Vec3f center, Vec3f half_right, Vec3f half_up, Vec3f radiance);

} // namespace openltc::light
