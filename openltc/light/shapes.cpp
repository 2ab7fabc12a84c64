// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/shapes.h"

#include <cmath>
#include <numbers>

namespace openltc::light {

PolygonLight rectangle(Vec3f center, Vec3f half_right, Vec3f half_up, Vec3f radiance) {
  PolygonLight light;
  light.vertices = {center - half_right - half_up, center + half_right - half_up,
                    center + half_right + half_up, center - half_right + half_up};
  light.ring_end = {4};
  light.normal = normalize(cross(half_right, half_up));
  light.radiance = radiance;
  return light;
}

PolygonLight disk(Vec3f center, Vec3f right, Vec3f up, float radius, Vec3f radiance) {
  // Area of a regular n-gon of circumradius R: n/2 R^2 sin(2 pi/n). Equal to pi r^2 for this R.
  const double step = 2 * std::numbers::pi / k_disk_corners;
  const double circumradius =
      double(radius) * std::sqrt(2 * std::numbers::pi / (k_disk_corners * std::sin(step)));
  PolygonLight light;
  for (int i = 0; i < k_disk_corners; ++i) {
    const double angle_rad = (i + 0.5) * step;
    light.vertices.push_back(center + right * float(circumradius * std::cos(angle_rad)) +
                             up * float(circumradius * std::sin(angle_rad)));
  }
  light.ring_end = {std::uint32_t(k_disk_corners)};
  light.normal = normalize(cross(right, up));
  light.radiance = radiance;
  return light;
}

} // namespace openltc::light
