// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Area, flux and validity of ellipses.

#pragma once

#include "openltc/base/result.h"
#include "openltc/light/light.h"

namespace openltc::light {

/// Area in square metres, one side.
double area(const EllipseLight& light);

/// Luminous flux in lumens per channel: exitance_per_radiance(light) L A.
Vec3f flux_lumens(const EllipseLight& light);

/// Whether the light can be shaded. The error names the light and what is wrong: values that are
/// not finite, semi-axes of no length or not perpendicular, negative radiance.
Status validate(const EllipseLight& light);

} // namespace openltc::light
