// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The inner loop of openltc_shade: all lights at a range of points.

#pragma once

#include "openltc/c_api/handles.h"
#include "openltc/openltc_c.h"

#include <cstddef>

namespace openltc::c_api {

/// Writes the reflected radiance of points [begin, end), 3 floats each at 3 * their index: of
/// shade() over the lights in their order. All arguments have been checked.
void shade_points(const openltc_lobes& lobes, const openltc_lights& lights,
                  const openltc_points& points, std::size_t begin, std::size_t end,
                  float* radiance);

/// The same apart, as shade_parts() has it.
void shade_points(const openltc_lobes& lobes, const openltc_lights& lights,
                  const openltc_points& points, std::size_t begin, std::size_t end, float* diffuse,
                  float* specular);

} // namespace openltc::c_api
