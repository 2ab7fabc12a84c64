// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// One of the two spaces of the figure of a polygon: the sphere of directions with the polygon, both
// horizons and the samples.

#pragma once

#include "openltc/plot/polygon_equivalence.h"
#include "openltc/plot/space_drawing.h"

#include <optional>

namespace openltc::plot {

struct PolygonPanel {
  const PolygonSpace& polygon;
  f64::Lobe lobe;        ///< whose density colours the sphere
  double peak = 1;       ///< 1/steradian: the end of the colour map
  Vec3d surface_horizon; ///< unit, to the side that counts; of the same space
  Vec3d cosine_horizon;
  std::optional<Vec3d> wo; ///< unit; drawn where it is known
};

/// Where to look at both spaces from: the parts of the polygon that count are in front, and the
/// lobe, whose mean direction is given, is not behind.
View polygon_view(const PolygonEquivalence& spaces, Vec3d lobe_direction);

/// Draws the panel around `center`, the sphere `radius` figure units large.
Status draw_polygon_panel(draw::Figure& figure, const View& view, Vec2d center, double radius,
                          const PolygonPanel& panel);

/// The fill of what is cut off, once it is defined in the figure.
inline constexpr const char* k_hatch = "url(#hatch)";
void define_hatch(draw::Figure& figure);

/// A dot as the panels draw samples, for their key.
void draw_sample_sign(draw::Figure& figure, Vec2d at, bool inside);

} // namespace openltc::plot
