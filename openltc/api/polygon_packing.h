// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A polygon light as shading wants it: outline in world space and in its own plane, and its area
// cut into triangles for sampling.
//
// The outline is cut into trapezoids: between two neighbouring heights of its vertices no edge
// begins or ends, so the edges that cross this slab, sorted from left to right, bound the inside
// by their parity. This holds for concave outlines, holes and islands alike. A trapezoid goes on
// through the slabs in which the same two edges bound it, so there are about as many triangles as
// vertices.

#pragma once

#include "openltc/api/polygon_moments.h"
#include "openltc/target/resources.h"
#include "openltc/target/vec.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace openltc {

/// \addtogroup dialect
/// @{

/// Owner of the arrays behind a PolygonView.
struct PackedPolygon {
  std::vector<float> points;       ///< see PolygonView
  std::vector<float> in_plane;     ///< see PolygonView
  std::vector<float> triangles;    ///< 9 floats each: corner, edge, edge; world space
  std::vector<float> triangle_cdf; ///< running share of the area, last element 1
  PolygonView view;                ///< points into the vectors above; moves with them
  float area = 0;                  ///< square metres
  double fourth_moment = 0;        ///< metres^4, see PolygonMoments::fourth

  PackedPolygon() = default;
  /// Takes the arrays of another; the view stays right.
  PackedPolygon(PackedPolygon&&) = default;
  /// The same.
  PackedPolygon& operator=(PackedPolygon&&) = default;
  /// Copies the arrays, and has a view of the copies.
  PackedPolygon(const PackedPolygon& other)
      : points(other.points), in_plane(other.in_plane), triangles(other.triangles),
        triangle_cdf(other.triangle_cdf), view(other.view), area(other.area),
        fourth_moment(other.fourth_moment) {
    point_view();
  }
  /// The same.
  PackedPolygon& operator=(const PackedPolygon& other) {
    if (this != &other) *this = PackedPolygon(other);
    return *this;
  }

  /// Makes the view point into the vectors as they are now.
  void point_view() {
    view.points = points.data();
    view.in_plane = in_plane.data();
    view.point_count = int(points.size() / 4);
    view.triangles = triangles.data();
    view.triangle_cdf = triangle_cdf.data();
    view.triangle_count = int(triangle_cdf.size());
  }
};

namespace detail {

struct OutlineEdge {
  Vec2d lower, upper;
};

inline double x_at(const OutlineEdge& e, double y) {
  return e.lower.x + (e.upper.x - e.lower.x) * (y - e.lower.y) / (e.upper.y - e.lower.y);
}

struct FlatTriangle {
  Vec2d a, b, c;
};

/// Bounded by two edges from height y up to where one of them ends.
struct Trapezoid {
  const OutlineEdge *left, *right;
  double y;
};

inline double area_of(const FlatTriangle& t) {
  return 0.5 * std::abs((t.b.x - t.a.x) * (t.c.y - t.a.y) - (t.b.y - t.a.y) * (t.c.x - t.a.x));
}

inline std::vector<FlatTriangle> triangulate(const std::vector<OutlineEdge>& edges) {
  std::vector<double> heights;
  for (const OutlineEdge& e : edges) {
    heights.push_back(e.lower.y);
    heights.push_back(e.upper.y);
  }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());

