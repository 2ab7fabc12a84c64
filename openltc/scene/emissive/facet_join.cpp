// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Source: Garland, Willmott, Heckbert 2001, "Hierarchical Face Clustering on Polygonal Surfaces":
// clusters are joined along shared edges, the cheapest pair first. Our price of a pair is the area
// that is lost, |S_a| + |S_b| - |S_a + S_b|, of the vector areas S: whatever has a given border has
// the same vector area, so the far field of what is joined stays what it was, and its flux falls by
// this much before the emission is scaled up.

#include "openltc/scene/emissive/facet_planes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <unordered_map>
#include <utility>

namespace openltc::scene {

namespace {

// A plane of more triangles is large enough as it is; checking its corners anew for every neighbour
// would take the square of their number.
constexpr std::size_t k_most_joined = 1024;

struct Cluster {
  FacetPlane plane;
  Vec3d vector_area{0, 0, 0};
  Vec3d center_sum{0, 0, 0}; // times area
  double area = 0;
  Vec3f lowest, highest; // radiance
  std::vector<std::uint32_t> neighbours;
  std::uint32_t version = 0;
  bool is_gone = false;
};

struct JoinCandidate {
  double price;
  std::uint32_t a, b, version_a, version_b;
  bool operator<(const JoinCandidate& other) const { // the cheapest is the greatest
    if (price != other.price) return price > other.price;
    return std::pair(a, b) > std::pair(other.a, other.b);
  }
};

class PlaneJoiner {
public:
  PlaneJoiner(const WeldedMesh& mesh, std::vector<FacetPlane> planes,
              const std::vector<Vec3f>& radiances, const JoinLimits& limits, bool two_sided)
      : mesh_(mesh), limits_(limits), cos_angle_(std::cos(limits.angle_rad)),
        two_sided_(two_sided) {
    for (std::size_t i = 0; i < planes.size(); ++i) {
      Cluster cluster;
      cluster.plane = std::move(planes[i]);
      cluster.lowest = cluster.highest = radiances[i];
      for (const auto& t : cluster.plane.triangles) {
        const Vec3d a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
        const Vec3d doubled = cross(b - a, c - a);
        const double area = 0.5 * length(doubled);
        cluster.vector_area += doubled * 0.5;
        cluster.center_sum += (a + b + c) * (area / 3);
        cluster.area += area;
      }
      clusters_.push_back(std::move(cluster));
    }
    find_neighbours();
  }

  std::vector<FacetPlane> join() {
    for (std::uint32_t i = 0; i < clusters_.size(); ++i)
      for (const std::uint32_t k : clusters_[i].neighbours)
        if (i < k) offer(i, k);
    while (!queue_.empty()) {
      const JoinCandidate next = queue_.top();
      queue_.pop();
      Cluster &a = clusters_[next.a], &b = clusters_[next.b];
      if (a.is_gone || b.is_gone || a.version != next.version_a || b.version != next.version_b)
        continue;
      if (may_join(a, b)) unite(next.a, next.b);
    }
    std::vector<FacetPlane> joined;
    for (Cluster& cluster : clusters_)
      if (!cluster.is_gone) joined.push_back(std::move(cluster.plane));
    return joined;
  }

private:
  void find_neighbours() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> users;
    for (std::uint32_t i = 0; i < clusters_.size(); ++i)
      for (const auto& t : clusters_[i].plane.triangles)
        for (std::size_t c = 0; c < 3; ++c) {
          auto& list = users[std::minmax(t[c], t[(c + 1) % 3])];
          if (list.empty() || list.back() != i) list.push_back(i);
        }
    for (const auto& [edge, list] : users)
      // An edge of many sheets joins none: which of them go on smoothly is not known.
      if (list.size() == 2) {
        clusters_[list[0]].neighbours.push_back(list[1]);
        clusters_[list[1]].neighbours.push_back(list[0]);
      }
    for (Cluster& cluster : clusters_)
      tidy(cluster.neighbours);
  }

