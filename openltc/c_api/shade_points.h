// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The inner loops of openltc_shade and openltc_shade_parts: all lights at a range of points.

#pragma once

#include "openltc/c_api/handles.h"
#include "openltc/openltc_c.h"

#include <cstddef>

namespace openltc::c_api {

/// Writes the reflected radiance of points [begin, end), at most k_points_per_part of them, 3
/// floats each at 3 * their index: by shade_batch, in lanes. All arguments have been checked; what
/// shade_batch finds wrong all the same is thrown as std::logic_error.
void shade_points(const openltc_lobes& lobes, const openltc_lights& lights,
                  const openltc_points& points, std::size_t begin, std::size_t end,
                  float* radiance);

/// The same apart, by shade_parts(), point by point.
void shade_parts_of_points(const openltc_lobes& lobes, const openltc_lights& lights,
                           const openltc_points& points, std::size_t begin, std::size_t end,
                           float* diffuse, float* specular);

} // namespace openltc::c_api
