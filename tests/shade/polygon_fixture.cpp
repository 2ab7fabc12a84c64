// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "tests/shade/polygon_fixture.h"

#include "openltc/api/polygon_moments.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace openltc::testing {

namespace {

// Gauss-Legendre points and weights on [0, 1], 8 points.
constexpr std::array<double, 8> k_point = {
    0.019855071751231884, 0.10166676129318663, 0.2372337950418355,  0.40828267875217511,
    0.59171732124782489,  0.7627662049581645,  0.89833323870681337, 0.98014492824876812};
constexpr std::array<double, 8> k_weight = {
    0.050614268145188130, 0.11119051722668724, 0.15685332293894364, 0.18134189168918100,
    0.18134189168918100,  0.15685332293894364, 0.11119051722668724, 0.050614268145188130};

struct Integrand {
  f64::Lobe lobe;
  Vec3d normal; // of the plane, shading space

  // Density times the solid angle per area.
  double operator()(Vec3d x) const {
    const double distance2 = dot(x, x);
    const Vec3d w = x / std::sqrt(distance2);
    return f64::eval_lobe(lobe, w) * std::abs(dot(w, normal)) / distance2;
  }
};

double gauss_triangle(const Integrand& f, Vec3d a, Vec3d b, Vec3d c) {
  const double area2 = length(cross(b - a, c - a));
  double sum = 0;
  for (std::size_t i = 0; i < k_point.size(); ++i) {
    for (std::size_t j = 0; j < k_point.size(); ++j) {
      // Collapsed square: (s, t) to a + s (b - a) + s t (c - b).
      const double s = k_point[i], t = k_point[j];
      sum += k_weight[i] * k_weight[j] * s * f(a + (b - a) * s + (c - b) * (s * t));
    }
  }
  return sum * area2;
}

double refine(const Integrand& f, Vec3d a, Vec3d b, Vec3d c, double whole, double tolerance,
              int depth) {
  const Vec3d ab = (a + b) * 0.5, bc = (b + c) * 0.5, ca = (c + a) * 0.5;
  const std::array<std::array<Vec3d, 3>, 4> parts = {
      {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}};
  std::array<double, 4> value{};
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    value[k] = gauss_triangle(f, parts[k][0], parts[k][1], parts[k][2]);
    sum += value[k];
  }
  if (depth == 0 || std::abs(sum - whole) < tolerance) return sum;
  double refined = 0;
  for (std::size_t k = 0; k < 4; ++k)
    refined +=
        refine(f, parts[k][0], parts[k][1], parts[k][2], value[k], tolerance * 0.5, depth - 1);
  return refined;
}

// The part of a convex polygon with dot(direction, x) >= 0.
std::vector<Vec3d> clip(const std::vector<Vec3d>& points, Vec3d direction) {
  std::vector<Vec3d> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3d a = points[i], b = points[(i + 1) % points.size()];
    const double da = dot(direction, a), db = dot(direction, b);
    if (da >= 0) kept.push_back(a);
    if ((da >= 0) != (db >= 0)) kept.push_back(a + (b - a) * (da / (da - db)));
  }
  return kept;
}

double clipped_triangle(const Integrand& f, Vec3d a, Vec3d b, Vec3d c, double tolerance,
                        const Vec3d* front_shading) {
  std::vector<Vec3d> convex = {a, b, c};
  if (front_shading) convex = clip(convex, *front_shading);
  convex = clip(convex, Vec3d(0, 0, 1));
  convex = clip(convex, Vec3d(f.lobe.m20, 0, f.lobe.m22));
  double sum = 0;
  for (std::size_t i = 2; i < convex.size(); ++i) {
    const double whole = gauss_triangle(f, convex[0], convex[i - 1], convex[i]);
    sum += refine(f, convex[0], convex[i - 1], convex[i], whole, tolerance, 14);
  }
  return sum;
}

} // namespace

TestPolygon::TestPolygon(const std::vector<Ring>& rings, Vec3d origin, Vec3d axis_u, Vec3d axis_v,
                         bool two_sided) {
  const Vec3d normal = cross(axis_u, axis_v);
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      const Vec2d p = ring[i % ring.size()];
      const Vec3d x = origin + axis_u * p.x + axis_v * p.y;
      points_.insert(points_.end(), {float(x.x), float(x.y), float(x.z), i == 0 ? 1.0f : 0.0f});
      in_plane_.insert(in_plane_.end(), {float(p.x), float(p.y)});
    }
  }
  view_.points = points_.data();
  view_.in_plane = in_plane_.data();
  view_.point_count = int(points_.size() / 4);
  view_.two_sided = two_sided;
  std::vector<Vec2d> flat;
  for (std::size_t i = 0; i < in_plane_.size(); i += 2)
    flat.push_back({double(in_plane_[i]), double(in_plane_[i + 1])});
  const auto starts_ring = [&](std::size_t i) { return points_[4 * i + 3] != 0.0f; };
  const PolygonMoments moments = polygon_moments(flat, starts_ring);
  view_.area = float(moments.area);
  for (const Vec2d& p : flat)
    view_.radius = std::max(view_.radius,
                            float(std::hypot(p.x - moments.centroid.x, p.y - moments.centroid.y)));
  // As lights are packed.
  if (flat.size() == 5) {
    const Vec2d gap = flat[0] - flat[1] + flat[2] - flat[3];
    view_.parallelogram = std::hypot(gap.x, gap.y) <= 1e-6f * view_.radius;
  }
  const auto store = [](Vec3d v, float* to) {
    to[0] = float(v.x);
    to[1] = float(v.y);
    to[2] = float(v.z);
  };
  store(origin, view_.origin);
  store(axis_u, view_.axis_u);
  store(axis_v, view_.axis_v);
  store(normal, view_.normal);
  const auto in_world = [&](Vec2d p) { return axis_u * p.x + axis_v * p.y; };
  store(origin + in_world(moments.centroid), view_.centroid);
  store(in_world(moments.spread_u), view_.spread_u);
  store(in_world(moments.spread_v), view_.spread_v);
}

