// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Integrals of a lobe in shading space by quadrature: what the closed forms are checked against.

#pragma once

#include "openltc/target/shade_f64.h"

#include <span>

namespace openltc::plot {

/// Integrals of D and of w D.
struct LobeMoments {
  double mass = 0;
  Vec3d first{0, 0, 0}; ///< shading space
};

/// Over the whole sphere.
LobeMoments integrate_over_sphere(const f64::Lobe& lobe);

/// Over the directions of a planar polygon around which D is positive, that is, above the cosine's
/// horizon; either winding, counted positive. corners: shading space, the shaded point at the
/// origin and not in their plane.
LobeMoments integrate_over_polygon(const f64::Lobe& lobe, std::span<const Vec3d> corners);

} // namespace openltc::plot
