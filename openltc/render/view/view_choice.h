// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A camera for a scene without: from where most of it is seen, and lit.

#pragma once

#include "openltc/base/result.h"
#include "openltc/scene/scene.h"

namespace openltc::render {

/// Tries views of the scene's subject (scene::find_subject) from all around and, where walls stand
/// in the way, from before those walls, and takes the one that shows most of it; near ties go to a
/// three-quarter view from slightly above. Seeing what light of scene.lights falls on counts more
/// than what lies in the dark. `aspect` is width / height. The result depends on nothing else.
/// Fails when the ray structure cannot be built.
Result<scene::Camera> choose_view(const scene::Scene& scene, float aspect);

} // namespace openltc::render
