// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// An edge that two triangles use in opposite directions is inside; the others are the boundary. At
// every vertex as many boundary edges arrive as leave, because that holds for each triangle and
// cancelling a pair of opposite edges keeps it; so walking along them always closes a ring.
//
// Where rings touch in a vertex the walk turns as far left as it can, and a part of the walk that
// comes back to a vertex is cut off as a ring of its own. That keeps every ring simple.

#include "openltc/scene/emissive/outline.h"

#include "openltc/scene/emissive/segment_grid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace openltc::scene {

namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

// Splitting at T-junctions compares edges with the vertices near them; beyond this it is not worth
// its time.
constexpr std::size_t k_max_comparisons = 50'000'000;

// Relative errors of an outline's area.
constexpr double k_area_tolerance = 1e-4, k_most_area_lost = 0.01;

// Directed edges that are left when opposite ones cancel, each as often as it is left.
std::vector<Edge> cancel_opposite(const std::vector<Edge>& edges) {
  std::map<Edge, int> net;
  for (const auto& [a, b] : edges) {
    if (a < b) ++net[{a, b}];
    if (b < a) --net[{b, a}];
  }
  std::vector<Edge> left;
  for (const auto& [edge, count] : net)
    for (int i = 0; i < std::abs(count); ++i)
      left.push_back(count > 0 ? edge : Edge{edge.second, edge.first});
  return left;
}

bool has_repeated(const std::vector<Edge>& sorted_pairs) {
  std::vector<Edge> edges = sorted_pairs;
  std::sort(edges.begin(), edges.end());
  return std::adjacent_find(edges.begin(), edges.end()) != edges.end();
}

// Splits edges at vertices that lie on them, so that neighbours of different fineness cancel.
std::vector<Edge> split_at_vertices(const std::vector<Edge>& edges, std::span<const Vec3d> points,
                                    const PlaneAxes& axes, double tolerance) {
  std::vector<std::uint32_t> vertices;
  for (const auto& [a, b] : edges)
    vertices.push_back(a);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<Vec2d> places;
  for (const std::uint32_t v : vertices)
    places.push_back(axes.in_plane(points[v]));
  SegmentGrid grid(places, places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    grid.add_segment(places[i], places[i], 0, std::uint32_t(i));

  std::vector<Edge> pieces;
  std::vector<std::pair<double, std::uint32_t>> on_edge;
  std::size_t comparisons = 0;
  for (const Edge& edge : edges) {
    const std::uint32_t a = edge.first, b = edge.second;
    const Vec3d start = points[a], span = points[b] - start;
    const double squared = dot(span, span);
    on_edge.clear();
    grid.visit_along(axes.in_plane(start), axes.in_plane(points[b]), tolerance, [&](auto& cell) {
      comparisons += cell.size();
      for (const std::uint32_t i : cell) {
        const std::uint32_t v = vertices[i];
        if (v == a || v == b) continue;
        const double t = dot(points[v] - start, span) / squared;
        if (!(t > 0) || !(t < 1)) continue;
        if (length(points[v] - start - span * t) <= tolerance) on_edge.push_back({t, v});
      }
    });
    if (comparisons > k_max_comparisons) return edges;
    std::sort(on_edge.begin(), on_edge.end());
    std::uint32_t from = a;
    for (const auto& [t, v] : on_edge) {
      if (v != from) pieces.push_back({from, v});
      from = v;
    }
    pieces.push_back({from, b});
  }
  return cancel_opposite(pieces);
}

class RingWalker {
public:
  RingWalker(const std::vector<Edge>& edges, std::span<const Vec3d> points, Vec3d normal)
      : points_(points), normal_(normal) {
    for (const auto& [a, b] : edges)
      leaving_[a].push_back(b);
  }

  std::vector<std::vector<std::uint32_t>> walk() {
    for (auto& [start, targets] : leaving_) {
      path_ = {start};
      place_ = {{start, 0}};
      while (!leaving_[path_.back()].empty())
        step();
    }
    return std::move(rings_);
  }

private:
  void step() {
    std::vector<std::uint32_t>& targets = leaving_[path_.back()];
    const std::size_t choice = targets.size() == 1 || path_.size() < 2 ? 0 : leftmost(targets);
    const std::uint32_t next = targets[choice];
    targets.erase(targets.begin() + std::ptrdiff_t(choice));
    const auto known = place_.find(next);
    if (known == place_.end()) {
      place_[next] = path_.size();
      path_.push_back(next);
      return;
    }
    // Back at a vertex of the path: what lies between is a ring.
    const std::size_t first = known->second;
    rings_.emplace_back(path_.begin() + std::ptrdiff_t(first), path_.end());
    for (std::size_t i = first + 1; i < path_.size(); ++i)
      place_.erase(path_[i]);
    path_.resize(first + 1);
  }

  std::size_t leftmost(const std::vector<std::uint32_t>& targets) const {
    const Vec3d here = points_[path_.back()];
    const Vec3d arriving = here - points_[path_[path_.size() - 2]];
    std::size_t best = 0;
    double best_turn = -10;
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const Vec3d going = points_[targets[i]] - here;
      double turn = std::atan2(dot(cross(arriving, going), normal_), dot(arriving, going));
      if (turn > std::numbers::pi - 1e-9) turn = -std::numbers::pi; // straight back comes last
      if (turn > best_turn) {
        best_turn = turn;
        best = i;
      }
    }
    return best;
  }

  std::span<const Vec3d> points_;
  Vec3d normal_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> leaving_;
  std::vector<std::uint32_t> path_;
  std::map<std::uint32_t, std::size_t> place_; // of the path's vertices
  std::vector<std::vector<std::uint32_t>> rings_;
};