  std::vector<FlatTriangle> triangles;
  const auto close = [&](const Trapezoid& t, double y) {
    const Vec2d a{x_at(*t.left, t.y), t.y}, b{x_at(*t.right, t.y), t.y};
    const Vec2d c{x_at(*t.right, y), y}, d{x_at(*t.left, y), y};
    for (const FlatTriangle& triangle : {FlatTriangle{a, b, c}, FlatTriangle{a, c, d}})
      if (area_of(triangle) > 0) triangles.push_back(triangle);
  };
  std::vector<Trapezoid> open, next;
  // Edges by their lower ends, and those that cross the slab in work: only edges come and go.
  std::vector<const OutlineEdge*> by_start, crossing;
  for (const OutlineEdge& e : edges)
    by_start.push_back(&e);
  std::stable_sort(
      by_start.begin(), by_start.end(),
      [](const OutlineEdge* p, const OutlineEdge* q) { return p->lower.y < q->lower.y; });
  std::size_t started = 0;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const double y0 = heights[i], y1 = heights[i + 1], middle = 0.5 * (y0 + y1);
    crossing.erase(std::remove_if(crossing.begin(), crossing.end(),
                                  [&](const OutlineEdge* e) { return e->upper.y <= y0; }),
                   crossing.end());
    for (; started < by_start.size() && by_start[started]->lower.y <= y0; ++started)
      crossing.push_back(by_start[started]);
    std::sort(crossing.begin(), crossing.end(), [&](const OutlineEdge* p, const OutlineEdge* q) {
      return x_at(*p, middle) < x_at(*q, middle);
    });
    next.clear();
    for (std::size_t k = 0; k + 1 < crossing.size(); k += 2)
      next.push_back({crossing[k], crossing[k + 1], y0});
    // Both lists run from left to right, so what goes on is in the same order in both.
    std::size_t from = 0;
    for (Trapezoid& t : next) {
      const auto found = std::find_if(open.begin() + std::ptrdiff_t(from), open.end(),
                                      [&](const Trapezoid& o) { return o.left == t.left; });
      if (found == open.end() || found->right != t.right) continue;
      for (; from < std::size_t(found - open.begin()); ++from)
        close(open[from], y0);
      t.y = found->y;
      ++from;
    }
    for (; from < open.size(); ++from)
      close(open[from], y0);
    open.swap(next);
  }
  for (const Trapezoid& t : open)
    close(t, heights.back());
  return triangles;
}

inline void plane_basis(Vec3f n, Vec3f& u, Vec3f& v) {
  const Vec3f helper = std::abs(n.x) < 0.5f ? Vec3f(1, 0, 0) : Vec3f(0, 1, 0);
  u = normalize(cross(helper, n));
  v = cross(n, u);
}

inline void store3(float* out, Vec3f p) {
  out[0] = p.x;
  out[1] = p.y;
  out[2] = p.z;
}

} // namespace detail

