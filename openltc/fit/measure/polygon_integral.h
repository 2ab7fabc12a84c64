// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The integral of a BRDF, and of a lobe, over a polygon seen from the shaded point.

#pragma once

#include "openltc/brdf/brdf.h"
#include "openltc/target/shade_f64.h"

#include <span>

namespace openltc::fit {

/// Accuracy of integrate_brdf_over_polygon.
struct PolygonRule {
  int radial = 28;         ///< points from the lobe's centre outwards, 4..64
  double tolerance = 1e-6; ///< of each azimuth interval, on an integral of at most 1
};

/// Integral of f cos_i (F = 1) over the directions in which a convex polygon is seen; what lies
/// below the surface's horizon does not count, and both of the polygon's sides do.
///
/// corners: shading space, the shaded point at the origin, either winding, all in one plane that
/// does not hold the origin. cos_theta: of the view direction, 0 < cos_theta <= 1.
/// scale: as find_half_vectors gives it (quadrature.h).
/// Not checked for NaN: make_quadrature has refused such a BRDF before. Error: below 2e-5 of the
/// albedo for GGX of roughness .06-1 (tests/fit/test_tv_bound.cpp).
double integrate_brdf_over_polygon(const brdf::Brdf& brdf, double roughness, double cos_theta,
                                   double scale, std::span<const Vec3d> corners,
                                   const PolygonRule& rule = {});

/// Integral of the lobe over the same polygon in closed form, both horizons respected, 0..1.
double integrate_lobe_over_polygon(const f64::Lobe& lobe, std::span<const Vec3d> corners);

} // namespace openltc::fit
