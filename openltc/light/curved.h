// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Area, flux and validity of spheres and tubes.

#pragma once

#include "openltc/base/result.h"
#include "openltc/light/light.h"

namespace openltc::light {

/// Area in square metres of the emitting surface, one side.
double area(const SphereLight& light);
double area(const TubeLight& light);

/// Luminous flux in lumens per channel: exitance_per_radiance(light) L A.
Vec3f flux_lumens(const SphereLight& light);
Vec3f flux_lumens(const TubeLight& light);

/// Mean of cos^p, p = cosine_power, over what one sees from afar of a curved light, by projected
/// area: 2 / (p + 2) for a sphere; for a tube from the side gamma(p/2 + 1) sqrt(pi) / (2 gamma(p/2
/// + 3/2)). What shading multiplies the radiance by; exact from afar, where most light is.
float mean_emission(const SphereLight& light);
float mean_emission(const TubeLight& light);

/// Whether the light can be shaded. The error names the light and what is wrong: values that are
/// not finite, sizes that are not greater than zero, negative radiance.
Status validate(const SphereLight& light);
Status validate(const TubeLight& light);

} // namespace openltc::light
