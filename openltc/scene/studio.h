// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Lights for scenes that come without.

#pragma once

#include "openltc/scene/scene.h"

namespace openltc::scene {

/// The exposure that the studio's lights are made for: a normal to the key light at the middle of
/// the scene receives what exposes a mid-grey surface as mid-grey at this EV100.
inline constexpr float k_studio_ev100 = 9.0f;

/// Three soft boxes around `bounds` as seen from `camera`: a large key from the upper left, a
/// weaker fill from the right, a rim light from behind and above. They stand outside the bounds'
/// sphere, are one-sided, face its centre, and grow with it, so that the light in the scene does
/// not depend on its size.
light::Lights studio_lights(const Bounds& bounds, const Camera& camera);

} // namespace openltc::scene
