// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/space_drawing.h"

#include "openltc/plot/sphere_lines.h"

#include <cmath>
#include <vector>

namespace openltc::plot {

namespace {

constexpr double k_tolerance = 0.04; // figure units

double distance_to_line(Vec2d p, Vec2d a, Vec2d b) {
  const Vec2d way = b - a, to = p - a;
  const double l = std::hypot(way.x, way.y);
  return l > 0 ? std::abs(way.x * to.y - way.y * to.x) / l : std::hypot(to.x, to.y);
}

// Keeps what is needed to stay within the tolerance of points[from..to] (Ramer 1972, Douglas and
// Peucker 1973); lines are fine so that their hidden parts are found, not for the page.
void thin(std::span<const Vec2d> points, std::size_t from, std::size_t to,
          std::vector<Vec2d>& kept) {
  std::size_t farthest = from;
  double distance = k_tolerance;
  for (std::size_t i = from + 1; i < to; ++i) {
    const double d = distance_to_line(points[i], points[from], points[to]);
    if (d > distance) distance = d, farthest = i;
  }
  if (farthest == from) {
    kept.push_back(points[to]);
    return;
  }
  thin(points, from, farthest, kept);
  thin(points, farthest, to, kept);
}

std::vector<Vec2d> places(const Space& space, std::span<const Vec3d> points) {
  std::vector<Vec2d> all;
  for (const Vec3d& point : points)
    all.push_back(place(space, point));
  if (all.size() < 3) return all;
  std::vector<Vec2d> kept = {all[0]};
  thin(all, 0, all.size() - 1, kept);
  return kept;
}

} // namespace

Vec2d place(const Space& space, Vec3d point) {
  const Vec3d p = project(space.view, point);
  return {space.center.x + p.x * space.view.half_width * space.unit,
          space.center.y - p.y * space.view.half_height * space.unit};
}

Status draw_solids(draw::Figure& figure, const Space& space, std::span<const Solid> solids,
                   int pixels, bool few_colors) {
  SolidPictureOptions options;
  options.width = pixels;
  const Result<image::Image> picture = render_solids(solids, space.view, options);
  if (!picture) return picture.error();
  const double half_width = space.view.half_width * space.unit;
  const double half_height = half_width * picture->height / picture->width;
  const Vec2d corner(space.center.x - half_width, space.center.y - half_height);
  const Vec2d size(2 * half_width, 2 * half_height);
  return few_colors ? draw_picture(figure, corner, size, draw::reduce_colors(*picture))
                    : draw_picture(figure, corner, size, *picture);
}

void draw_line(draw::Figure& figure, const Space& space, std::span<const Vec3d> points,
               const Visibility& is_visible, const draw::Pen& seen, const draw::Pen& hidden) {
  for (const Stroke& stroke : cut_by_visibility(points, is_visible)) {
    const draw::Pen& style = stroke.visible ? seen : hidden;
    if (style.opacity > 0) draw_path(figure, places(space, stroke.points), style);
  }
}

draw::Pen filled(const std::string& color, double opacity) {
  return {"none", 0, "", 1, color, opacity};
}

void draw_area(draw::Figure& figure, const Space& space, std::span<const Vec3d> outline,
               const draw::Pen& style) {
  draw_path(figure, places(space, outline), style, true);
}

void draw_arrow(draw::Figure& figure, const Space& space, Vec3d from, Vec3d to,
                const Visibility& is_visible, const draw::Pen& seen, const draw::Pen& hidden) {
  const Vec2d start = place(space, from), tip = place(space, to);
  const Vec2d way = tip - start;
  const double l = std::hypot(way.x, way.y);
  if (l < 1) return;
  const Vec2d along = way * (1 / l), across(-along.y, along.x);
  const double head = std::min(3.2 + 2 * seen.width, 0.6 * l);
  // The line ends within the head, so that it does not blunt the tip.
  draw_line(figure, space, segment(from, from + (to - from) * (1 - 0.5 * head / l)), is_visible,
            seen, hidden);
  const Vec2d back = tip - along * head;
  const std::vector<Vec2d> triangle = {tip, back + across * (0.42 * head),
                                       back - across * (0.42 * head)};
  const draw::Pen& style = is_visible(to) ? seen : hidden;
  draw_path(figure, triangle, filled(style.color, style.opacity), true);
}

} // namespace openltc::plot
