// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/emissive/light_surface.h"

#include <algorithm>
#include <cmath>

namespace openltc::scene {

namespace {

double height(Vec3d offset, Vec3d normal, bool two_sided) {
  const double h = dot(offset, normal);
  return two_sided ? std::abs(h) : std::max(h, 0.0);
}

double distance_to_segment(Vec3d p, Vec3d from, Vec3d to) {
  const Vec3d along = to - from;
  const double t = std::clamp(dot(p - from, along) / dot(along, along), 0.0, 1.0);
  return length(p - from - along * t);
}

} // namespace

double distance_outside(const light::PolygonLight& light, Vec3f p) {
  return height(to_double(p) - to_double(light.vertices[0]), to_double(light.normal),
                light.two_sided);
}

double distance_outside(const light::EllipseLight& light, Vec3f p) {
  const Vec3d normal = normalize(cross(to_double(light.half_u), to_double(light.half_v)));
  return height(to_double(p) - to_double(light.center), normal, light.two_sided);
}

double distance_outside(const light::SphereLight& light, Vec3f p) {
  return std::max(length(to_double(p) - to_double(light.center)) - double(light.radius), 0.0);
}

double distance_outside(const light::TubeLight& light, Vec3f p) {
  const Vec3d q = to_double(p), from = to_double(light.from), to = to_double(light.to);
  const double radius = double(light.radius);
  if (light.caps == light::TubeCaps::round)
    return std::max(distance_to_segment(q, from, to) - radius, 0.0);
  const Vec3d axis = normalize(to - from);
  const double t = dot(q - from, axis);
  const double across = length(q - from - axis * t) - radius;
  const double along = std::max(-t, t - length(to - from));
  return std::hypot(std::max(across, 0.0), std::max(along, 0.0));
}

double distance_outside(const light::LineLight& light, Vec3f p) {
  return distance_to_segment(to_double(p), to_double(light.from), to_double(light.to));
}

double reach_of(const light::PolygonLight& light) {
  double largest = 0;
  for (const Vec3f v : light.vertices)
    largest = std::max(largest, 0.5 * length(to_double(v) - to_double(light.vertices[0])));
  return largest;
}

double reach_of(const light::EllipseLight& light) {
  return std::max(length(to_double(light.half_u)), length(to_double(light.half_v)));
}

double reach_of(const light::SphereLight& light) { return double(light.radius); }

double reach_of(const light::TubeLight& light) {
  return 0.5 * length(to_double(light.to) - to_double(light.from)) + double(light.radius);
}

double reach_of(const light::LineLight& light) {
  return 0.5 * length(to_double(light.to) - to_double(light.from));
}

} // namespace openltc::scene