/// Packs the rings of an outline.
///
/// vertices: all rings one after the other, world space, in one plane within rounding; finite.
/// ring_end: one past the last vertex of each ring, ascending; each has three vertices or more.
/// normal: unit, towards the emitting side, seen from which outer rings run counter-clockwise and
/// holes clockwise.
///
/// An outline of no area gives a polygon without points, which lights nothing.
inline PackedPolygon pack_polygon(const std::vector<Vec3f>& vertices,
                                  const std::vector<std::uint32_t>& ring_end, Vec3f normal,
                                  bool two_sided) {
  PackedPolygon packed;
  if (vertices.empty()) return packed;

  // The longest edge gives the plane's u axis, so that the slabs of a rectangle are one.
  Vec3f origin = vertices[0], u, v;
  detail::plane_basis(normal, u, v);
  float longest2 = 0;
  std::uint32_t begin = 0;
  for (const std::uint32_t end : ring_end) {
    for (std::uint32_t i = begin; i < end; ++i) {
      const Vec3f d = vertices[i + 1 < end ? i + 1 : begin] - vertices[i];
      const Vec3f flat = d - normal * dot(d, normal);
      if (dot(flat, flat) <= longest2 * 1.0001f) continue;
      longest2 = dot(flat, flat);
      u = normalize(flat);
      v = cross(normal, u);
    }
    begin = end;
  }

  std::vector<detail::OutlineEdge> edges;
  double signed_area = 0;
  begin = 0;
  for (const std::uint32_t end : ring_end) {
    Vec2d previous;
    for (std::uint32_t i = begin; i <= end && begin < end; ++i) {
      const Vec3f p = vertices[i < end ? i : begin];
      const Vec3f d = p - origin;
      const Vec2f flat{dot(d, u), dot(d, v)};
      packed.points.insert(packed.points.end(), {p.x, p.y, p.z, i == begin ? 1.0f : 0.0f});
      packed.in_plane.insert(packed.in_plane.end(), {flat.x, flat.y});
      const Vec2d q{double(flat.x), double(flat.y)};
      if (i > begin) {
        signed_area += 0.5 * (previous.x * q.y - previous.y * q.x);
        if (previous.y < q.y) edges.push_back({previous, q});
        if (previous.y > q.y) edges.push_back({q, previous});
      }
      previous = q;
    }
    begin = end;
  }

  const std::vector<detail::FlatTriangle> triangles = detail::triangulate(edges);
  double total = 0;
  for (const detail::FlatTriangle& t : triangles)
    total += detail::area_of(t);
  if (!(total > 0) || !std::isfinite(total) || !(signed_area > 0)) {
    packed.points.clear();
    packed.in_plane.clear();
    return packed;
  }
  double sum = 0;
  const auto world = [&](Vec2d p) { return u * float(p.x) + v * float(p.y); };
  for (const detail::FlatTriangle& t : triangles) {
    sum += detail::area_of(t);
    const Vec3f a = origin + world(t.a), ab = world(t.b - t.a), ac = world(t.c - t.a);
    packed.triangles.insert(packed.triangles.end(),
                            {a.x, a.y, a.z, ab.x, ab.y, ab.z, ac.x, ac.y, ac.z});
    packed.triangle_cdf.push_back(float(sum / total));
  }
  packed.triangle_cdf.back() = 1.0f;

  packed.area = float(total);
  packed.point_view();
  packed.view.two_sided = two_sided;
  packed.view.area = packed.area;
  std::vector<Vec2d> flat_points;
  for (std::size_t i = 0; i + 1 < packed.in_plane.size(); i += 2)
    flat_points.push_back({double(packed.in_plane[i]), double(packed.in_plane[i + 1])});
  const auto starts_ring = [&](std::size_t i) { return packed.points[4 * i + 3] != 0.0f; };
  const PolygonMoments moments = polygon_moments(flat_points, starts_ring);
  double radius = 0;
  for (const Vec2d& p : flat_points)
    radius = std::max(radius, std::hypot(p.x - moments.centroid.x, p.y - moments.centroid.y));
  detail::store3(packed.view.centroid, origin + world(moments.centroid));
  detail::store3(packed.view.spread_u, world(moments.spread_u));
  detail::store3(packed.view.spread_v, world(moments.spread_v));
  packed.view.radius = float(radius);
  packed.fourth_moment = moments.fourth;
  if (flat_points.size() == 5) {
    const auto gap = [](double a, double b, double c, double d) { return a - b + c - d; };
    const std::vector<Vec2d>& p = flat_points;
    packed.view.parallelogram = std::hypot(gap(p[0].x, p[1].x, p[2].x, p[3].x),
                                           gap(p[0].y, p[1].y, p[2].y, p[3].y)) <= 1e-6 * radius;
  }
  detail::store3(packed.view.origin, origin);
  detail::store3(packed.view.axis_u, u);
  detail::store3(packed.view.axis_v, v);
  detail::store3(packed.view.normal, normal);
  return packed;
}

/// The elements of a polygon that the files of `openltc shaders` read, "polygon data" there: 8 +
/// point_count vectors of four floats, world space, metres. Without points it is a polygon that
/// lights nothing.
inline std::vector<float> polygon_elements(const PolygonView& polygon) {
  std::vector<float> elements;
  elements.reserve(4 * std::size_t(8 + polygon.point_count));
  const auto add = [&](const float(&v)[3], float w) {
    elements.insert(elements.end(), {v[0], v[1], v[2], w});
  };
  elements = {float(polygon.point_count), polygon.two_sided ? 1.0f : 0.0f, polygon.area, 0.0f};
  add(polygon.origin, 0);
  add(polygon.axis_u, 0);
  add(polygon.axis_v, 0);
  add(polygon.normal, 0);
  add(polygon.centroid, polygon.radius);
  add(polygon.spread_u, 0);
  add(polygon.spread_v, 0);
  elements.insert(elements.end(), polygon.points, polygon.points + 4 * polygon.point_count);
  return elements;
}

/// @}

} // namespace openltc
