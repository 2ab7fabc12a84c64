// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Drawing in a figure over pictures of solids: lines, areas and arrows of the space that they show,
// by the same projection.

#pragma once

#include "openltc/draw/figure.h"
#include "openltc/plot/solid_picture.h"
#include "openltc/plot/view.h"

#include <functional>
#include <span>

namespace openltc::plot {

/// A view at a place of a figure.
struct Space {
  View view;
  Vec2d center;     ///< where view.center lies, figure units
  double unit = 50; ///< figure units of one world unit
};

Vec2d place(const Space& space, Vec3d point);

/// Whether a point is seen or behind something.
using Visibility = std::function<bool(Vec3d)>;

/// A picture of solids in the space's window. `few_colors` takes a quarter of the bytes; colours
/// that vary in more than one way then show steps.
Status draw_solids(draw::Figure& figure, const Space& space, std::span<const Solid> solids,
                   int pixels, bool few_colors);

/// A line, of fine steps where what is in front of it is; hidden parts in a style of their own.
void draw_line(draw::Figure& figure, const Space& space, std::span<const Vec3d> points,
               const Visibility& is_visible, const draw::Pen& seen, const draw::Pen& hidden);

void draw_area(draw::Figure& figure, const Space& space, std::span<const Vec3d> outline,
               const draw::Pen& style);

/// An area without outline.
draw::Pen filled(const std::string& color, double opacity = 1);

/// A straight arrow; its head is fainter where the tip is hidden.
void draw_arrow(draw::Figure& figure, const Space& space, Vec3d from, Vec3d to,
                const Visibility& is_visible, const draw::Pen& seen, const draw::Pen& hidden);

} // namespace openltc::plot
