// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The heart of the method in numbers: the integral of a lobe D over a polygon P is that of the
// cosine D_o over M^-1 P, and whatever sample lies in the one lies in the other.

#pragma once

#include "openltc/base/result.h"
#include "openltc/target/shade_f64.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace openltc::plot {

/// A polygon, samples and integrals in one of the two spaces.
struct PolygonSpace {
  std::vector<Vec3d> corners; ///< of the whole polygon
  std::vector<Vec3d> kept;    ///< of the part above both horizons
  std::vector<Vec3d> samples; ///< unit
  std::vector<bool> inside;   ///< whether each sample lies in the kept part, found in this space
  int inside_count = 0;
  double integral = 0;
};

struct PolygonEquivalence {
  /// The lobe's; its integral is by quadrature of D (lobe_quadrature.h).
  PolygonSpace shading;
  /// The cosine's; its integral is the closed form, Lambert's edge sum.
  PolygonSpace cosine;
  Vec3d horizon_normal_cosine{0, 0, 1};  ///< of the surface, where M^-1 takes it
  Vec3d horizon_normal_shading{0, 0, 1}; ///< of the cosine's horizon, where M takes it
};

struct PolygonSampling {
  int samples = 400;
  std::uint32_t seed = 0;
};

/// corners: shading space, the shaded point at the origin; three or more, finite, in one plane that
/// does not hold the origin, simple; either winding, convex or not. At least a part must lie above
/// the surface's horizon z = 0 and above the cosine's. The error begins with `name`, e.g.
/// "--points".
Result<PolygonEquivalence> compare_spaces(const f64::Lobe& lobe, std::span<const Vec3d> corners,
                                          const std::string& name,
                                          const PolygonSampling& sampling = {});

/// The part of a polygon on the side of the plane through the origin to which `normal` points.
std::vector<Vec3d> clip_to_plane(std::span<const Vec3d> corners, Vec3d normal);

/// Whether the ray from the origin along `direction` meets the polygon; one with a plane as above.
bool ray_meets_polygon(std::span<const Vec3d> corners, Vec3d direction);

} // namespace openltc::plot
