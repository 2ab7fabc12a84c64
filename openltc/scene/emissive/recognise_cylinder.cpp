// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The normals of a cylinder's side are perpendicular to its axis and those of its ends lie along
// it, so the axis is either the normal of the largest facet or perpendicular to it and to a second
// facet. Each such direction is tried and then refined: of all directions a the axis makes
// sum(area (n.a)^2) over the side least, which one step of inverse iteration finds.

#include "openltc/scene/emissive/recognise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace openltc::scene {

namespace {

// Facets lean by this much at most, towards the axis or away from it (6 degrees).
constexpr double k_lean = 0.1;
constexpr std::size_t k_most_axes = 6;

std::vector<Vec3d> possible_axes(const Island& island) {
  const auto& normals = island.mesh.normals;
  const std::uint32_t largest = *std::max_element(
      island.triangles.begin(), island.triangles.end(), [&](std::uint32_t a, std::uint32_t b) {
        return island.mesh.areas[a] < island.mesh.areas[b];
      });
  std::vector<Vec3d> axes = {normals[largest]};
  for (const std::uint32_t i : island.triangles) {
    const Vec3d axis = cross(normals[largest], normals[i]);
    if (axes.size() >= k_most_axes || !(length(axis) > 0.7)) continue;
    const Vec3d unit = normalize(axis);
    const bool is_new = std::none_of(axes.begin(), axes.end(),
                                     [&](Vec3d a) { return std::abs(dot(a, unit)) > 0.99; });
    if (is_new) axes.push_back(unit);
  }
  return axes;
}

struct Parts {
  std::vector<std::uint32_t> side, ends;
};

std::optional<Parts> split(const Island& island, Vec3d axis) {
  Parts parts;
  for (const std::uint32_t i : island.triangles) {
    const double along = std::abs(dot(island.mesh.normals[i], axis));
    if (along < k_lean)
      parts.side.push_back(i);
    else if (along > 1 - k_lean * k_lean / 2)
      parts.ends.push_back(i);
    else
      return {};
  }
  if (parts.side.empty()) return {};
  return parts;
}

Vec3d refined(const Island& island, const Parts& parts, Vec3d axis) {
  Vec3d m[3] = {Vec3d(0, 0, 0), Vec3d(0, 0, 0), Vec3d(0, 0, 0)};
  double area = 0;
  for (const std::uint32_t i : parts.side) {
    const Vec3d n = island.mesh.normals[i];
    m[0] += n * (n.x * island.mesh.areas[i]);
    m[1] += n * (n.y * island.mesh.areas[i]);
    m[2] += n * (n.z * island.mesh.areas[i]);
    area += island.mesh.areas[i];
  }
  const double shift = 1e-7 * area; // keeps an exact cylinder's matrix regular
  m[0].x += shift;
  m[1].y += shift;
  m[2].z += shift;
  const auto better = solve(m, axis);
  return better && length(*better) > 0 ? normalize(*better) : axis;
}

// Centre of the least-squares circle through points of a plane; see recognise_sphere.cpp.
std::optional<Vec2d> circle_center(const std::vector<Vec2d>& points) {
  Vec2d mean{0, 0};
  for (const Vec2d p : points)
    mean = mean + p * (1 / double(points.size()));
  double xx = 0, xy = 0, yy = 0, bx = 0, by = 0;
  for (const Vec2d p : points) {
    const Vec2d q = p - mean;
    const double half = 0.5 * (q.x * q.x + q.y * q.y);
    xx += q.x * q.x;
    xy += q.x * q.y;
    yy += q.y * q.y;
    bx += half * q.x;
    by += half * q.y;
  }
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-9 * xx * yy)) return {};
  return mean + Vec2d{(yy * bx - xy * by) / determinant, (xx * by - xy * bx) / determinant};
}

