// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Whether a large part of a scene is what the rest stands before: a ground, a wall, a sky, a room.

#pragma once

#include "openltc/scene/view/subject.h"

namespace openltc::scene {

/// Half the cross product of the edges: along the front's normal, as long as the area in
/// square metres.
Vec3d area_vector(const Mesh& mesh, std::uint32_t triangle);

/// Unit normal along which, forwards or backwards, most of the area faces; (0, 0, 0) where less
/// than nine tenths of it do (the share is the largest eigenvalue of the mean of n nT).
Vec3d common_normal(const Scene& scene, const std::vector<SubjectPart>& parts);

/// Whether `part` is thin and the middle of `rest` lies before or behind it, while `rest` stands
/// out of its plane; or, where it is not thin, whether from the middle of `rest` at least two
/// fifths of all directions meet the part on a side that can be seen. The caller has found it to be
/// much larger than `rest`.
bool is_backdrop(const Scene& scene, const SubjectPart& part, const Bounds& rest);

} // namespace openltc::scene
