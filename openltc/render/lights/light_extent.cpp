// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Boxes, sums and moments of lights.

#include "openltc/render/lights/light_extent.h"

#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/line.h"

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

LightExtent extent_of(const light::PolygonLight& light, const light::PackedPolygon& packed) {
  LightExtent extent;
  if (light.vertices.empty()) return extent;
  extent.lower = extent.upper = light.vertices.front();
  for (const Vec3f& p : light.vertices) {
    extent.lower = minimum(extent.lower, p);
    extent.upper = maximum(extent.upper, p);
  }
  face_along(extent, light.normal, light.two_sided);
  extent.cosine_power = light.cosine_power;
  emit(extent, light.radiance, double(packed.area));
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

/// A symmetric matrix: xx yy zz yz xz xy.
struct Symmetric {
  double at[6] = {0, 0, 0, 0, 0, 0};

  Symmetric() = default;
  explicit Symmetric(Vec3d v)
      : at{v.x * v.x, v.y * v.y, v.z * v.z, v.y * v.z, v.x * v.z, v.x * v.y} {}
  explicit Symmetric(const float (&of)[6]) { std::copy_n(of, 6, at); }

  Symmetric& operator+=(const Symmetric& other) {
    for (int k = 0; k < 6; ++k)
      at[k] += other.at[k];
    return *this;
  }
  double trace() const { return at[0] + at[1] + at[2]; }
  void store(double scale, float (&to)[6]) const {
    for (int k = 0; k < 6; ++k)
      to[k] = float(at[k] * scale);
  }
};

Symmetric operator+(Symmetric a, const Symmetric& b) { return a += b; }
Symmetric operator*(Symmetric a, double scale) {
  for (double& v : a.at)
    v *= scale;
  return a;
}

void set_far(const light::PolygonLight& light, const light::PackedPolygon& packed, FarLight& far,
             FarError& error) {
  if (light.two_sided || light.cosine_power > 0 || light.texture >= 0 || !(packed.area > 0)) return;
  const auto vector = [](const float(&v)[3]) { return Vec3f(v[0], v[1], v[2]); };
  const PolygonView& view = packed.view;
  far.center = vector(view.centroid);
  // Along the principal axes spread_u and spread_v the area has half of their squares.
  const Symmetric covariance =
      (Symmetric(to_double(vector(view.spread_u))) + Symmetric(to_double(vector(view.spread_v)))) *
      0.5;
  covariance.store(1, far.covariance);
  error.valid = true;
  const float radiance[3] = {light.radiance.x, light.radiance.y, light.radiance.z};
  const double power = double(radiance[0]) + double(radiance[1]) + double(radiance[2]);
  for (int c = 0; c < 3; ++c)
    far.moment[c] = light.normal * (radiance[c] * packed.area);
  if (power > 0) far.channel = light.radiance * float(1 / power);
  const Vec3f flux = light.radiance * packed.area;
  const double second = covariance.trace();
  error.second = flux * float(second);
  // Cauchy and Schwarz: the mean of |p|^3 is no more than the root of those of |p|^2 and |p|^4.
  error.third = flux * float(std::sqrt(second * packed.fourth_moment));
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

/// The far form of single lights, of which the first moments vanish about their own centres.
void unite_far(std::span<const TreeLight> lights, FarLight& u, FarError& error) {
  Vec3d center(0.0);
  double total = 0; // of the sizes of all m
  for (const TreeLight& light : lights) {
    const FarLight& far = light.far;
    if (!light.far_error.valid) return;
    const double weight = power_of(far);
    center += to_double(far.center) * weight;
    total += weight;
  }
  if (!(total > 0)) return;
  error.valid = true;
  error.planar = false;
  u.center = to_float(center / total);

  // Of each channel: sums of m, of its size, of m d^T by columns, and of m times each element of
  // d d^T and the light's own covariance.
  struct Moments {
    Vec3d sum{0.0, 0.0, 0.0};
    double size = 0, second = 0, third = 0;
    Vec3d first[3] = {Vec3d(0.0), Vec3d(0.0), Vec3d(0.0)};
    Vec3d tensor[6] = {Vec3d(0.0), Vec3d(0.0), Vec3d(0.0), Vec3d(0.0), Vec3d(0.0), Vec3d(0.0)};
  } channels[3];
  Symmetric covariance;
  for (const TreeLight& light : lights) {
    const FarLight& far = light.far;
    const Vec3d d = to_double(far.center) - to_double(u.center);
    const Symmetric spread = Symmetric(d) + Symmetric(far.covariance);
    const Vec3f third = light.far_error.third;
    const float thirds[3] = {third.x, third.y, third.z};
    for (int c = 0; c < 3; ++c) {
      const Vec3d m = to_double(far.moment[c]);
      const double size = length(m);
      if (!(size > 0)) continue;
      Moments& of = channels[c];
      of.sum += m;
      of.size += size;
      of.second += size * spread.trace();
      // Minkowski: the cubic mean of |d + e| is at most |d| and that of |e|.
      const double reach = length(d) + std::cbrt(double(thirds[c]) / size);
      of.third += size * reach * reach * reach;
      of.first[0] += m * d.x;
      of.first[1] += m * d.y;
      of.first[2] += m * d.z;
      for (int k = 0; k < 6; ++k)
        of.tensor[k] += m * spread.at[k];
      covariance += spread * size;
    }
  }
  double sizes = 0;
  for (const Moments& of : channels)
    sizes += of.size;
  covariance.store(1 / sizes, u.covariance);
  for (int k = 0; k < 3; ++k)
    u.first[k] = to_float(channels[0].first[k] + channels[1].first[k] + channels[2].first[k]);
  float share[3], first_size[3], first_error[3], second_error[3];
  const Symmetric kept(u.covariance);
  for (int c = 0; c < 3; ++c) {
    const Moments& of = channels[c];
    u.moment[c] = to_float(of.sum);
    share[c] = float(of.size / sizes);
    double size = 0, first = 0, second = 0;
    for (int k = 0; k < 3; ++k) {
      size += dot(of.first[k], of.first[k]);
      const Vec3d off = of.first[k] - to_double(u.first[k]) * double(share[c]);
      first += dot(off, off);
    }
    for (int k = 0; k < 6; ++k) {
      const Vec3d off = of.tensor[k] - of.sum * kept.at[k];
      second += dot(off, off) * (k < 3 ? 1 : 2);
    }
    first_size[c] = float(std::sqrt(size));
    first_error[c] = float(std::sqrt(first));
    second_error[c] = float(std::sqrt(second));
  }
  u.channel = {share[0], share[1], share[2]};
  error.first = {first_size[0], first_size[1], first_size[2]};
  error.first_error = {first_error[0], first_error[1], first_error[2]};
  error.second_error = {second_error[0], second_error[1], second_error[2]};
  error.second = {float(channels[0].second), float(channels[1].second), float(channels[2].second)};
  error.third = {float(channels[0].third), float(channels[1].third), float(channels[2].third)};
}

} // namespace

double power_of(const FarLight& far) {
  return double(length(far.moment[0]) + length(far.moment[1]) + length(far.moment[2]));
}

TreeLight tree_light(const light::PolygonLight& light, const light::PackedPolygon& packed) {
  TreeLight tree_light{extent_of(light, packed), {}, {}};
  set_far(light, packed, tree_light.far, tree_light.far_error);
  return tree_light;
}
TreeLight tree_light(const light::EllipseLight& light) { return {extent_of(light), {}, {}}; }
TreeLight tree_light(const light::SphereLight& light) { return {extent_of(light), {}, {}}; }
TreeLight tree_light(const light::TubeLight& light) { return {extent_of(light), {}, {}}; }
TreeLight tree_light(const light::LineLight& light) { return {extent_of(light), {}, {}}; }

TreeLight textured(TreeLight light, Vec3f peak, Vec3f mean) {
  light.extent.radiance = light.extent.radiance * peak;
  light.extent.intensity = light.extent.intensity * mean * 1.01f;
  light.far_error = {};
  light.far = {};
  return light;
}

TreeLight united(std::span<const TreeLight> lights) {
  TreeLight all = lights.front();
  if (lights.size() == 1) return all;
  for (const TreeLight& light : lights.subspan(1))
    all.extent = united(all.extent, light.extent);
  all.far_error = {};
  all.far = {};
  unite_far(lights, all.far, all.far_error);
  return all;
}

} // namespace openltc::render
