// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/view/backdrop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace openltc::scene {

namespace {

constexpr double k_thin = 0.2;       // thickness over diagonal: a hilly ground still is one
constexpr double k_stands_out = 0.1; // over the diagonal of what stands there: less is a print
constexpr double k_flat_share = 0.9;
constexpr double k_seen_around = 0.4;
constexpr int k_directions = 64;

Vec3d corner(const Mesh& mesh, std::uint32_t triangle, std::size_t which) {
  return to_double(mesh.positions[mesh.triangles[triangle][which]]);
}

/// Largest eigenvalue, as a share of all, and its direction.
struct MainNormal {
  Vec3d normal{0, 0, 0};
  double share = 0;
};

MainNormal main_normal(const Scene& scene, const std::vector<SubjectPart>& parts) {
  double m[3][3] = {};
  for (const SubjectPart& part : parts)
    for (const std::uint32_t triangle : part.triangles) {
      const Vec3d a = area_vector(scene.meshes[part.mesh], triangle);
      const double area = length(a);
      if (!(area > 0)) continue;
      const double v[3] = {a.x, a.y, a.z};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          m[i][j] += v[i] * v[j] / area;
    }
  const double trace = m[0][0] + m[1][1] + m[2][2];
  if (!(trace > 0)) return {};
  // Powers of the matrix by squaring: its columns turn to the largest eigenvector.
  double p[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      p[i][j] = m[i][j] / trace;
  for (int step = 0; step < 12; ++step) {
    double q[3][3] = {};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k)
          q[i][j] += p[i][k] * p[k][j];
    const double scale = q[0][0] + q[1][1] + q[2][2];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        p[i][j] = q[i][j] / scale;
  }
  int best = 0;
  for (int i = 1; i < 3; ++i)
    if (p[i][i] > p[best][best]) best = i;
  MainNormal result;
  result.normal = normalize(Vec3d(p[0][best], p[1][best], p[2][best]));
  const Vec3d& n = result.normal;
  const Vec3d mn(m[0][0] * n.x + m[0][1] * n.y + m[0][2] * n.z,
                 m[1][0] * n.x + m[1][1] * n.y + m[1][2] * n.z,
                 m[2][0] * n.x + m[2][1] * n.y + m[2][2] * n.z);
  result.share = dot(n, mn) / trace;
  return result;
}

struct Interval {
  double lower = 1e300, upper = -1e300;
  void add(double x) {
    lower = std::min(lower, x);
    upper = std::max(upper, x);
  }
  double size() const { return std::max(upper - lower, 0.0); }
  bool holds(double x) const { return lower <= x && x <= upper; }
};

enum class Thin { no, backdrop, other };

Thin ground_or_wall(const Scene& scene, const SubjectPart& part, const Bounds& rest) {
  const MainNormal main = main_normal(scene, {part});
  if (!(main.share > 0)) return Thin::no;
  const Vec3d n = main.normal;
  const Vec3d u = normalize(cross(n, std::abs(n.y) < 0.9 ? Vec3d(0, 1, 0) : Vec3d(1, 0, 0)));
  const Vec3d v = cross(n, u);
  Interval along, across_u, across_v, of_rest;
  for (const std::uint32_t triangle : part.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d p = corner(scene.meshes[part.mesh], triangle, i);
      along.add(dot(p, n));
      across_u.add(dot(p, u));
      across_v.add(dot(p, v));
    }
  const double diagonal = std::hypot(along.size(), across_u.size(), across_v.size());
  if (along.size() > k_thin * diagonal) return Thin::no;
  for (int i = 0; i < 8; ++i)
    of_rest.add(dot(n, Vec3d(double(i & 1 ? rest.upper.x : rest.lower.x),
                             double(i & 2 ? rest.upper.y : rest.lower.y),
                             double(i & 4 ? rest.upper.z : rest.lower.z))));
  const double rest_diagonal = length(to_double(rest.upper) - to_double(rest.lower));
  const Vec3d middle = (to_double(rest.lower) + to_double(rest.upper)) * 0.5;
  const bool is_before = across_u.holds(dot(middle, u)) && across_v.holds(dot(middle, v));
  return of_rest.size() >= k_stands_out * rest_diagonal && is_before ? Thin::backdrop : Thin::other;
}

// How far along `direction` from `origin` the plane of a triangle is met inside it, and whether on
// its front; a negative distance for none. Möller, Trumbore, "Fast, Minimum Storage Ray-Triangle
// Intersection", 1997.
double meet(const Mesh& mesh, std::uint32_t triangle, Vec3d origin, Vec3d direction,
            bool& on_front) {
  const Vec3d a = corner(mesh, triangle, 0), ab = corner(mesh, triangle, 1) - a,
              ac = corner(mesh, triangle, 2) - a;
  const Vec3d h = cross(direction, ac);
  const double det = dot(ab, h);
  if (det == 0) return -1;
  const Vec3d from = origin - a;
  const double u = dot(from, h) / det;
  const Vec3d q = cross(from, ab);
  const double v = dot(direction, q) / det;
  if (u < 0 || v < 0 || u + v > 1) return -1;
  on_front = det > 0;
  return dot(ac, q) / det;
}

bool is_all_around(const Scene& scene, const SubjectPart& part, const Bounds& rest) {
  const Mesh& mesh = scene.meshes[part.mesh];
  const bool two_sided = scene.materials[std::size_t(mesh.material)].double_sided;
  const Vec3d middle = (to_double(rest.lower) + to_double(rest.upper)) * 0.5;
  std::array<double, k_directions> nearest;
  nearest.fill(1e300);
  std::array<bool, k_directions> is_seen{};
  for (int i = 0; i < k_directions; ++i) { // a spiral from pole to pole, even in solid angle
    const double y = 1 - (2 * i + 1.0) / k_directions, r = std::sqrt(1 - y * y);
    const double turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const Vec3d direction(r * std::cos(turn), y, r * std::sin(turn));
    for (const std::uint32_t triangle : part.triangles) {
      bool on_front = false;
      const double t = meet(mesh, triangle, middle, direction, on_front);
      if (t <= 0 || t >= nearest[std::size_t(i)]) continue;
      nearest[std::size_t(i)] = t;
      is_seen[std::size_t(i)] = on_front || two_sided;
    }
  }
  return double(std::count(is_seen.begin(), is_seen.end(), true)) >= k_seen_around * k_directions;
}

} // namespace

Vec3d area_vector(const Mesh& mesh, std::uint32_t triangle) {
  const Vec3d a = corner(mesh, triangle, 0);
  return cross(corner(mesh, triangle, 1) - a, corner(mesh, triangle, 2) - a) * 0.5;
}

Vec3d common_normal(const Scene& scene, const std::vector<SubjectPart>& parts) {
  const MainNormal main = main_normal(scene, parts);
  return main.share >= k_flat_share ? main.normal : Vec3d(0, 0, 0);
}

bool is_backdrop(const Scene& scene, const SubjectPart& part, const Bounds& rest) {
  const Thin thin = ground_or_wall(scene, part, rest);
  // A thin part fills half of all directions of what lies flat on it, and is nothing around it.
  return thin == Thin::no ? is_all_around(scene, part, rest) : thin == Thin::backdrop;
}

} // namespace openltc::scene
