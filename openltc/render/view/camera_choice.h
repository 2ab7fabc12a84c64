// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The camera that a user names.

#pragma once

#include "openltc/base/result.h"
#include "openltc/scene/scene.h"

#include <string>

namespace openltc::render {

/// A number from 0, a name, or "frame" for a view of what the scene is of (choose_view);
/// empty is the first camera of the scene, or "frame" where it has none. `aspect` is that of
/// choose_view. The error says what cameras there are.
Result<scene::Camera> choose_camera(const scene::Scene& scene, const std::string& choice,
                                    float aspect);

} // namespace openltc::render
