// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/framing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace openltc::scene {

namespace {

constexpr double k_fov_rad = 35 * std::numbers::pi / 180; // a 57 mm lens on 24 x 36 mm
constexpr double k_azimuth_rad = 30 * std::numbers::pi / 180;
constexpr double k_elevation_rad = 20 * std::numbers::pi / 180;
constexpr double k_margin = 1.08; // empty rim around the scene
// Depth over width from which a scene is no chart any more and gets the full three-quarter view.
constexpr double k_solid_depth = 0.3;

// The extents of points in a view, each widened by the view's opening at the point's depth.
struct Extent {
  Vec3d right, up, back; // of the camera
  double tan_x, tan_y;   // of half the opening, less the rim
  double left = -1e300, rightmost = -1e300, bottom = -1e300, top = -1e300;
  double nearest = -1e300;

  void add(Vec3d p) {
    const double x = dot(p, right), y = dot(p, up), towards = dot(p, back);
    rightmost = std::max(rightmost, x + tan_x * towards);
    left = std::max(left, -x + tan_x * towards);
    top = std::max(top, y + tan_y * towards);
    bottom = std::max(bottom, -y + tan_y * towards);
    nearest = std::max(nearest, towards);
  }
};

// Calls visit(add) to be given all points.
template <class Visit> Camera frame(Bounds bounds, float aspect, const Visit& visit) {
  const Vec3d size = to_double(bounds.upper) - to_double(bounds.lower);
  const double width = std::max(size.x, size.y);
  const double solid = width > 0 ? std::clamp(size.z / (k_solid_depth * width), 0.0, 1.0) : 1.0;
  const double azimuth = k_azimuth_rad * solid, elevation = k_elevation_rad * solid;

  Extent e;
  e.back = Vec3d(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                 std::cos(azimuth) * std::cos(elevation));
  e.right = normalize(cross(Vec3d(0, 1, 0), e.back));
  e.up = cross(e.back, e.right);
  // The angle belongs to the shorter side.
  const double shape = aspect > 0 ? double(aspect) : 1;
  const double tan_short = std::tan(0.5 * k_fov_rad);
  const double tan_y = shape >= 1 ? tan_short : tan_short / shape;
  e.tan_x = tan_y * shape / k_margin;
  e.tan_y = tan_y / k_margin;
  visit([&](Vec3f p) { e.add(to_double(p)); });

  // A point p is in view of a camera at (cx, cy, D) in these axes when
  //   |p_x - cx| <= tan_x (D - p_back), and likewise in y:
  // the right and left extents give cx where they balance, and D where both are just met.
  const double cx = 0.5 * (e.rightmost - e.left), cy = 0.5 * (e.top - e.bottom);
  double distance =
      std::max(0.5 * (e.rightmost + e.left) / e.tan_x, 0.5 * (e.top + e.bottom) / e.tan_y);
  distance = std::max(distance, e.nearest + 0.05 * length(size));

  Camera camera;
  camera.name = "framed";
  camera.position = to_float(e.right * cx + e.up * cy + e.back * distance);
  camera.right = to_float(e.right);
  camera.up = to_float(e.up);
  camera.forward = to_float(-e.back);
  camera.fov_y_rad = float(2 * std::atan(tan_y));
  camera.near = float(0.5 * (distance - e.nearest));
  return camera;
}

} // namespace

Camera frame_scene(const Bounds& given, float aspect) {
  Bounds bounds = given;
  if (!(length(bounds.upper - bounds.lower) > 0)) {
    bounds.lower = bounds.lower - Vec3f(0.5f);
    bounds.upper = bounds.upper + Vec3f(0.5f);
  }
  return frame(bounds, aspect, [&](const auto& add) {
    for (int i = 0; i < 8; ++i)
      add(Vec3f(i & 1 ? bounds.upper.x : bounds.lower.x, i & 2 ? bounds.upper.y : bounds.lower.y,
                i & 4 ? bounds.upper.z : bounds.lower.z));
  });
}

Camera frame_scene(const Scene& scene, float aspect) {
  if (!(length(scene.bounds.upper - scene.bounds.lower) > 0))
    return frame_scene(scene.bounds, aspect);
  return frame(scene.bounds, aspect, [&](const auto& add) {
    for (const Mesh& mesh : scene.meshes)
      for (const Vec3f& p : mesh.positions)
        add(p);
  });
}

} // namespace openltc::scene
