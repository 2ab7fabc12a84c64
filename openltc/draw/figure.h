// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A figure: a drawing in vectors and text, with pictures in it, that is written as SVG or PNG.
//
// Colours are named by what they are for, so that one drawing serves light and dark pages:
//   "ink" lines and text, "soft" what explains, "rule" grids, "paper" the background,
//   "series0" .. "series3" curves, told apart by colour-blind readers too,
//   "#rrggbb" what is the same on both, "none".
// Lengths are in pixels of the figure, y downwards.

#pragma once

#include "openltc/base/result.h"
#include "openltc/draw/palette.h"
#include "openltc/image/image.h"
#include "openltc/target/vec.h"

#include <span>
#include <string>

namespace openltc::draw {

/// Whose colours: those of the reader's page (CSS prefers-color-scheme), or given ones.
enum class Theme { automatic, light, dark };

struct Pen {
  std::string color = "ink"; ///< of the line
  double width = 1;
  std::string dash{}; ///< as SVG has it, "4 3"; empty: solid
  double opacity = 1;
  std::string fill = "none";
  double fill_opacity = 1;
};

enum class Anchor { start, middle, end };

struct Type {
  double size = 12;
  Anchor anchor = Anchor::start;
  std::string color = "ink";
  bool bold = false;
  bool italic = false;
  double turn_degrees = 0; ///< about its place; -90 reads upwards
  bool marked = false;     ///< *...* is slanted, _{...} lowered
};

struct Figure {
  std::string title;
  std::string caption; ///< what one sees; the command that makes the figure stands last
  double width = 0;    ///< of the drawing, title and caption excluded
  double height = 0;
  std::string body;
  int clips = 0; ///< in the body so far
};

void draw_path(Figure& figure, std::span<const Vec2d> points, const Pen& pen, bool closed = false);
void draw_line(Figure& figure, Vec2d from, Vec2d to, const Pen& pen);
void draw_rectangle(Figure& figure, Vec2d corner, Vec2d size, const Pen& pen);
void draw_circle(Figure& figure, Vec2d center, double radius, const Pen& pen);

/// Its baseline at `place`. UTF-8; anything but text is escaped.
void draw_text(Figure& figure, Vec2d place, const std::string& text, const Type& type = {});

/// Several lines, the first at `place`, cut where a line is about `width` wide; returns the height.
double draw_paragraph(Figure& figure, Vec2d place, double width, const std::string& text,
                      const Type& type = {});

/// About how wide a text is: glyphs of a sans-serif face, to a tenth.
double text_width(const std::string& text, double size);

/// A display-encoded picture with 1, 3 or 4 channels, stretched over the rectangle. `smooth` blends
/// between pixels; cells of maps want sharp edges.
Status draw_picture(Figure& figure, Vec2d corner, Vec2d size, const image::Image& display,
                    bool smooth = true);

/// The same of few colours: fewer bytes.
Status draw_picture(Figure& figure, Vec2d corner, Vec2d size, const PaletteImage& display);

/// Round dots, as wide as the pen.
void draw_dots(Figure& figure, std::span<const Vec2d> places, const Pen& pen);

/// What is drawn until end_clip is cut off outside of the rectangle.
void begin_clip(Figure& figure, Vec2d corner, Vec2d size);
void end_clip(Figure& figure);

/// The whole: title above, drawing, caption below. The same figure gives the same bytes.
std::string to_svg(const Figure& figure, Theme theme);

} // namespace openltc::draw
