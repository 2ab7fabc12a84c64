// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Points of lights, for shadow rays and for estimates without bias: drawn by the solid angle that a
// light fills where single precision can place directions in it, by its area elsewhere.
//
// Sources: openltc/shade/triangle.glsl, polygon_points.glsl, ellipse.glsl, sphere.glsl,
// tube_points.glsl and line.glsl name them. Shadows by a ratio of two such estimates: Heitz, Hill,
// McGuire 2018, "Combining Analytic Direct Illumination and Stochastic Shadows".

#pragma once

#include "openltc/api/area_lights.h"
#include "openltc/api/polygon.h"
#include "openltc/api/surface.h"

namespace openltc {

/// \addtogroup sampling
/// @{

/// A point of a light, seen from a surface.
struct LightSample {
  bool valid = false; ///< false: no light from there reaches the surface; the sample counts as 0
  Vec3f position{0, 0, 0};  ///< on the light, world space
  Vec3f direction{0, 0, 0}; ///< to it, unit, world space
  float distance = 0;       ///< metres
  float cos_light = 0;      ///< cosine at the light, 0..1
  /// Density per steradian with which sample_light draws this direction. Of a line, which fills no
  /// solid angle, it is per steradian and metre of its width.
  float pdf = 0;
};

namespace detail {

// What the lights' shapes have of their own: how a surface sees them, the point that two random
// numbers are, and where a ray meets them.

inline bool is_usable(const Polygon& light) { return light.usable(); }

inline f32::SeenPolygon seen_by(const f32::Surface& s, const Polygon& light) {
  return f32::polygon_seen(light.view(), s.position, s.position_error2);
}
inline f32::SeenEllipse seen_by(const f32::Surface& s, const Ellipse& light) {
  return f32::ellipse_seen(dialect_of(light), s.position, s.position_error2);
}
inline f32::SeenSphere seen_by(const f32::Surface& s, const Sphere& light) {
  return f32::sphere_seen(dialect_of(light), s.position);
}
inline f32::SeenTube seen_by(const f32::Surface& s, const Tube& light) {
  return f32::tube_seen(dialect_of(light), s.position);
}

inline f32::LightPoint draw_point(const f32::Surface& s, const Polygon& light, Vec2f u) {
  return f32::sample_polygon(light.view(), seen_by(s, light), s.position, u);
}
inline f32::LightPoint draw_point(const f32::Surface& s, const Ellipse& light, Vec2f u) {
  return f32::sample_ellipse(dialect_of(light), seen_by(s, light), s.position, u);
}
inline f32::LightPoint draw_point(const f32::Surface& s, const Sphere& light, Vec2f u) {
  return f32::sample_sphere(dialect_of(light), seen_by(s, light), u);
}
inline f32::LightPoint draw_point(const f32::Surface& s, const Tube& light, Vec2f u) {
  return f32::sample_tube(dialect_of(light), seen_by(s, light), s.position, u);
}
inline f32::LightPoint draw_point(const f32::Surface& s, const Line& light, Vec2f u) {
  return f32::sample_line(f32::line_seen(s, dialect_of(light)), s.position, u.x);
}

inline f32::LightPoint meet_point(const f32::Surface& s, const Polygon& light, Vec3f direction) {
  return f32::intersect_polygon(light.view(), seen_by(s, light), s.position, direction);
}
inline f32::LightPoint meet_point(const f32::Surface& s, const Ellipse& light, Vec3f direction) {
  return f32::intersect_ellipse(dialect_of(light), seen_by(s, light), s.position, direction);
}
inline f32::LightPoint meet_point(const f32::Surface& s, const Sphere& light, Vec3f direction) {
  return f32::intersect_sphere(dialect_of(light), seen_by(s, light), direction);
}
inline f32::LightPoint meet_point(const f32::Surface& s, const Tube& light, Vec3f direction) {
  return f32::intersect_tube(dialect_of(light), seen_by(s, light), s.position, direction);
}

inline LightSample sample_of(const f32::Surface& s, const f32::LightPoint& point) {
  LightSample sample;
  const float solid_angle = f32::min(point.solid_angle, 1.0e12f);
  const float pdf = 1.0f / f32::max(solid_angle, 1.0e-38f);
  sample.valid = point.hit && point.distance > 0.0f && solid_angle > 0.0f && is_density(pdf) &&
                 is_place(point.direction * point.distance) &&
                 dot(s.frame.n, point.direction) > 0.0f &&
                 !f32::hidden_by_triangle(s, point.direction * point.distance);
  if (!sample.valid) return sample;
  sample.position = s.position + point.direction * point.distance;
  sample.direction = point.direction;
  sample.distance = point.distance;
  sample.cos_light = saturate(point.cos_light);
  sample.pdf = pdf;
  return sample;
}

} // namespace detail

/// Draws a point of a light from two random numbers in [0, 1). `light` is a Polygon, Ellipse,
/// Sphere, Tube or Line; of a line, the second number is unused.
///
/// The mean of eval_surface(surface, direction) * radiance / pdf over all samples, those that are
/// not valid counting as 0, is the reflected radiance without shadow; times the visibility of the
/// point, with it. What the shape's sampling needs to know of the surface's position is found anew
/// each time.
template <class AreaLight>
inline LightSample sample_light(const Surface& surface, const AreaLight& light, Vec2f u) {
  if (!surface.usable || !detail::is_usable(light)) return {};
  const f32::Surface& s = surface.point;
  return detail::sample_of(s, detail::draw_point(s, light, detail::unit_random(u)));
}

/// Where a ray from the surface along `direction` (world space, any length that is not 0) meets a
/// light, with the density of sample_light: what multiple importance sampling asks of a direction
/// that sample_surface drew. Not of a line, which no ray meets.
template <class AreaLight>
inline LightSample intersect_light(const Surface& surface, const AreaLight& light,
                                   Vec3f direction) {
  const Vec3f wi = detail::unit_or(direction, Vec3f(0.0f));
  if (!surface.usable || !detail::is_usable(light) || !(dot(wi, wi) > 0.5f)) return {};
  const f32::Surface& s = surface.point;
  return detail::sample_of(s, detail::meet_point(s, light, wi));
}

/// Density per steradian with which sample_light draws a direction; 0 where it leads to no light.
template <class AreaLight>
inline float pdf_light(const Surface& surface, const AreaLight& light, Vec3f direction) {
  return intersect_light(surface, light, direction).pdf;
}

/// @}

} // namespace openltc