std::optional<light::TubeLight> along_axis(const Island& island, Vec3d first_axis) {
  const auto parts = split(island, first_axis);
  if (!parts || (parts->ends.empty() && island.two_sided)) return {};
  const Vec3d axis = refined(island, *parts, first_axis);
  const Vec3d x =
      normalize(std::abs(axis.x) < 0.6 ? cross(Vec3d(1, 0, 0), axis) : cross(Vec3d(0, 1, 0), axis));
  const Vec3d y = cross(axis, x);
  const auto across = [&](Vec3d p) { return Vec2d{dot(p, x), dot(p, y)}; };

  // Where the side begins and ends, and around which line it goes.
  Island side{island.mesh, parts->side, island.two_sided, island.tolerance};
  const std::vector<std::uint32_t> corners = corners_of(side);
  double low = std::numeric_limits<double>::max(), high = -low;
  std::vector<Vec2d> circle;
  for (const std::uint32_t v : corners) {
    const double t = dot(island.mesh.points[v], axis);
    low = std::min(low, t);
    high = std::max(high, t);
    circle.push_back(across(island.mesh.points[v]));
  }
  const double height = high - low;
  const auto center = circle_center(circle);
  if (!center || !(height > 0)) return {};

  // 2 pi r h = area of the side, or 2 pi r h + 2 pi r^2 = area with the ends.
  const double share = area_of(island) / (2 * std::numbers::pi);
  const bool is_closed = !parts->ends.empty();
  const double radius =
      is_closed ? std::sqrt(height * height / 4 + share) - height / 2 : share / height;
  const double allowed = island.tolerance * 2 * radius;

  const auto from_axis = [&](Vec3d p) {
    const Vec2d q = across(p) - *center;
    return std::hypot(q.x, q.y);
  };
  double outside = 0;
  for (const std::uint32_t v : corners) {
    const double d = from_axis(island.mesh.points[v]) - radius;
    if (!(std::abs(d) <= allowed)) return {};
    outside = std::max(outside, d);
  }
  for (const std::uint32_t i : parts->side) {
    const Vec3d middle = (island.corner(i, 0) + island.corner(i, 1) + island.corner(i, 2)) / 3.0;
    const Vec2d q = across(middle) - *center;
    const double facing =
        dot(island.mesh.normals[i], x) * q.x + dot(island.mesh.normals[i], y) * q.y;
    if (!island.two_sided && !(facing > 0)) return {};
    if (!(radius - std::abs(facing) <= allowed)) return {};
  }

  // The ends lie at both ends, are about as large as the circle, and nothing else is open.
  double end_area[2] = {0, 0};
  for (const std::uint32_t i : parts->ends) {
    const bool is_high = dot(island.mesh.normals[i], axis) > 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double t = dot(island.corner(i, c), axis) - low;
      const bool at_high = t > height / 2;
      if (!island.two_sided && at_high != is_high) return {};
      if (!(std::abs(at_high ? t - height : t) <= std::min(allowed, 0.1 * height))) return {};
      end_area[at_high] += island.mesh.areas[i] / 3;
    }
  }
  if (is_closed) {
    const double circle_area = std::numbers::pi * radius * radius;
    for (const double area : end_area)
      if (!(std::abs(area - circle_area) <= 8 * island.tolerance * circle_area)) return {};
  }
  for (const auto& [a, b] : open_edges(island)) {
    if (is_closed) return {};
    const double ta = dot(island.mesh.points[a], axis) - low,
                 tb = dot(island.mesh.points[b], axis) - low;
    const double slack = std::min(allowed, 0.1 * height);
    const bool is_end =
        (ta <= slack && tb <= slack) || (ta >= height - slack && tb >= height - slack);
    if (!is_end) return {};
  }

  const auto to_world = [&](double t) {
    return to_float(x * center->x + y * center->y + axis * t);
  };
  light::TubeLight light;
  light.from = to_world(low);
  light.to = to_world(high);
  light.radius = float(radius);
  light.caps = is_closed ? light::TubeCaps::flat : light::TubeCaps::none;
  light.surface_deviation = float(outside);
  return light;
}

} // namespace

std::optional<light::TubeLight> recognise_cylinder(const Island& island) {
  for (const Vec3d axis : possible_axes(island))
    if (const auto light = along_axis(island, axis)) return light;
  return {};
}

} // namespace openltc::scene
