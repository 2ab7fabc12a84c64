// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the caller made of the parts of a scene. A file's own parts were checked when it was read.

#pragma once

#include "openltc/base/result.h"
#include "openltc/light/light.h"
#include "openltc/scene/scene.h"

#include <vector>

namespace openltc::python {

/// One line about the first field that rendering cannot use: not finite, too far away, negative, a
/// direction that is not unit, ring_ends that do not part the vertices.
Status check_lights(const light::Lights& lights);
Status check_materials(const std::vector<scene::Material>& materials); ///< the same
Status check_camera(const scene::Camera& camera);                      ///< the same

} // namespace openltc::python
