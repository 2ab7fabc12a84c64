// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Segments by the sides on which their ends lie of each other, those that a grid finds near each
// other; points in polygons by crossing parity.

#include "openltc/scene/emissive/simple_outline.h"

#include "openltc/scene/emissive/segment_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace openltc::scene {

namespace {

// Twice the area of the triangle a b c, positive when counter-clockwise.
double side(Vec2d a, Vec2d b, Vec2d c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool is_between(Vec2d a, Vec2d b, Vec2d p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool meet(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  const double sc = side(a, b, c), sd = side(a, b, d), sa = side(c, d, a), sb = side(c, d, b);
  if (((sc > 0 && sd < 0) || (sc < 0 && sd > 0)) && ((sa > 0 && sb < 0) || (sa < 0 && sb > 0)))
    return true;
  return (sc == 0 && is_between(a, b, c)) || (sd == 0 && is_between(a, b, d)) ||
         (sa == 0 && is_between(c, d, a)) || (sb == 0 && is_between(c, d, b));
}

Vec2d at(std::span<const Vec2d> ring, std::size_t i) { return ring[i % ring.size()]; }

struct OutlineBox {
  Vec2d lower{1e300, 1e300}, upper{-1e300, -1e300};
  double extent() const { return std::max(upper.x - lower.x, upper.y - lower.y); }
};

OutlineBox box_of(std::span<const Vec2d> ring) {
  OutlineBox box;
  for (const Vec2d p : ring) {
    box.lower = {std::min(box.lower.x, p.x), std::min(box.lower.y, p.y)};
    box.upper = {std::max(box.upper.x, p.x), std::max(box.upper.y, p.y)};
  }
  return box;
}

bool lie_apart(const OutlineBox& a, const OutlineBox& b) {
  return a.upper.x < b.lower.x || b.upper.x < a.lower.x || a.upper.y < b.lower.y ||
         b.upper.y < a.lower.y;
}

bool rings_meet(std::span<const Vec2d> p, std::span<const Vec2d> q) {
  const OutlineBox box = box_of(p);
  if (lie_apart(box, box_of(q))) return false;
  const double reach = 1e-9 * box.extent(); // for rounding at the borders of cells
  SegmentGrid grid(p, p.size());
  for (std::uint32_t i = 0; i < p.size(); ++i)
    grid.add_segment(p[i], at(p, i + 1), reach, i);
  bool found = false;
  for (std::size_t k = 0; k < q.size() && !found; ++k)
    grid.visit_along(q[k], at(q, k + 1), reach, [&](const std::vector<std::uint32_t>& cell) {
      for (const std::uint32_t i : cell)
        found = found || meet(p[i], at(p, i + 1), q[k], at(q, k + 1));
    });
  return found;
}

bool is_inside(Vec2d point, std::span<const Vec2d> ring) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2d a = ring[i], b = at(ring, i + 1);
    if ((a.y > point.y) == (b.y > point.y)) continue;
    if (point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

} // namespace

double signed_area(std::span<const Vec2d> ring) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    sum += side(ring[0], ring[i], ring[i + 1]);
  return sum / 2;
}

Status check_simple(std::span<const Vec2d> ring) {
  const std::size_t n = ring.size();
  if (n < 3) return Error{"an outline needs three points or more"};
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2d a = ring[i], b = at(ring, i + 1), c = at(ring, i + 2);
    if (a.x == b.x && a.y == b.y)
      return Error{fmt::format("points {} and {} are the same", i, (i + 1) % n)};
    const bool turns_back =
        side(a, b, c) == 0 && (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) < 0;
    if (turns_back) return Error{fmt::format("the outline turns back at point {}", (i + 1) % n)};
  }
  // The first pair of edges that meet and are no neighbours.
  const std::pair<std::size_t, std::size_t> none(n, n);
  std::pair<std::size_t, std::size_t> first = none;
  const double reach = 1e-9 * box_of(ring).extent();
  SegmentGrid grid(ring, n);
  for (std::uint32_t k = 0; k < n; ++k)
    grid.visit_along(ring[k], at(ring, k + 1), reach, [&](std::vector<std::uint32_t>& cell) {
      for (const std::uint32_t i : cell) {
        const std::pair<std::size_t, std::size_t> pair(i, k);
        const bool are_neighbours = i + 1 >= k || (i == 0 && k == n - 1);
        if (!are_neighbours && pair < first &&
            meet(ring[i], at(ring, i + 1), ring[k], at(ring, k + 1)))
          first = pair;
      }
      cell.push_back(k);
    });
  if (first != none)
    return Error{
        fmt::format("the outline crosses itself: edges {} and {} meet", first.first, first.second)};
  return Success{};
}

Status check_inside(std::span<const Vec2d> hole, std::span<const Vec2d> outer) {
  if (rings_meet(hole, outer)) return Error{"the hole crosses or touches the outline"};
  if (!is_inside(hole[0], outer)) return Error{"the hole lies outside of the outline"};
  return Success{};
}

Status check_apart(std::span<const Vec2d> a, std::span<const Vec2d> b) {
  if (lie_apart(box_of(a), box_of(b))) return Success{};
  if (rings_meet(a, b) || is_inside(a[0], b) || is_inside(b[0], a))
    return Error{"two holes overlap"};
  return Success{};
}

} // namespace openltc::scene
