// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A drawing that has no theme yet: lines, areas, text and pictures in inks that a light and a dark
// page show differently.

#pragma once

#include "openltc/base/result.h"
#include "openltc/image/image.h"
#include "openltc/target/vec.h"

#include <span>
#include <string>
#include <string_view>

namespace openltc::plot {

enum class Ink {
  none,
  ink,   ///< text and what matters
  soft,  ///< what may be overlooked
  rule,  ///< areas and grids
  paper, ///< the page
  blue,
  orange,
  green,
  pink,
  black, ///< these three are the same on every page: over pictures
  white,
  signal
};

struct Pen {
  Ink color = Ink::ink;
  double width = 1;
  const char* dash = ""; ///< lengths drawn and not, e.g. "5 3"
  double opacity = 1;
};

struct Fill {
  Ink color = Ink::rule;
  double opacity = 1;
  bool hatched = false;
};

enum class Anchor { start, middle, end };

struct TextStyle {
  double size = 12;
  Ink color = Ink::ink;
  Anchor anchor = Anchor::start;
  bool bold = false;
  bool monospaced = false;
};

struct Sketch {
  double width = 0, height = 0;
  std::string body; ///< SVG elements with the classes of the inks
};

/// Positions are rounded to a tenth of a unit. Lines have round ends.
void draw_path(Sketch& sketch, std::span<const Vec2d> points, const Pen& pen, bool closed = false);
void draw_shape(Sketch& sketch, std::span<const Vec2d> outline, const Fill& fill);
/// Round dots of diameter `pen.width`.
void draw_dots(Sketch& sketch, std::span<const Vec2d> places, const Pen& pen);

/// (x, y) is on the base line. In the text _{...} is lowered and *...* slanted.
void draw_text(Sketch& sketch, double x, double y, std::string_view text,
               const TextStyle& style = {});

/// A display-encoded picture of 4 channels, stretched into the rectangle. `few_colors` takes a
/// quarter of the bytes; colours that vary in more than one way then show steps.
Status draw_picture(Sketch& sketch, Vec2d corner, Vec2d size, const image::Image& display,
                    bool few_colors);

enum class Theme {
  automatic, ///< follows the reader's preference; no background
  light,
  dark
};

std::string to_svg(const Sketch& sketch, Theme theme);

} // namespace openltc::plot
