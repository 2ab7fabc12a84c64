// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A camera for scenes that come without.

#pragma once

#include "openltc/scene/scene.h"

namespace openltc::scene {

/// A three-quarter view from slightly above that shows the whole scene, filling the picture but for
/// a small rim; 35 degrees over the shorter side. A scene that is flat along Z, a chart or a
/// picture, is seen from the front instead. `aspect` is width / height.
Camera frame_scene(const Scene& scene, float aspect);

/// The same for a box of which nothing else is known.
Camera frame_scene(const Bounds& bounds, float aspect);

} // namespace openltc::scene
