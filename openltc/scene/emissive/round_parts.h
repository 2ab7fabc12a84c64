// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Parts of an emissive mesh that are round become round lights.

#pragma once

#include "openltc/light/light.h"
#include "openltc/scene/emissive/surface_emission.h"
#include "openltc/scene/weld.h"

namespace openltc::scene {

/// Adds the islands of `welded`, the welded `mesh`, that are round within `tolerance` (of their
/// diameter) to `lights`, with the mean of their emission, and returns what is left. Sets
/// `is_averaged` where that emission is not the same all over.
WeldedMesh take_round_parts(const WeldedMesh& welded, const Mesh& mesh, const Extent& extent,
                            bool two_sided, double tolerance, const SurfaceEmission& emission,
                            light::Lights& lights, bool& is_averaged);

} // namespace openltc::scene
