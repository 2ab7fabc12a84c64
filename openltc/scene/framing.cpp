// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/framing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace openltc::scene {

namespace {

constexpr double k_fov_rad = 35 * std::numbers::pi / 180; // a 57 mm lens on 24 x 36 mm
constexpr double k_azimuth_rad = 30 * std::numbers::pi / 180;
constexpr double k_elevation_rad = 20 * std::numbers::pi / 180;
constexpr double k_margin = 1.08; // empty rim around the scene

Vec3f to_float(Vec3d v) {
  return {float(v.x), float(v.y), float(v.z)};
}

} // namespace

Camera frame_scene(const Bounds& bounds, float aspect) {
  Vec3d lower(double(bounds.lower.x), double(bounds.lower.y), double(bounds.lower.z));
  Vec3d upper(double(bounds.upper.x), double(bounds.upper.y), double(bounds.upper.z));
  if (!(length(upper - lower) > 0)) {
    lower = lower - Vec3d(0.5, 0.5, 0.5);
    upper = upper + Vec3d(0.5, 0.5, 0.5);
  }
  const Vec3d center = (lower + upper) * 0.5;
  const double shape = aspect > 0 ? double(aspect) : 1;

  const Vec3d back(std::sin(k_azimuth_rad) * std::cos(k_elevation_rad), std::sin(k_elevation_rad),
                   std::cos(k_azimuth_rad) * std::cos(k_elevation_rad));
  const Vec3d right = normalize(cross(Vec3d(0, 1, 0), back));
  const Vec3d up = cross(back, right);

  // The angle belongs to the shorter side.
  const double tan_short = std::tan(0.5 * k_fov_rad);
  const double tan_y = shape >= 1 ? tan_short : tan_short / shape;
  const double tan_x = tan_y * shape;

  // A corner c is in view when |c_x| m <= tan_x (distance - c_back), likewise in y.
  double distance = 0, nearest = -1e300, farthest = 1e300;
  for (int i = 0; i < 8; ++i) {
    const Vec3d corner =
        Vec3d(i & 1 ? upper.x : lower.x, i & 2 ? upper.y : lower.y, i & 4 ? upper.z : lower.z) -
        center;
    const double towards = dot(corner, back);
    distance = std::max({distance, towards + k_margin * std::abs(dot(corner, right)) / tan_x,
                         towards + k_margin * std::abs(dot(corner, up)) / tan_y});
    nearest = std::max(nearest, towards);
    farthest = std::min(farthest, towards);
  }
  const double size = length(upper - lower);
  distance = std::max(distance, nearest + 0.05 * size);

  Camera camera;
  camera.name = "framed";
  camera.position = to_float(center + back * distance);
  camera.right = to_float(right);
  camera.up = to_float(up);
  camera.forward = to_float(-back);
  camera.fov_y_rad = float(2 * std::atan(tan_y));
  camera.near = float(0.5 * (distance - nearest));
  return camera;
}

} // namespace openltc::scene
