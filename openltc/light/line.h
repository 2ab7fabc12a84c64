// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Flux and validity of lines.

#pragma once

#include "openltc/base/result.h"
#include "openltc/light/light.h"

namespace openltc::light {

/// Luminous flux in lumens per channel: a thin Lambertian tube of radiance L and diameter w has the
/// intensity per metre I = L w and the area pi w l, hence pi^2 I l.
Vec3f flux_lumens(const LineLight& light);

/// Whether the light can be shaded. The error names the light and what is wrong: values that are
/// not finite, no length, negative intensity.
Status validate(const LineLight& light);

} // namespace openltc::light
