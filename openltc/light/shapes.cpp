// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/shapes.h"

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

EllipseLight ellipse(Vec3f center, Vec3f half_right, Vec3f half_up, Vec3f radiance) {
  EllipseLight light;
  light.center = center;
  light.half_u = half_right;
  light.half_v = half_up;
  light.radiance = radiance;
  return light;
}

} // namespace openltc::light
