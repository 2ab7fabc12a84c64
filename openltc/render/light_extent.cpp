// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Boxes, sums and moments of lights.

#include "openltc/render/light_extent.h"

#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/line.h"
#include "openltc/light/polygon.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace openltc::render {

namespace {

constexpr float k_pi = std::numbers::pi_v<float>;

Vec3f minimum(Vec3f a, Vec3f b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vec3f maximum(Vec3f a, Vec3f b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

void emit(LightExtent& extent, Vec3f radiance, double projected_area) {
  extent.radiance = radiance;
  extent.area = float(projected_area);
  extent.intensity = radiance * extent.area;
}

/// A convex surface that shines in all directions.
void face_everywhere(LightExtent& extent) {
  extent.normal_lower = Vec3f(-1);
  extent.normal_upper = Vec3f(1);
}

void face_along(LightExtent& extent, Vec3f normal, bool two_sided) {
  extent.normal_lower = extent.normal_upper = normal;
  if (two_sided) {
    extent.normal_lower = minimum(normal, -normal);
    extent.normal_upper = maximum(normal, -normal);
  }
}

LightExtent extent_of(const light::PolygonLight& light) {
  LightExtent extent;
  if (light.vertices.empty()) return extent;
  extent.lower = extent.upper = light.vertices.front();
  for (const Vec3f& p : light.vertices) {
    extent.lower = minimum(extent.lower, p);
    extent.upper = maximum(extent.upper, p);
  }
  face_along(extent, light.normal, light.two_sided);
  extent.cosine_power = light.cosine_power;
  emit(extent, light.radiance, light::area(light));
  return extent;
}

LightExtent extent_of(const light::EllipseLight& light) {
  LightExtent extent;
  const Vec3f u = light.half_u, v = light.half_v;
  const Vec3f half(std::hypot(u.x, v.x), std::hypot(u.y, v.y), std::hypot(u.z, v.z));
  extent.lower = light.center - half;
  extent.upper = light.center + half;
  face_along(extent, normalize(cross(u, v)), light.two_sided);
  extent.cosine_power = light.cosine_power;
  emit(extent, light.radiance, light::area(light));
  return extent;
}

LightExtent extent_of(const light::SphereLight& light) {
  LightExtent extent;
  extent.lower = light.center - Vec3f(light.radius);
  extent.upper = light.center + Vec3f(light.radius);
  face_everywhere(extent);
  // Seen from d the sphere has 2 pi (1 - sqrt(1 - r^2/d^2)) <= pi r^2 / (d - r)^2.
  emit(extent, light.radiance, double(k_pi) * double(light.radius) * double(light.radius));
  return extent;
}

LightExtent extent_of(const light::TubeLight& light) {
  LightExtent extent;
  extent.lower = minimum(light.from, light.to) - Vec3f(light.radius);
  extent.upper = maximum(light.from, light.to) + Vec3f(light.radius);
  face_everywhere(extent);
  // A slice of the side shows at most its diameter: the angle between its normal and the viewer is
  // at least the one around the axis. The ends show at most a disk each, of flat ones only one.
  const double r = double(light.radius);
  const double ends = light.caps == light::TubeCaps::round  ? 2
                      : light.caps == light::TubeCaps::flat ? 1
                                                            : 0;
  emit(extent, light.radiance,
       2 * r * double(length(light.to - light.from)) + ends * double(k_pi) * r * r);
  return extent;
}

LightExtent extent_of(const light::LineLight& light) {
  LightExtent extent;
  extent.lower = minimum(light.from, light.to);
  extent.upper = maximum(light.from, light.to);
  face_everywhere(extent);
  // No width, so no finite radiance: next to it nothing is bounded.
  extent.radiance = Vec3f(k_unbounded);
  extent.area = k_unbounded;
  extent.intensity = light.intensity_per_metre * length(light.to - light.from);
  return extent;
}

FarLight far_of(const light::PolygonLight& light) {
  FarLight far;
  if (light.two_sided || light.cosine_power > 0 || light.texture >= 0 || light.vertices.empty())
    return far;
  const Vec3d normal = to_double(light.normal), origin = to_double(light.vertices.front());
  // Signed triangles of a fan around a point, ring by ring.
  const auto over_triangles = [&](Vec3d apex, const auto& visit) {
    for (std::size_t r = 0; r < light.ring_end.size(); ++r) {
      const auto ring = light::ring_vertices(light, r);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec3d a = to_double(ring[i]) - apex,
                    b = to_double(ring[(i + 1) % ring.size()]) - apex;
        visit(a, b, 0.5 * dot(cross(a, b), normal));
      }
    }
  };
  double area = 0;
  Vec3d center(0.0);
  over_triangles(origin, [&](Vec3d a, Vec3d b, double triangle) {
    area += triangle;
    center += (a + b) * (triangle / 3);
  });
  if (!(area > 0)) return far;
  center = origin + center / area;
  double second = 0;
  over_triangles(center, [&](Vec3d a, Vec3d b, double triangle) {
    second += triangle / 6 * (dot(a, a) + dot(b, b) + dot(a, b));
  });
  far.valid = true;
  far.center = Vec3f(float(center.x), float(center.y), float(center.z));
  const float radiance[3] = {light.radiance.x, light.radiance.y, light.radiance.z};
  for (int c = 0; c < 3; ++c)
    far.moment[c] = light.normal * (radiance[c] * float(area));
  far.second = light.radiance * float(std::max(second, 0.0));
  return far;
}

LightExtent united(const LightExtent& a, const LightExtent& b) {
  LightExtent u;
  u.lower = minimum(a.lower, b.lower);
  u.upper = maximum(a.upper, b.upper);
  u.normal_lower = minimum(a.normal_lower, b.normal_lower);
  u.normal_upper = maximum(a.normal_upper, b.normal_upper);
  u.radiance = minimum(a.radiance + b.radiance, Vec3f(k_unbounded));
  u.intensity = a.intensity + b.intensity;
  u.area = std::min(a.area + b.area, k_unbounded);
  u.cosine_power = std::min(a.cosine_power, b.cosine_power);
  return u;
}

double power_of(const FarLight& far) {
  return double(length(far.moment[0]) + length(far.moment[1]) + length(far.moment[2]));
}

/// The far form of lights that have one each, of which the first moments vanish about their own
/// centres.
FarLight united_far(std::span<const TreeLight> lights) {
  FarLight u;
  Vec3d center(0.0);
  double total = 0;
  for (const TreeLight& light : lights) {
    const FarLight& far = light.far;
    if (!far.valid) return u;
    const double weight = power_of(far);
    center += to_double(far.center) * weight;
    total += weight;
  }
  if (!(total > 0)) return u;
  u.valid = true;
  u.planar = false;
  u.center = to_float(center / total);
  double first[3], second[3];
  for (int c = 0; c < 3; ++c) {
    Vec3d sum(0.0), columns[3] = {Vec3d(0.0), Vec3d(0.0), Vec3d(0.0)};
    second[c] = 0;
    for (const TreeLight& light : lights) {
      const FarLight& far = light.far;
      const Vec3d m = to_double(far.moment[c]);
      const Vec3d d = to_double(far.center) - to_double(u.center);
      sum += m;
      columns[0] += m * d.x;
      columns[1] += m * d.y;
      columns[2] += m * d.z;
      const float own[3] = {far.second.x, far.second.y, far.second.z};
      second[c] += double(own[c]) + length(m) * dot(d, d);
    }
    u.moment[c] = to_float(sum);
    first[c] = std::sqrt(dot(columns[0], columns[0]) + dot(columns[1], columns[1]) +
                         dot(columns[2], columns[2]));
  }
  u.first = {float(first[0]), float(first[1]), float(first[2])};
  u.second = {float(second[0]), float(second[1]), float(second[2])};
  return u;
}

} // namespace

TreeLight tree_light(const light::PolygonLight& light) { return {extent_of(light), far_of(light)}; }
TreeLight tree_light(const light::EllipseLight& light) { return {extent_of(light), {}}; }
TreeLight tree_light(const light::SphereLight& light) { return {extent_of(light), {}}; }
TreeLight tree_light(const light::TubeLight& light) { return {extent_of(light), {}}; }
TreeLight tree_light(const light::LineLight& light) { return {extent_of(light), {}}; }

TreeLight textured(TreeLight light, Vec3f peak, Vec3f mean) {
  light.extent.radiance = light.extent.radiance * peak;
  light.extent.intensity = light.extent.intensity * mean * 1.01f;
  light.far = {};
  return light;
}

TreeLight united(std::span<const TreeLight> lights) {
  TreeLight all = lights.front();
  if (lights.size() == 1) return all;
  for (const TreeLight& light : lights.subspan(1))
    all.extent = united(all.extent, light.extent);
  all.far = united_far(lights);
  return all;
}

} // namespace openltc::render
