// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What follows from the outline of a polygon light: area, flux, validity.

#pragma once

#include "openltc/base/result.h"
#include "openltc/light/light.h"

#include <cstddef>
#include <span>

namespace openltc::light {

/// The vertices of ring `ring` (0 .. ring_end.size() - 1).
std::span<const Vec3f> ring_vertices(const PolygonLight& light, std::size_t ring);

/// Area in square metres of one ring along `normal`: positive when it runs counter-clockwise.
double signed_ring_area(std::span<const Vec3f> ring, Vec3f normal);

/// Area in square metres: outer rings minus holes.
double area(const PolygonLight& light);

/// Luminous flux in lumens per channel: exitance_per_radiance(light) L A.
Vec3f flux_lumens(const PolygonLight& light);

/// Whether the light can be shaded. The error names the light and what is wrong:
/// ring bounds, too few vertices, values that are not finite, a normal that is not unit,
/// vertices off the plane, negative radiance, no area.
Status validate(const PolygonLight& light);

} // namespace openltc::light