Ring rectangle(double width, double height, Vec2d center) {
  const double x = width / 2, y = height / 2;
  return {Vec2d(center.x - x, center.y - y), Vec2d(center.x + x, center.y - y),
          Vec2d(center.x + x, center.y + y), Vec2d(center.x - x, center.y + y)};
}

Ring l_shape(double size) {
  const double s = size / 2;
  return {Vec2d(-s, -s),         Vec2d(s, -s),     Vec2d(s, -s / 3),
          Vec2d(-s / 4, -s / 3), Vec2d(-s / 4, s), Vec2d(-s, s)};
}

Ring star(int spikes, double outer, double inner) {
  Ring ring;
  for (int i = 0; i < 2 * spikes; ++i) {
    const double phi = i * f64::k_pi / spikes + 0.1;
    const double r = i % 2 == 0 ? outer : inner;
    ring.push_back(Vec2d(r * std::cos(phi), r * std::sin(phi)));
  }
  return ring;
}

Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

double brute_force_integral(const PolygonView& polygon, Vec3d position, const f64::Frame& frame,
                            const f64::Lobe& lobe, double tolerance, const Vec3d* front) {
  const Vec3d front_shading = front ? f64::to_shading(frame, *front) : Vec3d(0.0);
  const Vec3d normal = f64::polygon_normal(polygon);
  const double height = dot(f64::polygon_origin(polygon) - position, normal);
  if (height >= 0 && !polygon.two_sided) return 0;
  const Integrand f{lobe, f64::to_shading(frame, normal)};

  // Triangles from the first point to every edge; those wound the other way count as negative.
  const Vec3d pivot = f64::to_shading(frame, f64::polygon_point(polygon, 0) - position);
  double sum = 0;
  Vec3d a;
  for (int i = 0; i < polygon.point_count; ++i) {
    const Vec3d b = f64::to_shading(frame, f64::polygon_point(polygon, i) - position);
    if (!f64::polygon_starts_ring(polygon, i)) {
      const double winding = dot(cross(a - pivot, b - pivot), f.normal);
      if (winding != 0)
        sum += std::copysign(
            clipped_triangle(f, pivot, a, b, tolerance, front ? &front_shading : nullptr), winding);
    }
    a = b;
  }
  return sum;
}

bool inside_by_winding(const PolygonView& polygon, Vec2d point) {
  double angle = 0;
  Vec2d a;
  for (int i = 0; i < polygon.point_count; ++i) {
    const Vec2d b = f64::polygon_point_in_plane(polygon, i) - point;
    if (!f64::polygon_starts_ring(polygon, i))
      angle += std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
    a = b;
  }
  return std::abs(angle) > f64::k_pi;
}

Setting random_setting(Random& random, double alpha) {
  Setting s;
  const Vec3d n = random.sphere();
  Vec3d wo = random.sphere();
  if (dot(wo, n) < 0) wo = -wo;
  s.frame = f64::shading_frame(n, wo);
  const double cos_theta = dot(wo, n);
  const Vec4d abcd(cos_theta + random.uniform(0, 0.6), random.uniform(-1, 0.2),
                   random.uniform(0, 1.2), 0.1 + 2 * cos_theta);
  s.lobe = f64::lobe_from_mirror(abcd, alpha, cos_theta);
  s.position = Vec3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  return s;
}

std::vector<Ring> shape(int kind) {
  switch (kind) {
  case 0:
    return {rectangle(1.5, 0.8)};
  case 1:
    return {l_shape(1.6)};
  case 2:
    return {star(5, 1.0, 0.4)};
  case 3:
    return {rectangle(1.8, 1.6), reversed(rectangle(0.7, 0.5, {0.3, 0.2}))};
  default:
    return {rectangle(0.6, 0.6, {-0.6, 0}), star(3, 0.5, 0.2)};
  }
}

Plane random_plane(Random& random, Vec3d position) {
  const f64::Frame f = f64::shading_frame(random.sphere(), random.sphere());
  Vec3d origin = position + random.sphere() * random.uniform(0.4, 2.0);
  // Its emitting side, t1 x t2 = n, towards the position.
  if (dot(origin - position, f.n) > 0) return {origin, f.t2, f.t1};
  return {origin, f.t1, f.t2};
}

} // namespace openltc::testing
