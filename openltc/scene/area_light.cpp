// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/area_light.h"

#include "openltc/base/quote.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace openltc::scene {

namespace {

// Corners and radii that differ by less, relative to the light's size, do so by rounding.
constexpr double k_rounding = 1e-4;

// What keeps any light from being one; empty when nothing does.
std::string obstacle(const light::Emitter& light) {
  if (light.texture >= 0) return "a textured light";
  if (light.cosine_power != 0) return "a light with a cosine power";
  return "";
}

// Sets the axes from the directions of width and height, which are all but perpendicular.
void set_axes(AreaLight& area, Vec3d x, Vec3d y) {
  area.width = length(x);
  area.height = length(y);
  area.x = x / area.width;
  area.z = normalize(cross(area.x, y));
  area.y = cross(area.z, area.x);
}

std::string read(const light::PolygonLight& light, AreaLight& area) {
  if (light.ring_end.size() != 1)
    return fmt::format("a polygon of {} outlines", light.ring_end.size());
  if (light.vertices.size() != 4)
    return fmt::format("a polygon of {} corners", light.vertices.size());
  Vec3d corner[4];
  for (std::size_t i = 0; i < 4; ++i)
    corner[i] = to_double(light.vertices[i]);
  // Counter-clockwise from the emitting side, so that the first edge runs along -x.
  const Vec3d x = (corner[0] - corner[1] + corner[3] - corner[2]) * 0.5;
  const Vec3d y = (corner[2] - corner[1] + corner[3] - corner[0]) * 0.5;
  const double size = std::max(length(x), length(y));
  const Vec3d skew = corner[0] + corner[2] - corner[1] - corner[3];
  if (!(length(skew) <= k_rounding * size) ||
      !(std::abs(dot(x, y)) <= k_rounding * length(x) * length(y)))
    return "a polygon of 4 corners that is no rectangle";
  area.center = (corner[0] + corner[1] + corner[2] + corner[3]) * 0.25;
  set_axes(area, x, y);
  return "";
}

std::string read(const light::EllipseLight& light, AreaLight& area) {
  const Vec3d u = to_double(light.half_u), v = to_double(light.half_v);
  if (!(std::abs(length(u) - length(v)) <= k_rounding * length(u))) return "an ellipse";
  area.is_disk = true;
  area.center = to_double(light.center);
  set_axes(area, u * -2.0, v * 2.0);
  return "";
}

std::string read(const light::SphereLight&, AreaLight&) { return "a sphere"; }
std::string read(const light::TubeLight&, AreaLight&) { return "a tube"; }
std::string read(const light::LineLight&, AreaLight&) { return "a line"; }

} // namespace

AreaLights area_lights_of(const light::Lights& lights) {
  AreaLights result;
  lights.for_each_area_light([&](const auto& light) {
    AreaLight area;
    area.name = light.name;
    area.radiance = light.radiance;
    area.surface_deviation = light.surface_deviation;
    std::string reason = read(light, area);
    if (reason.empty()) reason = obstacle(light);
    if (!reason.empty()) {
      result.refused.push_back(fmt::format("\"{}\": {}", quote(light.name), reason));
      return;
    }
    result.lights.push_back(area);
    if (!light.two_sided) return;
    area.x = -area.x; // the other side
    area.z = -area.z;
    result.lights.push_back(std::move(area));
  });
  for (const light::PunctualLight& light : lights.punctual)
    result.refused.push_back(fmt::format("\"{}\": a light without extent", quote(light.name)));
  return result;
}

} // namespace openltc::scene
