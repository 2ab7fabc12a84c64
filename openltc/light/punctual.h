// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Validity of lights without extent.

#pragma once

#include "openltc/base/result.h"
#include "openltc/light/light.h"

namespace openltc::light {

/// Whether the light can be shaded. The error names the light and what is wrong: values that are
/// not finite, negative intensity or range, axes that are not unit, cones the wrong way round.
Status validate(const PunctualLight& light);

} // namespace openltc::light
