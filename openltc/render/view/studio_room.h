// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The studio rig where it can be seen: around the subject, or within the room that encloses it.

#pragma once

#include "openltc/base/result.h"
#include "openltc/scene/scene.h"

namespace openltc::render {

/// The rig of scene::studio_lights around the scene's subject, its ground and sky left out of
/// account. Where walls keep it from the subject, one soft box under the ceiling instead, as bright
/// on a white card in the middle of the room that faces it. Fails when the ray structure cannot be
/// built.
Result<light::Lights> studio_for(const scene::Scene& scene, const scene::Camera& camera,
                                 double white_nits);

} // namespace openltc::render
