// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// An edge that two triangles use in opposite directions is inside; the others are the boundary. At
// every vertex as many boundary edges arrive as leave, because that holds for each triangle and
// cancelling a pair of opposite edges keeps it; so walking along them always closes a ring.
//
// Where rings touch in a vertex the walk turns as far left as it can, and a part of the walk that
// comes back to a vertex is cut off as a ring of its own. That keeps every ring simple.

#include "openltc/scene/outline.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace openltc::scene {

namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

// Splitting at T-junctions compares edges with vertices; beyond this it is not worth its time.
constexpr std::size_t k_max_comparisons = 50'000'000;

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
                                    double tolerance) {
  std::vector<std::uint32_t> vertices;
  for (const auto& [a, b] : edges)
    vertices.push_back(a);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  if (edges.size() * vertices.size() > k_max_comparisons) return edges;

  std::vector<Edge> pieces;
  std::vector<std::pair<double, std::uint32_t>> on_edge;
  for (const auto& [a, b] : edges) {
    const Vec3d start = points[a], span = points[b] - start;
    const double squared = dot(span, span);
    on_edge.clear();
    for (const std::uint32_t v : vertices) {
      if (v == a || v == b) continue;
      const double t = dot(points[v] - start, span) / squared;
      if (!(t > 0) || !(t < 1)) continue;
      if (length(points[v] - start - span * t) <= tolerance) on_edge.push_back({t, v});
    }
    std::sort(on_edge.begin(), on_edge.end());
    std::uint32_t from = a;
    for (const auto& [t, v] : on_edge) {
      pieces.push_back({from, v});
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

Ring simplify(const Ring& ring, double tolerance) {
  Ring kept;
  for (const Vec3d& p : ring) {
    kept.push_back(p);
    while (kept.size() >= 3 &&
           is_redundant(kept[kept.size() - 3], kept[kept.size() - 2], kept.back(), tolerance))
      kept.erase(kept.end() - 2);
  }
  // The same around the seam.
  for (bool changed = true; changed && kept.size() >= 3;) {
    changed = false;
    if (is_redundant(kept[kept.size() - 2], kept.back(), kept[0], tolerance)) {
      kept.pop_back();
      changed = true;
    } else if (is_redundant(kept.back(), kept[0], kept[1], tolerance)) {
      kept.erase(kept.begin());
      changed = true;
    }
  }
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
                                Vec3d normal, double tolerance) {
  std::vector<Ring> separate = separate_triangles(points, triangles);
  const double expected = sum_of_areas(separate, normal);
  if (!(expected > 0)) return {};

  std::vector<Edge> edges;
  for (const Triangle& t : triangles)
    for (std::size_t c = 0; c < 3; ++c)
      edges.push_back({t[c], t[(c + 1) % 3]});
  edges = split_at_vertices(cancel_opposite(edges), points, tolerance);
  if (has_repeated(edges)) return separate; // triangles overlap

  std::vector<Ring> rings;
  for (const auto& corners : RingWalker(edges, points, normal).walk()) {
    Ring ring;
    for (const std::uint32_t corner : corners)
      ring.push_back(points[corner]);
    ring = simplify(ring, tolerance);
    if (!ring.empty()) rings.push_back(std::move(ring));
  }
  const double traced = sum_of_areas(rings, normal);
  // Leaving out corners may cost this much; more means that the pieces did not fit.
  if (!(std::abs(traced - expected) <= 1e-4 * expected)) return separate;
  std::stable_partition(rings.begin(), rings.end(),
                        [&](const Ring& ring) { return signed_area(ring, normal) > 0; });
  return rings;
}

} // namespace openltc::scene
