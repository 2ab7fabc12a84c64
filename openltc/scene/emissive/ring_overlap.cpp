// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Rings cover a place twice when two of their edges cross, or when the winding number just inside
// of one of them is not 1: without a crossing it is the same all along a ring.
//
// The union is found without a topology that rounding could break: triangle by triangle, the
// largest first, as what is left of each when those before it are cut off. A triangle minus another
// one is at most three convex pieces.

#include "openltc/scene/emissive/ring_overlap.h"

#include "openltc/scene/emissive/segment_grid.h"
#include "openltc/scene/grid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace openltc::scene {

namespace {

// A second or so each; what needs more is given up.
constexpr std::size_t k_most_tests = 50'000'000;
constexpr std::size_t k_most_cuts = 3'000'000;
constexpr std::size_t k_most_pieces = 30'000;

struct FlatEdge {
  Vec2d a, b;
};

double side_of(Vec2d a, Vec2d b, Vec2d p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

bool cross_properly(const FlatEdge& p, const FlatEdge& q, double tolerance) {
  const auto separates = [&](const FlatEdge& line, const FlatEdge& ends) {
    const double reach = tolerance * std::hypot(line.b.x - line.a.x, line.b.y - line.a.y);
    const double a = side_of(line.a, line.b, ends.a), b = side_of(line.a, line.b, ends.b);
    return (a > reach && b < -reach) || (a < -reach && b > reach);
  };
  return separates(p, q) && separates(q, p);
}

// Edges by height, for winding numbers.
class Rows {
public:
  explicit Rows(const std::vector<FlatEdge>& edges) : edges_(edges) {
    double upper = -1e300;
    for (const FlatEdge& e : edges) {
      lower_ = std::min({lower_, e.a.y, e.b.y});
      upper = std::max({upper, e.a.y, e.b.y});
    }
    const std::size_t count = std::size_t(4 * std::sqrt(double(edges.size()))) + 1;
    size_ = std::max((upper - lower_) / double(count), 1e-300);
    rows_.resize(count);
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      const auto [low, high] = std::minmax(edges[i].a.y, edges[i].b.y);
      for (std::size_t row = row_of(low); row <= row_of(high); ++row)
        rows_[row].push_back(i);
    }
  }

  int winding(Vec2d p, std::size_t& tests) const {
    int winding = 0;
    const std::vector<std::uint32_t>& row = rows_[row_of(p.y)];
    tests += row.size();
    for (const std::uint32_t i : row) {
      const FlatEdge& e = edges_[i];
      if (e.a.y <= p.y && e.b.y > p.y && side_of(e.a, e.b, p) > 0) ++winding;
      if (e.b.y <= p.y && e.a.y > p.y && side_of(e.a, e.b, p) < 0) --winding;
    }
    return winding;
  }

private:
  std::size_t row_of(double y) const {
    return std::size_t(std::clamp((y - lower_) / size_, 0.0, double(rows_.size() - 1)));
  }
  const std::vector<FlatEdge>& edges_;
  double lower_ = 1e300, size_ = 1;
  std::vector<std::vector<std::uint32_t>> rows_;
};

using Piece = std::vector<Vec2d>; // convex, counter-clockwise

double area_of_piece(const Piece& piece) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < piece.size(); ++i)
    sum += side_of(piece[0], piece[i], piece[i + 1]);
  return sum / 2;
}

double extent_of_piece(const Piece& piece) {
  double longest = 0;
  for (std::size_t i = 1; i < piece.size(); ++i)
    longest = std::max(longest, std::hypot(piece[i].x - piece[0].x, piece[i].y - piece[0].y));
  return longest;
}

bool is_sliver(const Piece& piece, double tolerance) {
  return piece.size() < 3 || !(area_of_piece(piece) > tolerance * extent_of_piece(piece));
}

// The part of `piece` to the left of the line from a to b (sign 1) or to its right (sign -1).
Piece part_beside(const Piece& piece, Vec2d a, Vec2d b, double sign) {
  Piece part;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Vec2d p = piece[i], q = piece[(i + 1) % piece.size()];
    const double sp = sign * side_of(a, b, p), sq = sign * side_of(a, b, q);
    if (sp >= 0) part.push_back(p);
    if ((sp > 0 && sq < 0) || (sp < 0 && sq > 0)) part.push_back(p + (q - p) * (sp / (sp - sq)));
  }
  return part;
}

// Whether a side of one lies between the two.
bool lie_apart(const Piece& p, const Piece& q, double tolerance) {
  const auto has_side_between = [&](const Piece& from, const Piece& other) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Vec2d a = from[i], b = from[(i + 1) % from.size()];
      const double reach = tolerance * std::hypot(b.x - a.x, b.y - a.y);
      if (std::all_of(other.begin(), other.end(),
                      [&](Vec2d c) { return side_of(a, b, c) <= reach; }))
        return true;
    }
    return false;
  };
  return has_side_between(p, q) || has_side_between(q, p);
}

// Joins points that are closer than the tolerance.
class PointJoiner {
public:
  explicit PointJoiner(double tolerance) : tolerance_(tolerance) {}

