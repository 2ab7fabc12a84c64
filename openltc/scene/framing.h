// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A camera for scenes that come without.

#pragma once

#include "openltc/scene/scene.h"

namespace openltc::scene {

/// A perspective camera that looks at the middle of `bounds` from the front right and above, far
/// enough for all of it to be in a picture of `aspect` = width / height. Its shorter side spans 35
/// degrees. Empty bounds are taken as a cube of one metre.
Camera frame_scene(const Bounds& bounds, float aspect);

} // namespace openltc::scene
