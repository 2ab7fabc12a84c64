// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The camera that --camera names.

#pragma once

#include "openltc/base/result.h"
#include "openltc/scene/scene.h"

#include <string>

namespace openltc::cli {

/// A number from 0, a name, or "frame" for a view of what the scene is of (render::choose_view);
/// empty is the first camera of the scene, or "frame" where it has none. `file` and what cameras
/// there are stand in the error.
Result<scene::Camera> choose_camera(const scene::Scene& scene, const std::string& choice,
                                    const std::string& file, float aspect);

} // namespace openltc::cli
