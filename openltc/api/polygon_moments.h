// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Area, centroid and spread of a planar outline: what shading knows of a polygon that is small.

#pragma once

#include "openltc/target/vec.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace openltc {

/// \addtogroup dialect
/// @{

/// Moments of a planar outline in coordinates of its plane, metres.
struct PolygonMoments {
  double area = 0;      ///< signed, positive counter-clockwise
  Vec2d centroid{0, 0}; ///< of the area
  /// sqrt(2) times the standard deviations of the area along its principal axes, as vectors: the
  /// mean of f over centroid +- spread_u and +- spread_v is that over the area for every cubic f
  /// whose mixed third moments vanish, and for all quadratic ones.
  Vec2d spread_u{0, 0};
  Vec2d spread_v{0, 0}; ///< that along the other principal axis
  double fourth = 0;    ///< mean over the area of |p - centroid|^4
};

namespace detail {

/// The principal axes of a covariance matrix [xx xy; xy yy], scaled as PolygonMoments says.
inline void set_spread(PolygonMoments& moments, double xx, double xy, double yy) {
  const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
  const double mean = 0.5 * (xx + yy), half = std::hypot(0.5 * (xx - yy), xy);
  const double u = std::sqrt(2 * std::max(mean + half, 0.0));
  const double v = std::sqrt(2 * std::max(mean - half, 0.0));
  moments.spread_u = Vec2d(std::cos(angle), std::sin(angle)) * u;
  moments.spread_v = Vec2d(-std::sin(angle), std::cos(angle)) * v;
}

/// Integral of |p|^4 over the triangle (0, a, b), of signed area. Along its edge |p|^4 is the
/// square of p + q t + r t^2, and of the triangle's area it has a third of its mean.
inline double fourth_of_triangle(Vec2d a, Vec2d b) {
  const Vec2d edge = b - a;
  const double p = a.x * a.x + a.y * a.y, q = 2 * (a.x * edge.x + a.y * edge.y),
               r = edge.x * edge.x + edge.y * edge.y;
  const double area = 0.5 * (a.x * b.y - a.y * b.x);
  return area / 3 * (p * p + p * q + (q * q + 2 * p * r) / 3 + q * r / 2 + r * r / 5);
}

} // namespace detail

/// Moments of rings of points, one after the other; every ring repeats its first point at its end,
/// and starts_ring(i) tells where one begins. Holes run the other way round.
template <class StartsRing>
PolygonMoments polygon_moments(const std::vector<Vec2d>& points, const StartsRing& starts_ring) {
  PolygonMoments m;
  if (points.empty()) return m;
  // About the first point, so that nothing cancels: triangles (0, a, b) with signed areas.
  const Vec2d origin = points[0];
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (starts_ring(i)) continue;
    const Vec2d a = points[i - 1] - origin, b = points[i] - origin;
    const double area = 0.5 * (a.x * b.y - a.y * b.x);
    m.area += area;
    x += area * (a.x + b.x) / 3;
    y += area * (a.y + b.y) / 3;
    xx += area * (a.x * a.x + a.x * b.x + b.x * b.x) / 6;
    yy += area * (a.y * a.y + a.y * b.y + b.y * b.y) / 6;
    xy += area * (2 * a.x * a.y + a.x * b.y + b.x * a.y + 2 * b.x * b.y) / 12;
  }
  if (!(m.area > 0)) return m;
  x /= m.area;
  y /= m.area;
  m.centroid = origin + Vec2d(x, y);
  detail::set_spread(m, xx / m.area - x * x, xy / m.area - x * y, yy / m.area - y * y);
  double fourth = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!starts_ring(i))
      fourth += detail::fourth_of_triangle(points[i - 1] - m.centroid, points[i] - m.centroid);
  m.fourth = std::max(fourth / m.area, 0.0);
  return m;
}

/// @}

} // namespace openltc