  static void tidy(std::vector<std::uint32_t>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  double sign_between(const Cluster& a, const Cluster& b) const {
    return two_sided_ && dot(a.vector_area, b.vector_area) < 0 ? -1.0 : 1.0;
  }

  void offer(std::uint32_t i, std::uint32_t k) {
    if (i > k) std::swap(i, k);
    const Cluster &a = clusters_[i], &b = clusters_[k];
    const Vec3d sum = a.vector_area + b.vector_area * sign_between(a, b);
    const double price = length(a.vector_area) + length(b.vector_area) - length(sum);
    queue_.push({price, i, k, a.version, b.version});
  }

  bool may_join(const Cluster& a, const Cluster& b) const {
    if (a.plane.triangles.size() + b.plane.triangles.size() > k_most_joined) return false;
    const auto alike = [&](float low_a, float low_b, float high_a, float high_b) {
      const float high = std::max(high_a, high_b), low = std::min(low_a, low_b);
      return double(high - low) <= limits_.radiance * double(high);
    };
    if (!alike(a.lowest.x, b.lowest.x, a.highest.x, b.highest.x) ||
        !alike(a.lowest.y, b.lowest.y, a.highest.y, b.highest.y) ||
        !alike(a.lowest.z, b.lowest.z, a.highest.z, b.highest.z))
      return false;
    const double sign = sign_between(a, b);
    const Vec3d sum = a.vector_area + b.vector_area * sign;
    if (!(length(sum) > 0)) return false;
    const Vec3d normal = normalize(sum);
    const Vec3d center = (a.center_sum + b.center_sum) / (a.area + b.area);
    return fits(a, 1, normal, center) && fits(b, sign, normal, center);
  }

  bool fits(const Cluster& cluster, double sign, Vec3d normal, Vec3d center) const {
    for (const auto& t : cluster.plane.triangles) {
      const Vec3d a = mesh_.points[t[0]], b = mesh_.points[t[1]], c = mesh_.points[t[2]];
      const Vec3d doubled = cross(b - a, c - a);
      if (!(sign * dot(doubled, normal) >= cos_angle_ * length(doubled))) return false;
      for (const Vec3d p : {a, b, c})
        if (!(std::abs(dot(p - center, normal)) <= limits_.distance)) return false;
    }
    return true;
  }

  void unite(std::uint32_t i, std::uint32_t k) {
    // The longer list of neighbours stays.
    if (clusters_[i].neighbours.size() < clusters_[k].neighbours.size()) std::swap(i, k);
    Cluster &to = clusters_[i], &from = clusters_[k];
    const double sign = sign_between(to, from);
    for (auto t : from.plane.triangles) {
      if (sign < 0) std::swap(t[1], t[2]);
      to.plane.triangles.push_back(t);
    }
    to.plane.members.insert(to.plane.members.end(), from.plane.members.begin(),
                            from.plane.members.end());
    to.vector_area += from.vector_area * sign;
    to.center_sum += from.center_sum;
    to.area += from.area;
    const auto merge = [](Vec3f& into, Vec3f other, const auto& pick) {
      into = Vec3f(pick(into.x, other.x), pick(into.y, other.y), pick(into.z, other.z));
    };
    merge(to.lowest, from.lowest, [](float x, float y) { return std::min(x, y); });
    merge(to.highest, from.highest, [](float x, float y) { return std::max(x, y); });
    from.is_gone = true;
    ++to.version;
    for (const std::uint32_t n : from.neighbours)
      if (n != i) {
        to.neighbours.push_back(n);
        std::replace(clusters_[n].neighbours.begin(), clusters_[n].neighbours.end(), k, i);
      }
    std::erase_if(to.neighbours, [&](std::uint32_t n) { return n == k || n == i; });
    tidy(to.neighbours);
    from = Cluster{};
    from.is_gone = true;
    for (const std::uint32_t n : to.neighbours)
      if (!clusters_[n].is_gone) offer(i, n);
  }

  const WeldedMesh& mesh_;
  JoinLimits limits_;
  double cos_angle_;
  bool two_sided_;
  std::vector<Cluster> clusters_;
  std::priority_queue<JoinCandidate> queue_;
};

} // namespace

std::vector<FacetPlane> join_planes(const WeldedMesh& mesh, std::vector<FacetPlane> planes,
                                    const std::vector<Vec3f>& radiances, const JoinLimits& limits,
                                    bool two_sided) {
  return PlaneJoiner(mesh, std::move(planes), radiances, limits, two_sided).join();
}

} // namespace openltc::scene