  std::uint32_t join(Vec2d p) {
    const double size = std::max(tolerance_, 1e-30);
    const Cell cell = {std::llround(p.x / size), std::llround(p.y / size), 0, 0};
    std::uint32_t joined = std::uint32_t(points_.size());
    for_neighbours(cell, 2, [&](const Cell& near) {
      const auto found = grid_.find(near);
      if (found == grid_.end()) return;
      for (const std::uint32_t known : found->second)
        if (std::hypot(points_[known].x - p.x, points_[known].y - p.y) <= tolerance_)
          joined = std::min(joined, known);
    });
    if (joined == points_.size()) {
      points_.push_back(p);
      grid_[cell].push_back(joined);
    }
    return joined;
  }
  const std::vector<Vec2d>& points() const { return points_; }

private:
  double tolerance_;
  Grid grid_;
  std::vector<Vec2d> points_;
};

// Cuts `cutter` off each of `pieces`.
std::vector<Piece> without(const std::vector<Piece>& pieces, const Piece& cutter, double tolerance,
                           std::size_t& cuts) {
  std::vector<Piece> left;
  for (const Piece& piece : pieces) {
    ++cuts;
    if (lie_apart(piece, cutter, tolerance)) {
      left.push_back(piece);
      continue;
    }
    Piece rest = piece;
    for (std::size_t i = 0; i < cutter.size() && rest.size() >= 3; ++i) {
      const Vec2d a = cutter[i], b = cutter[(i + 1) % cutter.size()];
      Piece outside = part_beside(rest, a, b, -1);
      if (!is_sliver(outside, tolerance)) left.push_back(std::move(outside));
      rest = part_beside(rest, a, b, 1);
    }
  }
  return left;
}

} // namespace

bool covers_twice(std::span<const Ring> rings, Vec3d normal, double tolerance) {
  const PlaneAxes axes(normal);
  std::vector<FlatEdge> edges;
  std::vector<Vec2d> places, probes;
  for (const Ring& ring : rings) {
    double longest = -1;
    Vec2d probe;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const FlatEdge e{axes.in_plane(ring[i]), axes.in_plane(ring[(i + 1) % ring.size()])};
      edges.push_back(e);
      places.push_back(e.a);
      const Vec2d along = e.b - e.a;
      const double l = std::hypot(along.x, along.y);
      if (!(l > longest)) continue;
      longest = l;
      const Vec2d left(-along.y / l, along.x / l);
      probe = (e.a + e.b) * 0.5 + left * (2 * tolerance);
    }
    if (longest > 0) probes.push_back(probe);
  }
  if (rings.size() == 1 && edges.size() == 3) return false;
  std::size_t tests = 0;
  SegmentGrid grid(places, edges.size());
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    bool crosses = false;
    grid.visit_along(edges[i].a, edges[i].b, 0, [&](std::vector<std::uint32_t>& cell) {
      if (crosses) return;
      tests += cell.size();
      for (const std::uint32_t k : cell)
        crosses = crosses || cross_properly(edges[i], edges[k], tolerance);
      cell.push_back(i);
    });
    if (crosses || tests > k_most_tests) return true;
  }
  const Rows rows(edges);
  for (const Vec2d probe : probes)
    if (rows.winding(probe, tests) > 1 || tests > k_most_tests) return true;
  return false;
}

Cover cover_once(std::span<const Vec3d> points,
                 std::span<const std::array<std::uint32_t, 3>> triangles, Vec3d normal,
                 double tolerance) {
  Cover cover;
  const PlaneAxes axes(normal);
  const double height = points.empty() ? 0 : dot(points[0], normal);
  std::vector<Piece> pieces_of_all;
  std::vector<Vec2d> places;
  for (const auto& t : triangles) {
    Piece piece;
    for (const std::uint32_t corner : t)
      piece.push_back(axes.in_plane(points[corner]));
    places.insert(places.end(), piece.begin(), piece.end());
    pieces_of_all.push_back(std::move(piece));
  }
  std::vector<std::uint32_t> order(triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return area_of_piece(pieces_of_all[a]) > area_of_piece(pieces_of_all[b]);
  });

  SegmentGrid grid(places, triangles.size());
  std::vector<std::uint32_t> seen(triangles.size(), 0xFFFFFFFF);
  PointJoiner joiner(tolerance);
  std::size_t cuts = 0;
  for (const std::uint32_t i : order) {
    const Piece& whole = pieces_of_all[i];
    if (is_sliver(whole, tolerance)) continue;
    Vec2d lower = whole[0], upper = lower;
    for (const Vec2d p : whole) {
      lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
      upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
    }
    std::vector<Piece> left = {whole};
    grid.visit_box(lower, upper, [&](std::vector<std::uint32_t>& cell) {
      ++cuts;
      for (const std::uint32_t other : cell) {
        if (left.empty() || cuts > k_most_cuts) return;
        if (seen[other] == i) continue;
        seen[other] = i;
        left = without(left, pieces_of_all[other], tolerance, cuts);
      }
    });
    if (!left.empty())
      grid.visit_box(lower, upper, [&](std::vector<std::uint32_t>& cell) { cell.push_back(i); });
    for (const Piece& piece : left)
      for (std::size_t k = 1; k + 1 < piece.size(); ++k) {
        const std::array<std::uint32_t, 3> t = {joiner.join(piece[0]), joiner.join(piece[k]),
                                                joiner.join(piece[k + 1])};
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        cover.triangles.push_back(t);
        cover.of.push_back(i);
      }
    if (cuts > k_most_cuts || cover.triangles.size() > k_most_pieces) {
      cover = {};
      cover.is_complete = false;
      return cover;
    }
  }
  for (const Vec2d p : joiner.points())
    cover.points.push_back(axes.x * p.x + axes.y * p.y + normal * height);
  return cover;
}

} // namespace openltc::scene