// Whether b adds nothing between a and c: on their line, or a spike.
bool is_redundant(Vec3d a, Vec3d b, Vec3d c, double tolerance) {
  const Vec3d ac = c - a;
  const double l = length(ac);
  if (l <= tolerance) return true;
  return length(cross(b - a, ac)) <= tolerance * l;
}

// Corners that are left when every one left out lies within `tolerance` of the edge that passes it:
// from a corner the edge may turn within the angle under which it sees the discs of that radius
// around all corners since (Imai and Iri, "Polygonal Approximations of a Curve", 1988). One pass.
Ring without_straight_corners(const Ring& ring, Vec3d normal, double tolerance) {
  const std::size_t n = ring.size();
  Ring kept = {ring[0]};
  std::size_t anchor = 0;
  Vec3d axis{0, 0, 0}; // the angle is counted from here
  double low = 0, high = 0, farthest = 0;
  bool is_open = false; // whether the sector says anything yet
  for (std::size_t i = 1; i <= n; ++i) {
    const Vec3d offset = ring[i % n] - ring[anchor];
    const double distance = length(offset);
    const double angle =
        is_open ? std::atan2(dot(cross(axis, offset), normal), dot(axis, offset)) : 0.0;
    const bool turns_back = distance < farthest - tolerance;
    if (i > anchor + 1 && (turns_back || (is_open && !(angle >= low && angle <= high)))) {
      anchor = i - 1;
      kept.push_back(ring[anchor]);
      is_open = false;
      farthest = 0;
      --i; // once more, from there
      continue;
    }
    farthest = std::max(farthest, distance);
    if (!(distance > tolerance)) continue;
    const double half = std::asin(std::min(tolerance / distance, 1.0));
    if (!is_open) {
      is_open = true;
      axis = offset;
      low = -half;
      high = half;
    } else {
      low = std::max(low, angle - half);
      high = std::min(high, angle + half);
    }
  }
  return kept;
}

Ring simplify(const Ring& ring, Vec3d normal, double tolerance) {
  if (ring.size() < 3) return {};
  Ring kept = without_straight_corners(ring, normal, tolerance);
  // The start of the walk may itself be on a straight edge.
  while (kept.size() >= 3 && is_redundant(kept.back(), kept[0], kept[1], tolerance))
    kept.erase(kept.begin());
  while (kept.size() >= 3 && is_redundant(kept[kept.size() - 2], kept.back(), kept[0], tolerance))
    kept.pop_back();
  if (kept.size() < 3) kept.clear();
  return kept;
}

std::vector<Ring> separate_triangles(std::span<const Vec3d> points,
                                     std::span<const Triangle> triangles) {
  std::vector<Ring> rings;
  for (const Triangle& t : triangles)
    rings.push_back({points[t[0]], points[t[1]], points[t[2]]});
  return rings;
}

double sum_of_areas(const std::vector<Ring>& rings, Vec3d normal) {
  double sum = 0;
  for (const Ring& ring : rings)
    sum += signed_area(ring, normal);
  return sum;
}

} // namespace

double signed_area(const Ring& ring, Vec3d normal) {
  Vec3d sum{0, 0, 0};
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    sum += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return 0.5 * dot(sum, normal);
}

std::vector<Ring> trace_outline(std::span<const Vec3d> points, std::span<const Triangle> triangles,
                                Vec3d normal, double tolerance, double straight) {
  std::vector<Ring> separate = separate_triangles(points, triangles);
  const double expected = sum_of_areas(separate, normal);
  if (!(expected > 0)) return {};

  std::vector<Edge> edges;
  for (const Triangle& t : triangles)
    for (std::size_t c = 0; c < 3; ++c)
      edges.push_back({t[c], t[(c + 1) % 3]});
  edges = split_at_vertices(cancel_opposite(edges), points, PlaneAxes(normal), tolerance);
  if (has_repeated(edges)) return separate; // triangles overlap

  std::vector<Ring> traced;
  for (const auto& corners : RingWalker(edges, points, normal).walk()) {
    Ring ring;
    for (const std::uint32_t corner : corners)
      ring.push_back(points[corner]);
    traced.push_back(std::move(ring));
  }
  // More than what T-junctions cost means that the pieces did not fit.
  if (!(std::abs(sum_of_areas(traced, normal) - expected) <= k_area_tolerance * expected))
    return separate;
  std::vector<Ring> rings;
  for (const Ring& ring : traced)
    if (Ring simple = simplify(ring, normal, straight); !simple.empty())
      rings.push_back(std::move(simple));
  // Parts thinner than what may be left out keep all of their corners.
  if (!(std::abs(sum_of_areas(rings, normal) - expected) <= k_most_area_lost * expected))
    rings = std::move(traced);
  std::stable_partition(rings.begin(), rings.end(),
                        [&](const Ring& ring) { return signed_area(ring, normal) > 0; });
  return rings;
}

} // namespace openltc::scene
