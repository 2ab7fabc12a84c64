// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Axes, curves, maps of colours and their scales.

#pragma once

#include "openltc/draw/figure.h"
#include "openltc/image/colormap.h"

#include <string>
#include <vector>

namespace openltc::draw {

struct Tick {
  double value = 0;
  std::string label;
};

/// One axis. `to` may lie below `from`; both are above 0 when logarithmic.
struct Axis {
  std::string label; ///< with its unit: "view angle θ (degrees)"
  double from = 0, to = 1;
  bool logarithmic = false;
  std::vector<Tick> ticks; ///< empty: chosen by ticks_of
};

/// Round values within the axis, about `count`; powers of ten on a logarithmic one.
std::vector<Tick> ticks_of(const Axis& axis, int count = 5);

/// Share of the way along an axis, 0 at `from`, 1 at `to`; beyond for values beyond.
double share_along(const Axis& axis, double value);

/// A rectangle of a figure with axes.
struct Panel {
  std::string title;
  Vec2d corner{0, 0}; ///< of the plotting area, figure units; labels lie outside of it
  Vec2d size{200, 150};
  Axis x, y;
};

/// Where a pair of values lies in the figure.
Vec2d place_in(const Panel& panel, double x, double y);

/// Frame, ticks, labels and title; with lines across where `grid`.
void draw_axes(Figure& figure, const Panel& panel, bool grid = true);

/// A curve of a panel. Series 0 to 3 differ in colour and in dashes; what is not finite leaves a
/// gap.
struct Curve {
  std::string label;
  std::vector<Vec2d> points; ///< values
  int series = 0;
};

void draw_curves(Figure& figure, const Panel& panel, std::span<const Curve> curves);

/// Labels beside short pieces of the curves, one below the other from `place`.
void draw_legend(Figure& figure, Vec2d place, std::span<const Curve> curves);

/// A picture of values in the colours of a map, `from` and `to` at its ends. Row 0 is the top; what
/// is not finite is transparent.
image::Image color_values(std::span<const double> values, int columns, int rows,
                          image::Colormap map, double from, double to);

/// A colour scale: upright from bottom to top, or lying from left to right when it is wider than it
/// is high, with the axis's ticks and label.
Status draw_color_bar(Figure& figure, Vec2d corner, Vec2d size, image::Colormap map,
                      const Axis& axis);

} // namespace openltc::draw
