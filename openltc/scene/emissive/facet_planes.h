// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Triangles that lie in one plane, and such planes that are nearly one.

#pragma once

#include "openltc/scene/weld.h"

#include <array>
#include <cstdint>
#include <vector>

namespace openltc::scene {

/// Triangles of one plane, all counter-clockwise about the plane's normal.
struct FacetPlane {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> members; ///< of the welded mesh, as many
};

/// Takes the largest triangle that is left, collects everything whose corners lie within
/// extent.plane of its plane and whose normal is within `angle_rad` of its normal, and goes on with
/// the rest. Of triangles in the same place one is kept. With `two_sided` it does not matter which
/// side a triangle was drawn from.
std::vector<FacetPlane> find_planes(const WeldedMesh& mesh, const Extent& extent, double angle_rad,
                                    bool two_sided);

/// What planes may be joined into: no corner further from the joined plane than `distance` metres,
/// no normal further from its normal than `angle_rad`, and radiances (one for each plane) within
/// `radiance` of the brightest, a fraction.
struct JoinLimits {
  double distance = 0;
  double angle_rad = 0;
  double radiance = 0;
};

/// Joins planes that share edges, as long as the limits hold, those that lose least first. In each
/// result the triangles are counter-clockwise about the mean normal. Near-linear in their number.
std::vector<FacetPlane> join_planes(const WeldedMesh& mesh, std::vector<FacetPlane> planes,
                                    const std::vector<Vec3f>& radiances, const JoinLimits& limits,
                                    bool two_sided);

} // namespace openltc::scene
