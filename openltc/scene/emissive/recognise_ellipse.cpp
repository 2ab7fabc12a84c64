// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The second moments of an ellipse of semi-axes a, b about its centre are A a^2/4 and A b^2/4 along
// them. Those of the outline's area, sums over triangles from a fixed point, therefore give the
// axes; both are then scaled alike, so that pi a b is the outline's area.

#include "openltc/scene/emissive/outline.h"
#include "openltc/scene/emissive/recognise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace openltc::scene {

namespace {

// Semi-axes whose relative difference is less are those of a circle, drawn with rounding.
constexpr double k_circle = 1e-3;

struct Moments {
  double area = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};

// Integrals of 1, x, y, x^2, xy, y^2 over the outline, by triangles (0, p, q).
Moments moments_of(const std::vector<Vec2d>& ring) {
  Moments m;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2d p = ring[i], q = ring[(i + 1) % ring.size()];
    const double doubled = p.x * q.y - q.x * p.y;
    m.area += doubled / 2;
    m.x += doubled * (p.x + q.x) / 6;
    m.y += doubled * (p.y + q.y) / 6;
    m.xx += doubled * (p.x * p.x + p.x * q.x + q.x * q.x) / 12;
    m.yy += doubled * (p.y * p.y + p.y * q.y + q.y * q.y) / 12;
    m.xy += doubled * (2 * p.x * p.y + p.x * q.y + q.x * p.y + 2 * q.x * q.y) / 24;
  }
  return m;
}

} // namespace

std::optional<light::EllipseLight> recognise_ellipse(const Island& island, double plane) {
  // One plane, one side.
  Vec3d normal{0, 0, 0}, center{0, 0, 0};
  double area = 0;
  for (const std::uint32_t i : island.triangles) {
    normal += island.mesh.normals[i] * island.mesh.areas[i];
    center += (island.corner(i, 0) + island.corner(i, 1) + island.corner(i, 2)) *
              (island.mesh.areas[i] / 3);
    area += island.mesh.areas[i];
  }
  if (!(length(normal) > 0.99 * area)) return {};
  normal = normalize(normal);
  center = center / area;
  const std::vector<std::uint32_t> corners = corners_of(island);
  std::vector<Vec3d> flat;
  double deviation = 0;
  for (const std::uint32_t v : corners) {
    const Vec3d p = island.mesh.points[v];
    const double height = dot(p - center, normal);
    deviation = std::max(deviation, std::abs(height));
    flat.push_back(p - normal * height);
  }
  if (!(deviation <= plane)) return {};
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const std::uint32_t i : island.triangles) {
    if (!(dot(island.mesh.normals[i], normal) > 0)) return {};
    auto triangle = island.triangle(i);
    for (std::uint32_t& v : triangle)
      v = std::uint32_t(std::lower_bound(corners.begin(), corners.end(), v) - corners.begin());
    triangles.push_back(triangle);
  }
  const std::vector<Ring> rings = trace_outline(flat, triangles, normal, 0);
  if (rings.size() != 1) return {};

  const Vec3d x = normalize(std::abs(normal.x) < 0.6 ? cross(Vec3d(1, 0, 0), normal)
                                                     : cross(Vec3d(0, 1, 0), normal));
  const Vec3d y = cross(normal, x);
  std::vector<Vec2d> ring;
  for (const Vec3d p : rings[0])
    ring.push_back({dot(p - center, x), dot(p - center, y)});
  const Moments m = moments_of(ring);
  if (!(m.area > 0)) return {};
  const double cx = m.x / m.area, cy = m.y / m.area;
  const double xx = m.xx / m.area - cx * cx, yy = m.yy / m.area - cy * cy,
               xy = m.xy / m.area - cx * cy;
  const double half_sum = (xx + yy) / 2, half_difference = std::hypot((xx - yy) / 2, xy);
  if (!(half_sum - half_difference > 0)) return {};
  double a = 2 * std::sqrt(half_sum + half_difference),
         b = 2 * std::sqrt(half_sum - half_difference);
  const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
  if (a - b < k_circle * a) a = b = std::sqrt(a * b);
  const double to_area = std::sqrt(m.area / (std::numbers::pi * a * b));
  a *= to_area;
  b *= to_area;

  // Distance to the ellipse, to first order: f / |grad f| of f = sqrt((x/a)^2 + (y/b)^2) - 1.
  const double cosine = std::cos(angle), sine = std::sin(angle);
  const auto is_near = [&](Vec2d p) {
    const double u = ((p.x - cx) * cosine + (p.y - cy) * sine) / a;
    const double v = ((p.y - cy) * cosine - (p.x - cx) * sine) / b;
    const double q = std::hypot(u, v);
    return std::abs(q - 1) * q <= island.tolerance * 2 * b * std::hypot(u / a, v / b);
  };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2d p = ring[i], next = ring[(i + 1) % ring.size()];
    if (!is_near(p) || !is_near((p + next) * 0.5)) return {};
  }

  light::EllipseLight light;
  light.center = to_float(center + x * cx + y * cy);
  light.half_u = to_float((x * cosine + y * sine) * a);
  light.half_v = to_float((y * cosine - x * sine) * b);
  light.surface_deviation = float(deviation);
  return light;
}

} // namespace openltc::scene
