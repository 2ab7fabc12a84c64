// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace openltc::plot {

View view_from(double azimuth_degrees, double elevation_degrees, double half_width,
               double half_height) {
  const double a = azimuth_degrees * std::numbers::pi / 180;
  const double e = elevation_degrees * std::numbers::pi / 180;
  View view;
  view.towards = {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
  view.right = {-std::sin(a), std::cos(a), 0};
  view.up = cross(view.towards, view.right);
  view.half_width = half_width;
  view.half_height = half_height;
  return view;
}

Vec3d project(const View& view, Vec3d point) {
  const Vec3d p = point - view.center;
  return {dot(p, view.right) / view.half_width, dot(p, view.up) / view.half_height,
          dot(p, view.towards)};
}

Vec3d unproject(const View& view, Vec3d projected) {
  return view.center + view.right * (projected.x * view.half_width) +
         view.up * (projected.y * view.half_height) + view.towards * projected.z;
}

scene::Camera camera_of(const View& view) {
  // Far enough for whatever stands in the window.
  const double distance = 10 * std::max(view.half_width, view.half_height);
  scene::Camera camera;
  camera.projection = scene::Projection::orthographic;
  camera.position = to_float(view.center + view.towards * distance);
  camera.right = to_float(view.right);
  camera.up = to_float(view.up);
  camera.forward = to_float(-view.towards);
  camera.height = float(2 * view.half_height);
  return camera;
}

std::vector<Stroke> cut_by_visibility(std::span<const Vec3d> line,
                                      const std::function<bool(Vec3d)>& is_visible) {
  std::vector<Stroke> strokes;
  if (line.empty()) return strokes;
  strokes.push_back({{line[0]}, is_visible(line[0])});
  for (std::size_t i = 1; i < line.size(); ++i) {
    const bool visible = is_visible(line[i]);
    if (visible != strokes.back().visible) {
      double same = 0, other = 1; // shares of the segment
      while (other - same > 1e-4) {
        const double middle = 0.5 * (same + other);
        const bool there = is_visible(line[i - 1] + (line[i] - line[i - 1]) * middle);
        (there == visible ? other : same) = middle;
      }
      const Vec3d cut = line[i - 1] + (line[i] - line[i - 1]) * other;
      strokes.back().points.push_back(cut);
      strokes.push_back({{cut}, visible});
    }
    strokes.back().points.push_back(line[i]);
  }
  return strokes;
}

bool sphere_hides(const View& view, double radius, Vec3d point) {
  // Towards the viewer the ray leaves point p at p + t v; it meets the sphere where t solves
  // t^2 + 2 t p.v + p.p - r^2 = 0 with t > 0.
  const double r = radius * (1 - 1e-3);
  const double pv = dot(point, view.towards), pp = dot(point, point);
  if (pp < r * r) return true;
  return pv < 0 && pv * pv > pp - r * r;
}

} // namespace openltc::plot
